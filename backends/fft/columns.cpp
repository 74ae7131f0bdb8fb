#include "columns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "column_passes.h"

namespace rc_fft {

namespace {

// This many rows of 128 bytes stay in the first two levels of the cache. Longer transforms are split depth first, until their
// parts are no longer than that.
constexpr std::int64_t resident = 512;

// Radix 8 as often as possible, but 4 and 4 instead of 8 and 2.
std::vector<int> factors(std::int64_t length) {
  std::vector<int> result;
  int first = 1;
  if (length % 4 == 0)
    first = 4;
  else
    for (const int p : {7, 5, 3, 2})
      if (length % p == 0) first = p;
  result.push_back(first);
  length /= first;
  for (const int p : {7, 5, 3})
    for (; length % p == 0; length /= p) result.push_back(p);
  int twos = 0;
  for (; length % 2 == 0; length /= 2) ++twos;
  for (; twos % 3 != 0 && twos >= 2; twos -= 2) result.push_back(4);
  if (twos == 1) result.push_back(2);
  for (; twos >= 3; twos -= 3) result.push_back(8);
  if (result.size() == 1) result.push_back(1);
  return result;
}

template <class Real> auto passes_for_this_processor() {
  return RC_FOR_THIS_PROCESSOR((&multiply_columns<Real, 16>), &multiply_columns_avx2<Real>, &multiply_columns_avx512<Real>);
}

}  // namespace

bool has_small_factors(std::int64_t length) {
  for (const int p : {2, 3, 5, 7})
    while (length % p == 0) length /= p;
  return length == 1;
}

template <class Real>
ColumnProduct<Real>::ColumnProduct(std::int64_t length)
    : length_(length),
      radices_(factors(length)),
      waves_(static_cast<std::size_t>(length)),
      rank_(static_cast<std::size_t>(length / 2 + 1), -1),
      run_(passes_for_this_processor<Real>()) {
  // Twiddle factors exp(-2 pi i jq/L), 0 < q < radix, of each pass.
  std::int64_t part = length;
  for (const int radix : radices_) {
    offsets_.push_back(twiddles_.size());
    const double turn = -2 * std::numbers::pi / static_cast<double>(part);
    for (std::int64_t j = 0; j < part / radix && part > radix; ++j)
      for (int q = 1; q < radix; ++q) {
        twiddles_.push_back(static_cast<Real>(std::cos(turn * static_cast<double>(j * q))));
        twiddles_.push_back(static_cast<Real>(std::sin(turn * static_cast<double>(j * q))));
      }
    part /= radix;
  }
  // A pass leaves the waves k = q mod radix in its part q.
  std::int32_t next = 0;
  for (std::int64_t row = 0; row < length; ++row) {
    std::int64_t k = 0, weight = 1, rest = row;
    part = length;
    for (const int radix : radices_) {
      part /= radix;
      k += weight * (rest / part);
      rest %= part;
      weight *= radix;
    }
    std::int32_t& rank = rank_[static_cast<std::size_t>(std::min(k, length - k))];
    if (rank < 0) rank = next++;
    waves_[static_cast<std::size_t>(row)] = rank;
  }
  const std::int64_t first_part = length / radices_.front();
  for (std::int64_t row = 0; row < length; row += first_part) append(1, row, first_part);
}

template <class Real> void ColumnProduct<Real>::append(std::size_t level, std::int64_t row, std::int64_t length) {
  using Kind = typename Step::Kind;
  const std::size_t last = radices_.size() - 1;
  if (level < last && length > resident) {
    const int radix = radices_[level];
    steps_.push_back({Kind::forward, radix, row, length, 1, offsets_[level]});
    for (int q = 0; q < radix; ++q) append(level + 1, row + q * (length / radix), length / radix);
    steps_.push_back({Kind::backward, radix, row, length, 1, offsets_[level]});
    return;
  }
  std::int64_t part = length;
  std::size_t pass = level;
  for (; pass < last; part /= radices_[pass++])
    steps_.push_back({Kind::forward, radices_[pass], row, part, length / part, offsets_[pass]});
  steps_.push_back({Kind::product, radices_[last], row, part, length / part, 0});
  while (pass-- > level) {
    part *= radices_[pass];
    steps_.push_back({Kind::backward, radices_[pass], row, part, length / part, offsets_[pass]});
  }
}

template class ColumnProduct<double>;
template class ColumnProduct<float>;

}  // namespace rc_fft
