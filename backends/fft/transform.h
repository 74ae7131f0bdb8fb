// y = H x between two sets of points of one frame, by a pruned circular convolution: only rows with sources are transformed
// forward, columns go through a scratch that stays in the cache, and only rows with targets are transformed back.
#pragma once

#include <optional>
#include <roughcontact/plugin.hpp>

#include "buffer.h"
#include "lengths.h"
#include "plan.h"
#include "points.h"

namespace rc_fft {

// Columns that share the cache lines of a row.
inline constexpr std::int64_t columns_per_block = 8;

// Sizes of the arrays of a transform; strides in doubles.
struct Layout {
  explicit Layout(Lengths lengths);

  Lengths lengths;
  std::int64_t half_x, half_y;  // wave numbers 0..length/2 that determine the others
  std::int64_t row_stride;      // half_x complex values
  std::int64_t column_stride;   // lengths.y complex values
  std::int64_t scratch;         // a line with its transform, or a block of columns

  std::int64_t blocks() const { return (half_x + columns_per_block - 1) / columns_per_block; }
};

// Arrays that the transforms of one operator share.
struct Workspace {
  Buffer rows;
  Buffer scratch;  // one part per thread
};

class Transform {
 public:
  // Makes room for targets in `rows` rows; more is made when asked for.
  Transform(const rc_host* host, Lengths lengths, std::int64_t rows, unsigned effort, Workspace& workspace, const rc_team& team);

  Lengths lengths() const { return layout_.lengths; }

  // Eigenvalues from the coefficients at offsets up to half the lengths, as far as the system's grid has them.
  void load_free(const rc_host* host, const rc_operator_spec& spec);
  // Likewise from the squares of the coefficients plus a constant. A periodic system's transform must have its grid's lengths.
  void load_squares(const rc_host* host, const rc_operator_spec& spec, double constant);
  // Eigenvalues of a periodic system, whose grid has these lengths.
  void load_periodic(const rc_host* host, const rc_operator_spec& spec);
  void set_zero_mode(double eigenvalue);

  // The sources' box begins at (x0, y0) of the frame, the targets' at its origin.
  void multiply(const Points& sources, std::int64_t x0, std::int64_t y0, const double* x, const Points& targets, double* y);

 private:
  void reserve(std::int64_t rows);
  double* row(std::int64_t i) const { return workspace_.rows.data() + i * layout_.row_stride; }
  double* scratch(std::int64_t thread) const { return workspace_.scratch.data() + thread * layout_.scratch; }
  double* eigenvalues(std::int64_t column) const { return spectrum_.data() + column * layout_.half_y; }
  double scale() const;
  template <class Change> void load_coefficients(const rc_host* host, const rc_operator_spec& spec, const Change& change);

  void rows_forward(const Points& sources, std::int64_t x0, std::int64_t y0, const double* x);
  void columns(std::int64_t y0, std::int64_t source_rows, std::int64_t target_rows);
  void rows_backward(const Points& targets, double* y);

  Layout layout_;
  Workspace& workspace_;
  const rc_team& team_;
  bool parallel_;
  std::optional<Plans> plans_;
  Buffer spectrum_;  // eigenvalues / (x y lengths), [column][wave number along y]
};

}  // namespace rc_fft
