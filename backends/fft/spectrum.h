// Eigenvalues of the circular operator: real, because the kernel is even along both axes.
#pragma once

#include <complex>
#include <memory>
#include <roughcontact/plugin.hpp>

#include "buffer.h"
#include "lengths.h"
#include "plan.h"

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

  static constexpr std::int64_t width = 16;  // columns in a block
  std::int64_t blocks() const { return stride_ / width; }

  // visit(ky, values) for the waves along y, `width` values each: columns block * width and following.
  template <class Visit> void along_y(std::int64_t block, std::int64_t thread, const Visit& visit) const {
    if (!plans_) {
      for (std::int64_t ky = 0; ky < half_y_; ++ky) visit(ky, table() + ky * stride_ + block * width);
      return;
    }
    transform_block(block, thread);
    for (std::int64_t ky = 0; ky < half_y_; ++ky) visit(ky, reinterpret_cast<const double*>(waves(thread)) + ky * width);
  }

 private:
  Eigenvalues(const rc_host* host, const rc_operator_spec& spec, Lengths lengths, Workspace& workspace);

  double* table() const { return workspace_.rows.data<double>(); }
  std::complex<double>* scratch(std::int64_t thread) const {
    return workspace_.scratch.data<std::complex<double>>() + thread * scratch_;
  }
  std::complex<double>* waves(std::int64_t thread) const { return scratch(thread) + 2 * line_; }
  template <class Rows> void along_x(const rc_operator_spec& spec, const Rows& rows);
  void transform_block(std::int64_t block, std::int64_t thread) const;

  const rc_host* host_;
  Workspace& workspace_;
  Lengths lengths_;
  std::int64_t half_x_, half_y_;
  std::int64_t columns_, rows_;             // coefficients that the circular operator takes
  std::int64_t stride_;                     // of the table's rows
  std::int64_t line_;                       // room for a line [complex values]
  std::int64_t scratch_;                    // of a thread: two lines, and coefficients or waves [complex values]
  std::unique_ptr<const EvenPlans> plans_;  // null: the table holds the eigenvalues
};

}  // namespace rc_fft
