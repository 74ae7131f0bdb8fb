// Transforms by their lengths: those in use, and as many of those before as little memory holds.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "transform.h"

namespace rc_fft {

// Of the same lengths in both precisions, each made for the first product that needs it.
struct Transforms {
  explicit Transforms(Lengths of) : lengths(of) {}
  template <class Real> std::unique_ptr<Transform<Real>>& in() {
    if constexpr (std::is_same_v<Real, double>)
      return in_double;
    else
      return in_float;
  }
  std::size_t bytes() const { return (in_double ? in_double->bytes() : 0) + (in_float ? in_float->bytes() : 0); }

  Lengths lengths;
  std::unique_ptr<Transform<double>> in_double;
  std::unique_ptr<Transform<float>> in_float;
};

class Cache {
 public:
  // Transforms that are not in use may take so many bytes.
  explicit Cache(std::size_t limit) : limit_(limit) {}

  // Puts transforms for `needed` in the place of the present ones, which may be null: see choose_lengths.
  void fit(std::unique_ptr<Transforms>& present, Lengths needed, Lengths largest);
  // Keeps them for later, as long as there is room.
  void retire(std::unique_ptr<Transforms>& present);

  // As if none had been made: lengths do not depend on those before. What was made waits to be recalled; within a limit, once
  // others are.
  void forget(std::unique_ptr<Transforms>& box, std::unique_ptr<Transforms>& grid);
  // The transform of just these lengths that was forgotten, or null: then there is room for a new one.
  template <class Real> std::unique_ptr<Transform<Real>> recalled(Lengths lengths) {
    for (const auto& each : forgotten_)
      if (each->lengths == lengths && each->in<Real>()) return std::move(each->in<Real>());
    trim_forgotten();
    return nullptr;
  }

 private:
  void put_away(std::unique_ptr<Transforms> present);
  void trim_forgotten();

  std::size_t limit_;
  std::vector<std::unique_ptr<Transforms>> idle_;       // in the order of their last use
  std::vector<std::unique_ptr<Transforms>> forgotten_;  // likewise; no two of the same lengths
};

}  // namespace rc_fft
