// Circular products along y for a block of columns at a time: transformed, multiplied by the eigenvalues, transformed back.
// Columns lie side by side in the lanes of vector registers, so that no arithmetic crosses lanes. Waves are not sorted after the
// transform; the eigenvalues are kept in the transform's order.
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include "buffer.h"

namespace rc_fft {

// Columns of a block: as many complex numbers as fill two cache lines of a row.
template <class Real>
inline constexpr std::int64_t columns_per_block = alignment / static_cast<std::int64_t>(sizeof(std::complex<Real>));

// Whether a length has no prime factor above 7.
bool has_small_factors(std::int64_t length);

// Row i of the columns is at rows + i * stride.
template <class Real> struct ColumnBlock {
  std::complex<Real>* rows;
  std::int64_t stride;
  std::int64_t first_source, sources;  // rows that are read, the others are zero
  std::int64_t targets;                // rows from 0 on that are written
  const Real* eigenvalues;             // [rank of the wave][column]
  std::complex<Real>* scratch;         // ColumnProduct::scratch_rows(length) rows of columns_per_block
};

// For lengths with small factors.
template <class Real> class ColumnProduct {
 public:
  explicit ColumnProduct(std::int64_t length);

  static std::int64_t scratch_rows(std::int64_t length) { return length + 1; }
  // Place among the eigenvalues of the waves k and length - k, 0 <= k <= length/2. That of k = 0 is 0.
  std::int64_t rank(std::int64_t k) const { return rank_[static_cast<std::size_t>(k)]; }

  void multiply(const ColumnBlock<Real>& block) const { run_(*this, block); }

  // One pass over some rows of the scratch.
  struct Step {
    enum class Kind { forward, product, backward } kind;
    int radix;
    std::int64_t row, length, groups;  // groups of `length` rows from `row` on, each split into `radix` parts
    std::size_t twiddle;               // of the first twiddle factor
  };
  std::int64_t length() const { return length_; }
  int first_radix() const { return radices_.front(); }
  const Real* twiddles(std::size_t first) const { return twiddles_.data() + first; }
  const std::vector<Step>& steps() const { return steps_; }
  const std::int32_t* wave(std::int64_t row) const { return waves_.data() + row; }

 private:
  void append(std::size_t level, std::int64_t row, std::int64_t length);

  std::int64_t length_;
  std::vector<int> radices_;          // of all passes; the last has no twiddle factors
  std::vector<std::size_t> offsets_;  // of each pass's twiddle factors
  std::vector<Real> twiddles_;
  std::vector<Step> steps_;          // all but the first and the last pass, which read and write the columns themselves
  std::vector<std::int32_t> waves_;  // rank of the wave in each row of the scratch
  std::vector<std::int32_t> rank_;
  void (*run_)(const ColumnProduct&, const ColumnBlock<Real>&);
};

}  // namespace rc_fft
