// Transforms by their lengths: those in use, and earlier ones as far as a memory limit allows.
#pragma once

#include <cstddef>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "transform.h"

namespace rc_fft {

// The transforms of the same lengths in both precisions, each made for the first product that needs it.
struct Transforms {
  explicit Transforms(Lengths of) : lengths(of) {}
  template <class Real> std::unique_ptr<Transform<Real>>& in() { return std::get<std::unique_ptr<Transform<Real>>>(made); }
  std::size_t bytes() const {
    return std::apply([](const auto&... each) { return ((each ? each->bytes() : 0) + ...); }, made);
  }

  Lengths lengths;
  std::tuple<std::unique_ptr<Transform<double>>, std::unique_ptr<Transform<float>>> made;
};

class Cache {
 public:
  // limit: bytes that transforms may take that are not in use.
  Cache(std::size_t limit, Lengths period) : limit_(limit), period_(period) {}

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
    trim(forgotten_, most_forgotten);
    return nullptr;
  }

 private:
  static constexpr std::size_t most_forgotten = std::size_t{1} << 24;  // bytes
  using List = std::vector<std::unique_ptr<Transforms>>;               // in the order of their last use

  static void trim(List& list, std::size_t limit);
  void put_away(std::unique_ptr<Transforms> present);

  std::size_t limit_;
  Lengths period_;
  List idle_;
  List forgotten_;  // no two of the same lengths
};

}  // namespace rc_fft
