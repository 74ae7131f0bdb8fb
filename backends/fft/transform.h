// y = H x between two sets of points of one frame, by a pruned circular convolution: only rows with sources are transformed
// forward, columns go through a scratch that stays in the cache, and only rows with targets are transformed back.
#pragma once

#include <complex>
#include <optional>
#include <roughcontact/plugin.hpp>

#include "buffer.h"
#include "columns.h"
#include "lengths.h"
#include "plan.h"
#include "points.h"
#include "spectrum.h"

namespace rc_fft {

// Sizes of the arrays of a transform.
template <class Real> struct Layout {
  explicit Layout(Lengths lengths);

  Lengths lengths;
  std::int64_t half_x, half_y;  // wave numbers 0..length/2 that determine the others
  std::int64_t row_stride;      // half_x complex values, rounded up to whole blocks [complex values]
  std::int64_t column;          // room for one column, where FFTW transforms it
  std::int64_t scratch;         // of a thread: a line, or a block of columns [complex values]

  std::int64_t blocks() const { return (half_x + columns_per_block<Real> - 1) / columns_per_block<Real>; }
};

template <class Real> class Transform {
 public:
  // Makes room for targets in `rows` rows; products with more rows enlarge it.
  Transform(const rc_host* host, Lengths lengths, std::int64_t rows, Planning& planning, Workspace& workspace,
            const rc_team& team);

  std::size_t bytes() const { return spectrum_.size(); }

  // Takes over eigenvalues of these lengths. To be called before the first product.
  void load(const Eigenvalues& source);
  template <class Other> void load(const Transform<Other>& source);
  void set_zero_mode(double eigenvalue) { *eigenvalues(0, 0) = static_cast<Real>(scale() * eigenvalue); }

  // The sources' box begins at (x0, y0) of the frame, the targets' at its origin. Outer: the vectors' precision.
  template <class Outer>
  void multiply(const Points& sources, std::int64_t x0, std::int64_t y0, const Outer* x, const Points& targets, Outer* y,
                const Conversion& convert = {});

 private:
  template <class Other> friend class Transform;
  using Complex = std::complex<Real>;
  static constexpr std::int64_t width = columns_per_block<Real>;

  void reserve(std::int64_t rows);
  Complex* row(std::int64_t i) const { return workspace_.rows.data<Complex>() + i * layout_.row_stride; }
  Complex* scratch(std::int64_t thread) const { return workspace_.scratch.data<Complex>() + thread * layout_.scratch; }
  Real* line(std::int64_t thread) const { return reinterpret_cast<Real*>(scratch(thread)); }
  double scale() const;
  // Eigenvalues of the wave ky along y and the columns of a block.
  Real* eigenvalues(std::int64_t block, std::int64_t ky) const {
    const std::int64_t place = own_columns_ ? own_columns_->rank(ky) : ky;
    return spectrum_.data<Real>() + (block * layout_.half_y + place) * width;
  }

  template <class Outer>
  void rows_forward(const Points& sources, std::int64_t x0, std::int64_t y0, const Outer* x, const Conversion& convert);
  void columns(std::int64_t y0, std::int64_t source_rows, std::int64_t target_rows);
  void columns_by_fftw(std::int64_t block, Complex* column, std::int64_t y0, std::int64_t source_rows, std::int64_t target_rows);
  template <class Outer> void rows_backward(const Points& targets, Outer* y, const Conversion& convert);

  Layout<Real> layout_;
  Workspace& workspace_;
  const rc_team& team_;
  bool parallel_;
  std::optional<Plans<Real>> plans_;
  std::optional<ColumnProduct<Real>> own_columns_;  // unless the length has large prime factors, where FFTW is better
  Buffer spectrum_;                                 // eigenvalues / (x y lengths), [block][wave along y][column of the block]
};

}  // namespace rc_fft
