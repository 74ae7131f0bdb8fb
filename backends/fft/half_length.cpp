#include "half_length.h"

#include <cmath>
#include <numbers>

#include "half_length_passes.h"

namespace rc_fft {

namespace {

template <class Real, bool Back> auto pass_for_this_processor() {
  return HalfLengthBuilds<Real>::template best<HalfLengthPass<Real, 16, Back>, HalfLengthPass<Real, 32, Back>,
                                               HalfLengthPass<Real, 64, Back>>();
}

}  // namespace

template <class Real>
HalfLength<Real>::HalfLength(std::int64_t length)
    : half_(length / 2), to_real_(pass_for_this_processor<Real, false>()), from_real_(pass_for_this_processor<Real, true>()) {
  const double turn = -2 * std::numbers::pi / static_cast<double>(length);
  for (std::int64_t k = 0; k <= half_ / 2; ++k) {
    re_.push_back(static_cast<Real>(std::sin(turn * static_cast<double>(k))));
    im_.push_back(static_cast<Real>(-std::cos(turn * static_cast<double>(k))));
  }
}

template class HalfLength<double>;
template class HalfLength<float>;

}  // namespace rc_fft
