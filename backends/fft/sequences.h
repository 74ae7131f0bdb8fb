// Where the Fourier transforms take complex sequences from, and where they put them: `width` sequences side by side, element
// after element.
#pragma once

#include <algorithm>
#include <complex>
#include <cstdint>

#include "buffer.h"

namespace rc_fft {

// Sequences side by side, so many that their elements of one index fill two cache lines: a row.
template <class Real> inline constexpr std::int64_t width = alignment / static_cast<std::int64_t>(sizeof(std::complex<Real>));

// Reals in a row: the real parts of the sequences, then their imaginary parts.
template <class Real> inline constexpr std::int64_t row_size = 2 * width<Real>;

// Real sequences as as many complex ones.
template <class Real> inline constexpr std::int64_t most_lines = 2 * width<Real>;

template <class Real> alignas(alignment) inline constexpr Real zero_row[row_size<Real>] = {};

template <class Real> class Source {
 public:
  explicit Source(std::int64_t end) : end_(end) {}
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  virtual ~Source() = default;

  std::int64_t end() const { return end_; }  // rows from here on are zero
  // Addresses of `count` rows from `first` on, at most `width`. They hold until the next call with this `part`, 0 to 6.
  virtual void read(int part, std::int64_t first, std::int64_t count, const Real** rows) = 0;

 private:
  std::int64_t end_;
};

template <class Real> class Sink {
 public:
  explicit Sink(std::int64_t end) : end_(end) {}
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;
  virtual ~Sink() = default;

  std::int64_t end() const { return end_; }  // rows from here on are not wanted
  // Room for `count` rows from `first` on, at most `width`; and the word that it has been filled.
  virtual void room(int part, std::int64_t first, std::int64_t count, Real** rows) = 0;
  virtual void filled(int, std::int64_t, std::int64_t) {}

 private:
  std::int64_t end_;
};

// `count` rows in memory, `stride` reals apart.
template <class Real> class RowSource : public Source<Real> {
 public:
  RowSource(const Real* rows, std::int64_t stride, std::int64_t count) : Source<Real>(count), rows_(rows), stride_(stride) {}

  void read(int, std::int64_t first, std::int64_t count, const Real** rows) override {
    for (std::int64_t i = 0; i < count; ++i) rows[i] = first + i < this->end() ? rows_ + (first + i) * stride_ : zero_row<Real>;
  }

 private:
  const Real* rows_;
  std::int64_t stride_;
};

template <class Real> class RowSink : public Sink<Real> {
 public:
  // Rows that are not wanted go to `spare`.
  RowSink(Real* rows, std::int64_t stride, std::int64_t count, Real* spare)
      : Sink<Real>(count), rows_(rows), stride_(stride), spare_(spare) {}

  void room(int, std::int64_t first, std::int64_t count, Real** rows) override {
    for (std::int64_t i = 0; i < count; ++i) rows[i] = first + i < this->end() ? rows_ + (first + i) * stride_ : spare_;
  }

 private:
  Real* rows_;
  std::int64_t stride_;
  Real* spare_;
};

// Rows of sequences that are even: row i is row length - i as well.
template <class Real> class EvenSource : public Source<Real> {
 public:
  // Rows from `count` on are zero, up to half of the length.
  EvenSource(const Real* rows, std::int64_t stride, std::int64_t count, std::int64_t length)
      : Source<Real>(length), rows_(rows), stride_(stride), count_(count) {}

  void read(int, std::int64_t first, std::int64_t count, const Real** rows) override {
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t source = std::min(first + i, this->end() - first - i);
      rows[i] = source < count_ ? rows_ + source * stride_ : zero_row<Real>;
    }
  }

 private:
  const Real* rows_;
  std::int64_t stride_, count_;
};

}  // namespace rc_fft
