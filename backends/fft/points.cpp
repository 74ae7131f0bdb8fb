#include "points.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>

namespace rc_fft {

Points::Points(const rc_domain& domain, const Box& box, std::int64_t grid_nx) : nx_(box.nx), ny_(box.ny) {
  if (domain.n == box.points()) return;
  begin_.resize(static_cast<std::size_t>(ny_) + 1);
  columns_.resize(static_cast<std::size_t>(domain.n));
  rc_common::for_each_point(domain, grid_nx, [&](std::int64_t i, std::int64_t column, std::int64_t row) {
    ++begin_[static_cast<std::size_t>(row - box.y) + 1];
    columns_[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(column - box.x);
  });
  for (std::size_t row = 1; row < begin_.size(); ++row) begin_[row] += begin_[row - 1];
}

template <class Real> bool Points::row_is_zero(std::int64_t row, const Real* x) const {
  using Bits = std::conditional_t<sizeof(Real) == sizeof(float), std::uint32_t, std::uint64_t>;
  constexpr std::int64_t together = 64;  // without a branch, so that they are compared side by side
  const Real* const end = x + begin(row + 1);
  for (x += begin(row); x + together <= end; x += together) {
    Bits any = 0;
    for (std::int64_t k = 0; k < together; ++k) any |= std::bit_cast<Bits>(x[k]) << 1;  // without the sign
    if (any) return false;
  }
  Bits any = 0;
  for (; x < end; ++x) any |= std::bit_cast<Bits>(*x) << 1;
  return any == 0;
}

template <class Outer, class Real>
void Points::scatter(std::int64_t row, const Outer* x, Real* line, const Conversion& convert) const {
  const std::int64_t first = begin(row), last = begin(row + 1);
  if (full()) {
    for (std::int64_t i = first; i < last; ++i) line[i - first] = convert.in<Real>(x[i]);
    return;
  }
  std::fill_n(line, nx_, convert.in<Real>(Outer{0}));
  for (std::int64_t i = first; i < last; ++i) line[columns_[static_cast<std::size_t>(i)]] = convert.in<Real>(x[i]);
}

template <class Real, class Outer>
void Points::gather(std::int64_t row, const Real* line, Outer* y, const Conversion& convert) const {
  const std::int64_t first = begin(row), last = begin(row + 1);
  if (full()) {
    for (std::int64_t i = first; i < last; ++i) y[i] = convert.out<Outer>(line[i - first]);
    return;
  }
  for (std::int64_t i = first; i < last; ++i) y[i] = convert.out<Outer>(line[columns_[static_cast<std::size_t>(i)]]);
}

template bool Points::row_is_zero(std::int64_t, const double*) const;
template bool Points::row_is_zero(std::int64_t, const float*) const;
template void Points::scatter(std::int64_t, const double*, double*, const Conversion&) const;
template void Points::scatter(std::int64_t, const float*, float*, const Conversion&) const;
template void Points::scatter(std::int64_t, const double*, float*, const Conversion&) const;
template void Points::gather(std::int64_t, const double*, double*, const Conversion&) const;
template void Points::gather(std::int64_t, const float*, float*, const Conversion&) const;
template void Points::gather(std::int64_t, const float*, double*, const Conversion&) const;

}  // namespace rc_fft
