// Transforms by their lengths: those in use, and earlier ones as far as a memory limit allows.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "transform.h"

namespace rc_fft {

// The transforms of the same lengths in both precisions, each made for the first product that needs it.
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
  // limit: bytes that transforms may take that are not in use.
  explicit Cache(std::size_t limit) : limit_(limit) {}

  // Replaces the present transforms, which may be null, by ones that suit `needed`: see choose_lengths.
  void fit(std::unique_ptr<Transforms>& present, Lengths needed, Lengths largest);
  // Keeps them for later, as long as there is room.
  void retire(std::unique_ptr<Transforms>& present);

  // Afterwards lengths are chosen as if no transform had been made. Those that were made wait to be recalled; the first new one
  // trims them to a limit.
  void forget(std::unique_ptr<Transforms>& box, std::unique_ptr<Transforms>& grid);
  // The forgotten transform of exactly these lengths, or null: then the forgotten ones have been trimmed.
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
