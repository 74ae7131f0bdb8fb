// Transforms by their lengths: those in use, and as many of those before as little memory holds.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "transform.h"

namespace rc_fft {

// Of the same lengths in both precisions, each made for the first product that needs it.
struct Transforms {
  explicit Transforms(Lengths of) : lengths(of) {}
  template <class Real> std::optional<Transform<Real>>& in() {
    if constexpr (std::is_same_v<Real, double>)
      return in_double;
    else
      return in_float;
  }
  std::size_t bytes() const { return (in_double ? in_double->bytes() : 0) + (in_float ? in_float->bytes() : 0); }

  Lengths lengths;
  std::optional<Transform<double>> in_double;
  std::optional<Transform<float>> in_float;
};

class Cache {
 public:
  // Transforms that are not in use may take so many bytes.
  explicit Cache(std::size_t limit) : limit_(limit) {}

  // Puts transforms for `needed` in the place of the present ones, which may be null: see choose_lengths.
  void fit(std::unique_ptr<Transforms>& present, Lengths needed, Lengths largest);
  // Keeps them for later, as long as there is room.
  void retire(std::unique_ptr<Transforms>& present);

 private:
  std::size_t limit_;
  std::vector<std::unique_ptr<Transforms>> idle_;  // in the order of their last use
};

}  // namespace rc_fft
