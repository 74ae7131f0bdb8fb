#include "split.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rc_fft {

namespace {

// Shorter ones take next to no time.
template <class Real> inline constexpr std::int64_t least_length = 8 * width<Real>;

// From one block of waves to the next.
template <class Real> inline constexpr std::int64_t block_stride = std::int64_t{most_lines<Real>} * row_size<Real>;

}  // namespace

// Element j of the parts of two lines: row l is the elements l m + j and following of both.
template <class Real> class Split<Real>::From : public Source<Real> {
 public:
  From(const Real* const* pair, std::int64_t given, std::int64_t part)
      : Source<Real>(std::min(width<Real>, (given + part - 1) / part)), lines_{pair[0], pair[1]}, given_(given), part_(part) {}

  void start_at(std::int64_t j) { j_ = j; }
  void read(int part, std::int64_t first, std::int64_t count, const Real** rows) override {
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t at = (first + i) * part_ + j_, there = std::clamp<std::int64_t>(given_ - at, 0, width<Real>);
      Real* to = tiles_.of(part) + i * row_size<Real>;
      rows[i] = to;
      for (const Real* line : lines_) {
        if (line && there == width<Real>) {
          std::copy_n(line + at, width<Real>, to);
        } else {
          std::fill_n(to, width<Real>, Real{0});
          if (line && there > 0) std::copy_n(line + at, there, to);
        }
        to += width<Real>;
      }
    }
  }

 private:
  const Real* lines_[2];
  std::int64_t given_, part_, j_ = 0;
  Tiles<Real> tiles_;
};

template <class Real> class Split<Real>::To : public Sink<Real> {
 public:
  To(Real* const* pair, std::int64_t wanted, std::int64_t part)
      : Sink<Real>(std::min(width<Real>, (wanted + part - 1) / part)), lines_{pair[0], pair[1]}, wanted_(wanted), part_(part) {}

  void start_at(std::int64_t j) { j_ = j; }
  void room(int part, std::int64_t, std::int64_t count, Real** rows) override {
    for (std::int64_t i = 0; i < count; ++i) rows[i] = tiles_.of(part) + i * row_size<Real>;
  }
  void filled(int part, std::int64_t first, std::int64_t count) override {
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t at = (first + i) * part_ + j_, count_here = std::min({width<Real>, part_ - j_, wanted_ - at});
      const Real* from = tiles_.of(part) + i * row_size<Real>;
      for (Real* line : lines_) {
        if (line && count_here > 0) std::copy_n(from, count_here, line + at);
        from += width<Real>;
      }
    }
  }

 private:
  Real* lines_[2];
  std::int64_t wanted_, part_, j_ = 0;
  Tiles<Real> tiles_;
};

template <class Real> bool Split<Real>::suits(Lengths lengths) {
  return lengths.y <= width<Real> && lengths.x >= least_length<Real> && lengths.x % width<Real> == 0 &&
         has_small_factors(lengths.x);
}

template <class Real>
Split<Real>::Split(std::int64_t length)
    : part_(length / width<Real>), across_(width<Real>), along_(part_), rows_(static_cast<std::size_t>(part_)) {
  for (std::int64_t k = 0; 2 * k <= part_; ++k) {
    const Mirrored& rows = along_.rows()[along_.rank(k)];
    if (k > 0) rows_[static_cast<std::size_t>(part_ - k)] = rows.mirror;
    rows_[static_cast<std::size_t>(k)] = rows.row;
  }
  turns_.resize(static_cast<std::size_t>(round_up(part_, width<Real>) * row_size<Real>));
  Real* to = turns_.data();
  for (std::int64_t j = 0; j < part_; j += width<Real>)
    for (std::int64_t q = 0; q < width<Real>; ++q, to += row_size<Real>)
      for (std::int64_t c = 0; c < width<Real>; ++c) {
        const double angle = -2 * std::numbers::pi / static_cast<double>(length) * static_cast<double>((j + c) * q);
        to[c] = static_cast<Real>(std::cos(angle));
        to[width<Real> + c] = static_cast<Real>(std::sin(angle));
      }
}

template <class Real> template <class Visit> void Split<Real>::for_each_sequence(const Visit& visit) const {
  for (std::int64_t q = 0; q < width<Real>; ++q) {
    const Mirrored& rows = across_.rows()[across_.rank(std::min(q, width<Real> - q))];
    visit(q, std::int64_t{2 * q <= width<Real> ? rows.row : rows.mirror});
  }
}

template <class Real> template <class Visit> void Split<Real>::for_each_wave(Real* scratch, const Visit& visit) const {
  for (std::int64_t k = 0; 2 * k <= part_; ++k) {
    Real* const at = row(scratch, k);
    visit(k, 0, at, row(scratch, (part_ - k) % part_));
    if (2 * k == part_) return;
    Real* const mirror = row(scratch, part_ - 1 - k) + width<Real>;
    const std::int64_t end = 2 * k + 1 == part_ ? width<Real> / 2 + 1 : width<Real>;
    for (std::int64_t q = 1; q < end; ++q) visit(k, q, at + q, mirror - q);
  }
}

template <class Real>
void Split<Real>::forward(const Real* const* pair, std::int64_t given, Real* scratch, Real* room, Real* spectra) const {
  constexpr std::int64_t im = width<Real>;
  Real* const few = scratch + Fourier<Real>::scratch_rows(part_) * row_size<Real>;
  From parts(pair, given, part_);
  const Real* turn = turns_.data();
  for (std::int64_t j = 0; j < part_; j += width<Real>) {
    const std::int64_t count = std::min(width<Real>, part_ - j);
    parts.start_at(j);
    across_.forward(parts, few);
    for_each_sequence([&](std::int64_t q, std::int64_t at) {
      const Real* const x = few + at * row_size<Real>;
      Real *const re = room + q * part_ + j, *const sine = re + im * part_;
      for (std::int64_t c = 0; c < count; ++c) {
        re[c] = x[c] * turn[c] - x[im + c] * turn[im + c];
        sine[c] = x[c] * turn[im + c] + x[im + c] * turn[c];
      }
      turn += row_size<Real>;
    });
  }
  const Real* lines[most_lines<Real>];
  for (std::int64_t l = 0; l < most_lines<Real>; ++l) lines[l] = room + l * part_;
  LineSource<Real> source(along_.passes(), lines, part_);
  along_.forward(source, scratch);
  for_each_wave(scratch, [&](std::int64_t k, std::int64_t q, const Real* z, const Real* mirror) {
    Real* const a = spectra + k * block_stride<Real> + q;
    a[0] = z[0] + mirror[0];
    a[im] = z[im] - mirror[im];
    a[row_size<Real>] = z[im] + mirror[im];
    a[row_size<Real> + im] = mirror[0] - z[0];
  });
}

template <class Real>
void Split<Real>::backward(const Real* spectra, bool both, Real* scratch, Real* room, Real* const* pair,
                           std::int64_t wanted) const {
  constexpr std::int64_t im = width<Real>;
  for_each_wave(scratch, [&](std::int64_t k, std::int64_t q, Real* z, Real* mirror) {
    const Real* const a = spectra + k * block_stride<Real> + q;
    const Real re = a[0], sine = a[im];
    const Real b_re = both ? a[row_size<Real>] : Real{0}, b_im = both ? a[row_size<Real> + im] : Real{0};
    // A wave that is its own mirrored one is real but for rounding.
    mirror[0] = re + b_im;
    mirror[im] = b_re - sine;
    z[0] = re - b_im;
    z[im] = b_re + sine;
  });
  Real* lines[most_lines<Real>];
  for (std::int64_t l = 0; l < most_lines<Real>; ++l) lines[l] = room + l * part_;
  LineSink<Real> sink(along_.passes(), lines, part_);
  along_.backward(scratch, sink);
  Real* const few = scratch + Fourier<Real>::scratch_rows(part_) * row_size<Real>;
  To parts(pair, wanted, part_);
  const Real* turn = turns_.data();
  for (std::int64_t j = 0; j < part_; j += width<Real>) {
    const std::int64_t count = std::min(width<Real>, part_ - j);
    for_each_sequence([&](std::int64_t q, std::int64_t at) {
      Real* const x = few + at * row_size<Real>;
      const Real *const re = room + q * part_ + j, *const sine = re + im * part_;
      for (std::int64_t c = 0; c < count; ++c) {
        x[c] = re[c] * turn[c] + sine[c] * turn[im + c];
        x[im + c] = sine[c] * turn[c] - re[c] * turn[im + c];
      }
      turn += row_size<Real>;
    });
    parts.start_at(j);
    across_.backward(few, parts);
  }
}

template class Split<double>;
template class Split<float>;

}  // namespace rc_fft
