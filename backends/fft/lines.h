// Real lines as complex sequences: line l < width is the real parts of sequence l, line width + l its imaginary parts.
#pragma once

#include <algorithm>
#include <cstdint>

#include "fourier.h"

namespace rc_fft {

// Rows of the first pass's parts, and of the last one's.
template <class Real> struct alignas(alignment) Tiles {
  static constexpr std::int64_t parts = 7;  // the largest radix
  Real* of(int part) { return rows[part]; }
  Real rows[parts][width<Real> * row_size<Real>];
};

// Lines that are null are zero, or not wanted.
template <class Real> class LineSource : public Source<Real> {
 public:
  // Lines have `length` elements and are zero from there on.
  LineSource(const Passes<Real>& passes, const Real* const* lines, std::int64_t length)
      : Source<Real>(length), passes_(passes), lines_(lines) {}

  void read(int part, std::int64_t first, std::int64_t count, const Real** rows) override {
    Real* const tile = tiles_.of(part);
    const std::int64_t given = std::clamp<std::int64_t>(this->end() - first, 0, count);
    for (std::int64_t line = 0; line < most_lines<Real>; ++line)
      if (lines_[line] && given > 0) __builtin_prefetch(lines_[line] + first + 2 * width<Real>, 0, 2);
    if (given == width<Real>)
      passes_.from_lines(lines_, first, tile);
    else
      for (std::int64_t line = 0; line < most_lines<Real>; ++line)
        for (std::int64_t i = 0; i < given; ++i)
          tile[i * row_size<Real> + line] = lines_[line] ? lines_[line][first + i] : Real{0};
    for (std::int64_t i = 0; i < count; ++i) rows[i] = i < given ? tile + i * row_size<Real> : zero_row<Real>;
  }

 private:
  const Passes<Real>& passes_;
  const Real* const* lines_;
  Tiles<Real> tiles_;
};

template <class Real> class LineSink : public Sink<Real> {
 public:
  LineSink(const Passes<Real>& passes, Real* const* lines, std::int64_t length)
      : Sink<Real>(length), passes_(passes), lines_(lines) {}

  void room(int part, std::int64_t, std::int64_t count, Real** rows) override {
    for (std::int64_t i = 0; i < count; ++i) rows[i] = tiles_.of(part) + i * row_size<Real>;
  }

  void filled(int part, std::int64_t first, std::int64_t count) override {
    const Real* const tile = tiles_.of(part);
    const std::int64_t wanted = std::min(this->end() - first, count);
    for (std::int64_t line = 0; line < most_lines<Real>; ++line)
      if (lines_[line] && wanted > 0) __builtin_prefetch(lines_[line] + first + 2 * width<Real>, 1, 2);
    if (wanted == width<Real>) return passes_.to_lines(tile, lines_, first);
    for (std::int64_t line = 0; line < most_lines<Real>; ++line)
      for (std::int64_t i = 0; lines_[line] && i < wanted; ++i) lines_[line][first + i] = tile[i * row_size<Real> + line];
  }

 private:
  const Passes<Real>& passes_;
  Real* const* lines_;
  Tiles<Real> tiles_;
};

}  // namespace rc_fft
