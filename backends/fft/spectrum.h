// Eigenvalues of the circular operator: real, because the kernel is even along both axes.
#pragma once

#include <roughcontact/plugin.hpp>

#include "buffer.h"
#include "fourier.h"
#include "lengths.h"

namespace rc_fft {

// Computed in double precision, in two steps. The rows are transformed along x into the workspace. The columns follow block by
// block when a transform takes the eigenvalues over; until then nothing else may use the workspace.
class Eigenvalues {
 public:
  // From the coefficients of a free system at offsets up to half the lengths, as far as its grid has them.
  static Eigenvalues free(const rc_host* host, const rc_operator_spec& spec, Lengths lengths, Workspace& workspace);
  // Likewise from the squares of the coefficients plus a constant. A periodic system's lengths must be its grid's.
  static Eigenvalues squares(const rc_host* host, const rc_operator_spec& spec, double constant, Lengths lengths,
                             Workspace& workspace);
  // From the symbol of a periodic system, whose grid has these lengths.
  static Eigenvalues periodic(const rc_host* host, const rc_operator_spec& spec, Lengths lengths, Workspace& workspace);

  static constexpr std::int64_t columns = row_size<double>;  // in a block
  std::int64_t blocks() const { return stride_ / columns; }

  // visit(rank, values) for the waves along y: columns block * columns and following, which are waves along x by rank.
  template <class Visit> void along_y(std::int64_t block, std::int64_t thread, const Visit& visit) const {
    const Fourier<double>& along = *axes_.y;
    if (!coefficients_) {
      for (std::int64_t k = 0; k < along.waves(); ++k) visit(along.rank(k), table() + k * stride_ + block * columns);
      return;
    }
    EvenSource<double> source(table() + block * columns, stride_, rows_, along.length());
    along.forward(source, scratch(thread));
    for (std::int64_t rank = 0; rank < along.waves(); ++rank)
      visit(rank, scratch(thread) + along.rows()[rank].row * row_size<double>);
  }

 private:
  Eigenvalues(const rc_operator_spec& spec, bool coefficients, Lengths lengths, Workspace& workspace);

  double* table() const { return workspace_.rows.data<double>(); }
  double* scratch(std::int64_t thread) const { return workspace_.scratch.data<double>() + thread * scratch_; }
  template <class Rows> void along_x(const rc_operator_spec& spec, const Rows& rows);

  Workspace& workspace_;
  Lengths lengths_;
  Axes<double> axes_;
  bool coefficients_;               // the table holds them, transformed along x; otherwise it holds the eigenvalues
  std::int64_t row_length_, rows_;  // of the coefficients that the circular operator takes
  std::int64_t stride_;             // of the table's rows
  std::int64_t scratch_;            // of a thread: of a transform, and coefficients of most_lines rows twice [reals]
};

}  // namespace rc_fft
