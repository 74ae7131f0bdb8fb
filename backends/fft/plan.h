// FFTW plans of one transform.
#pragma once

#include <complex>
#include <optional>

#include "buffer.h"
#include "columns.h"
#include "common/fftw.h"
#include "half_length.h"
#include "planning.h"

namespace rc_fft {

using rc_common::Fftw, rc_common::OwnedPlan, rc_common::Planner;

// Single-threaded plans, executed on any arrays with the alignment of Buffer.
template <class Real> class Plans {
 public:
  // Planning may overwrite `line` (x reals), `row` (x/2+1 complex), `column` and `waves` (y complex each). Columns that FFTW does
  // not transform, since their length has small factors only, get no plan.
  Plans(const rc_host* host, Lengths lengths, Planning& planning, Real* line, std::complex<Real>* row, std::complex<Real>* column,
        std::complex<Real>* waves);

  // The factor by which a line grows on its way to a row and back.
  double gain() const { return half_length_ ? 2 * length_x_ : length_x_; }
  void line_to_row(Real* line, std::complex<Real>* row) const;
  void row_to_line(std::complex<Real>* row, Real* line) const;
  // Each destroys what it is given.
  void column_to_waves(std::complex<Real>* column, std::complex<Real>* waves) const {
    Fftw<Real>::run_complex(forward_y_.get(), column, waves);
  }
  void waves_to_column(std::complex<Real>* waves, std::complex<Real>* column) const {
    Fftw<Real>::run_complex(backward_y_.get(), waves, column);
  }

 private:
  double length_x_;
  std::optional<HalfLength<Real>> half_length_;  // where the length is even: plans along x are complex ones of half of it
  OwnedPlan<Real> forward_x_;                    // keeps its input
  OwnedPlan<Real> backward_x_;                   // destroys its input
  OwnedPlan<Real> forward_y_, backward_y_;       // destroy their input
};

}  // namespace rc_fft
