// FFTW plans. FFTW's planner is global to the process: plans are made and destroyed under the host's "fftw" lock.
#pragma once

#include <complex>
#include <optional>

#include "buffer.h"
#include "columns.h"
#include "common/fftw.h"
#include "half_length.h"
#include "planning.h"

namespace rc_fft {

using rc_common::Fftw, rc_common::PlannerLock;

// Single-threaded plans of one transform, executed on any arrays with the alignment of Buffer.
template <class Real> class Plans {
 public:
  // Planning may overwrite `line` (x reals), `row` (x/2+1 complex), `column` and `waves` (y complex each). Columns that FFTW does
  // not transform, since their length has small factors only, get no plan. No plan is in place, see EvenPlans.
  Plans(const rc_host* host, Lengths lengths, Planning& planning, Real* line, std::complex<Real>* row, std::complex<Real>* column,
        std::complex<Real>* waves);
  ~Plans();
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  // The factor by which a line grows on its way to a row and back.
  double gain() const { return half_length_ ? 2 * length_x_ : length_x_; }
  void line_to_row(Real* line, std::complex<Real>* row) const;
  void row_to_line(std::complex<Real>* row, Real* line) const;
  // Each destroys what it is given.
  void column_to_waves(std::complex<Real>* column, std::complex<Real>* waves) const {
    Fftw<Real>::run_complex(forward_y_, column, waves);
  }
  void waves_to_column(std::complex<Real>* waves, std::complex<Real>* column) const {
    Fftw<Real>::run_complex(backward_y_, waves, column);
  }

 private:
  using Plan = typename Fftw<Real>::Plan;

  void destroy();

  const rc_host* host_;
  double length_x_;
  std::optional<HalfLength<Real>> half_length_;      // where the length is even: plans along x are complex ones of half of it
  Plan forward_x_ = nullptr;                         // keeps its input
  Plan backward_x_ = nullptr;                        // destroys its input
  Plan forward_y_ = nullptr, backward_y_ = nullptr;  // destroy their input
};

// The transforms in which the eigenvalues of even kernels are computed: lines in double precision, complex, forward. Not in
// place: then FFTW takes no memory while it transforms.
class EvenPlans {
 public:
  // Planning may overwrite `in` and `out`, which have room for the longer line.
  EvenPlans(const rc_host* host, Lengths lengths, std::complex<double>* in, std::complex<double>* out);
  ~EvenPlans();
  EvenPlans(const EvenPlans&) = delete;
  EvenPlans& operator=(const EvenPlans&) = delete;

  void along_x(std::complex<double>* in, std::complex<double>* out) const { Fftw<double>::run_complex(along_x_, in, out); }
  void along_y(std::complex<double>* in, std::complex<double>* out) const { Fftw<double>::run_complex(along_y_, in, out); }

 private:
  void destroy();

  const rc_host* host_;
  Fftw<double>::Plan along_x_ = nullptr, along_y_ = nullptr;
};

}  // namespace rc_fft
