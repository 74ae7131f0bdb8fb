#include "fourier.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lengths.h"

namespace rc_fft {

namespace {

// This many rows of 128 bytes stay in the first two levels of the cache. Longer transforms are split depth first, until their
// parts are no longer than that.
constexpr std::int64_t resident = 512;

// The length of the circular convolution that transforms another length, see Chirp.
std::int64_t convolution_length(std::int64_t length) { return fast_length(2 * length - 1); }

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

template <class Real> void append_root(std::vector<Real>& roots, double angle) {
  roots.push_back(static_cast<Real>(std::cos(angle)));
  roots.push_back(static_cast<Real>(std::sin(angle)));
}

// Multiplies a row by a complex factor; i times the conjugate complex of the row if it is to be exchanged.
template <bool Exchanged, class Real> void scale(const Real* from, const Real* factor, Real* to) {
  for (std::int64_t c = 0; c < width<Real>; ++c) {
    const Real re = from[Exchanged ? width<Real> + c : c], im = from[Exchanged ? c : width<Real> + c];
    to[c] = re * factor[0] - im * factor[1];
    to[width<Real> + c] = re * factor[1] + im * factor[0];
  }
}

}  // namespace

// A transform of any length n as a circular convolution of a length with small factors (Bluestein 1970): with the chirp
// c[j] = exp(-pi i j^2/n), wave k is c[k] times the sum over j of (x[j] c[j]) c*[k - j], * for the conjugate complex.
template <class Real> struct Fourier<Real>::Chirp {
  Chirp(std::int64_t n, rc_common::Vectors vectors) : convolution(convolution_length(n), vectors) {
    const std::int64_t length = convolution.length();
    const Fourier<double> exact(length, vectors);
    Buffer buffer;
    buffer.reserve<double>(n + Fourier<double>::scratch_rows(length), row_size<double>, {length, 1});
    double *const conjugate = buffer.data<double>(), *const scratch = conjugate + n * row_size<double>;
    std::fill_n(conjugate, n * row_size<double>, 0.0);
    for (std::int64_t j = 0; j < n; ++j) {
      const double angle = std::numbers::pi * static_cast<double>(j * j % (2 * n)) / static_cast<double>(n);
      append_root(factors, -angle);
      conjugate[j * row_size<double>] = std::cos(angle);
      conjugate[j * row_size<double> + width<double>] = std::sin(angle);
    }
    EvenSource<double> even(conjugate, row_size<double>, n, length);
    exact.forward(even, scratch);
    for (std::int64_t rank = 0; rank < exact.waves(); ++rank)
      for (const std::int64_t part : {std::int64_t{0}, width<double>})
        spectrum.push_back(
            static_cast<Real>(scratch[exact.rows()[rank].row * row_size<double> + part] / static_cast<double>(length)));
  }

  Fourier convolution;
  std::vector<Real> factors;   // the chirp; complex
  std::vector<Real> spectrum;  // of its conjugate complex, over the length; complex, by rank
};

template <class Real> Fourier<Real>::~Fourier() = default;

template <class Real>
Fourier<Real>::Fourier(std::int64_t length, rc_common::Vectors vectors) : rank_(static_cast<std::size_t>(length / 2 + 1), -1) {
  plan_.length = length;
  plan_.passes = &Passes<Real>::of(vectors);
  const bool small_factors = has_small_factors(length);
  if (small_factors) {
    plan_.radices = factors(length);
    set_up_passes();
  } else {
    chirp_ = std::make_unique<const Chirp>(length, vectors);
  }
  // A pass leaves the waves k = q mod radix in its part q.
  for (std::int64_t row = 0; row < length; ++row) {
    std::int64_t k = small_factors ? 0 : row, weight = 1, rest = row, part = length;
    for (const int radix : plan_.radices) {
      part /= radix;
      k += weight * (rest / part);
      rest %= part;
      weight *= radix;
    }
    std::int32_t& rank = rank_[static_cast<std::size_t>(std::min(k, length - k))];
    if (rank < 0) {
      rank = static_cast<std::int32_t>(rows_.size());
      rows_.emplace_back();
    }
    Mirrored& rows = rows_[static_cast<std::size_t>(rank)];
    if (2 * k <= length) rows.row = static_cast<std::int32_t>(row);
    if (2 * k >= length || k == 0) rows.mirror = static_cast<std::int32_t>(row);
    plan_.waves.push_back(rank);
  }
  rows_.resize(static_cast<std::size_t>(round_up(waves(), width<Real>)));
}

template <class Real> void Fourier<Real>::set_up_passes() {
  // Twiddle factors exp(-2 pi i jq/L), 0 < q < radix, of each pass.
  std::int64_t part = plan_.length;
  for (const int radix : plan_.radices) {
    offsets_.push_back(plan_.twiddles.size());
    const double turn = -2 * std::numbers::pi / static_cast<double>(part);
    for (std::int64_t j = 0; j < part / radix && part > radix; ++j)
      for (int q = 1; q < radix; ++q) append_root(plan_.twiddles, turn * static_cast<double>(j * q));
    part /= radix;
  }
  const std::int64_t first_part = plan_.length / plan_.radices.front();
  for (std::int64_t row = 0; row < plan_.length; row += first_part) append(1, row, first_part);
}

template <class Real> void Fourier<Real>::append(std::size_t level, std::int64_t row, std::int64_t length) {
  using Kind = Step::Kind;
  std::vector<Step>& steps = plan_.steps;
  const std::vector<int>& radices = plan_.radices;
  const std::size_t last = radices.size() - 1;
  if (level < last && length > resident) {
    const int radix = radices[level];
    steps.push_back({Kind::forward, radix, row, length, 1, offsets_[level]});
    for (int q = 0; q < radix; ++q) append(level + 1, row + q * (length / radix), length / radix);
    steps.push_back({Kind::backward, radix, row, length, 1, offsets_[level]});
    return;
  }
  std::int64_t part = length;
  std::size_t pass = level;
  for (; pass < last; part /= radices[pass++])
    steps.push_back({Kind::forward, radices[pass], row, part, length / part, offsets_[pass]});
  steps.push_back({Kind::last, radices[last], row, part, length / part, 0});
  while (pass-- > level) {
    part *= radices[pass];
    steps.push_back({Kind::backward, radices[pass], row, part, length / part, offsets_[pass]});
  }
}

template <class Real> std::int64_t Fourier<Real>::scratch_rows(std::int64_t length) {
  return length + (has_small_factors(length) ? 0 : convolution_length(length)) + 1;
}

// Forward and backward are the same but for an exchange.
template <class Real> template <bool Exchanged> void Fourier<Real>::convolve(Real* rows) const {
  const std::int64_t n = plan_.length;
  const Real* const factors = chirp_->factors.data();
  Real* const scratch = rows + n * row_size<Real>;
  for (std::int64_t j = 0; j < n; ++j) scale<Exchanged>(rows + j * row_size<Real>, factors + 2 * j, rows + j * row_size<Real>);
  RowSource<Real> from(rows, row_size<Real>, n);
  RowSink<Real> to(rows, row_size<Real>, n, scratch + chirp_->convolution.plan_.length * row_size<Real>);
  chirp_->convolution.multiply_by({nullptr, chirp_->spectrum.data()}, from, scratch, to);
  for (std::int64_t k = 0; k < n; ++k) scale<false>(rows + k * row_size<Real>, factors + 2 * k, rows + k * row_size<Real>);
}

template <class Real> void Fourier<Real>::forward(Source<Real>& x, Real* scratch) const {
  if (!chirp_) {
    plan_.passes->first(plan_, x, scratch);
    plan_.passes->inner(plan_, Way::forward, {}, scratch);
    return;
  }
  const Real* from[width<Real>];
  for (std::int64_t first = 0; first < plan_.length; first += width<Real>) {
    const std::int64_t count = std::min(width<Real>, plan_.length - first);
    x.read(0, first, count, from);
    for (std::int64_t i = 0; i < count; ++i) std::copy_n(from[i], row_size<Real>, scratch + (first + i) * row_size<Real>);
  }
  convolve<false>(scratch);
}

template <class Real> void Fourier<Real>::backward(Real* scratch, Sink<Real>& y) const {
  if (!chirp_) {
    plan_.passes->inner(plan_, Way::backward, {}, scratch);
    plan_.passes->last(plan_, scratch, y);
    return;
  }
  convolve<true>(scratch);
  constexpr Real one[] = {1, 0};
  Real* to[width<Real>];
  for (std::int64_t first = 0; first < y.end(); first += width<Real>) {
    const std::int64_t count = std::min(width<Real>, y.end() - first);
    y.room(0, first, count, to);
    for (std::int64_t i = 0; i < count; ++i) scale<true>(scratch + (first + i) * row_size<Real>, one, to[i]);
    y.filled(0, first, count);
  }
}

template <class Real> void Fourier<Real>::multiply(Source<Real>& x, const Real* eigenvalues, Real* scratch, Sink<Real>& y) const {
  if (!chirp_) return multiply_by({eigenvalues, nullptr}, x, scratch, y);
  forward(x, scratch);
  for (std::int64_t row = 0; row < plan_.length; ++row) {
    const Real* const by = eigenvalues + plan_.waves[static_cast<std::size_t>(row)] * width<Real>;
    Real* const at = scratch + row * row_size<Real>;
    for (std::int64_t c = 0; c < row_size<Real>; ++c) at[c] *= by[c % width<Real>];
  }
  backward(scratch, y);
}

template <class Real>
void Fourier<Real>::multiply_by(const Factors<Real>& factors, Source<Real>& x, Real* scratch, Sink<Real>& y) const {
  plan_.passes->first(plan_, x, scratch);
  plan_.passes->inner(plan_, Way::there_and_back, factors, scratch);
  plan_.passes->last(plan_, scratch, y);
}

template class Fourier<double>;
template class Fourier<float>;

}  // namespace rc_fft
