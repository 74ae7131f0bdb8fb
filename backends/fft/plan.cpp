#include "plan.h"

namespace rc_fft {

template <class Real>
Plans<Real>::Plans(const rc_host* host, Lengths lengths, Planning& planning, Real* line, std::complex<Real>* row,
                   std::complex<Real>* column, std::complex<Real>* waves)
    : length_x_(static_cast<double>(lengths.x)) {
  const auto [nx, ny] = lengths;
  if (nx % 2 == 0) half_length_.emplace(nx);
  const Planner<Real> planner(host, component, nx, ny);
  planning.recall<Real>();
  const unsigned keep = planning.effort() | FFTW_PRESERVE_INPUT, destroy = planning.effort() | FFTW_DESTROY_INPUT;
  if (half_length_) {
    forward_x_ = planner.complex_to_complex(nx / 2, line, row, FFTW_FORWARD, keep);
    backward_x_ = planner.complex_to_complex(nx / 2, row, line, FFTW_BACKWARD, destroy);
  } else {
    forward_x_ = planner.real_to_complex(nx, line, row, keep);
    backward_x_ = planner.complex_to_real(nx, row, line, destroy);
  }
  if (!has_small_factors(ny)) {
    forward_y_ = planner.complex_to_complex(ny, column, waves, FFTW_FORWARD, destroy);
    backward_y_ = planner.complex_to_complex(ny, waves, column, FFTW_BACKWARD, destroy);
  }
  planning.remember<Real>();
}

template <class Real> void Plans<Real>::line_to_row(Real* line, std::complex<Real>* row) const {
  if (!half_length_) return Fftw<Real>::run_real_to_complex(forward_x_.get(), line, row);
  Fftw<Real>::run_complex(forward_x_.get(), line, row);
  half_length_->to_real(row);
}

template <class Real> void Plans<Real>::row_to_line(std::complex<Real>* row, Real* line) const {
  if (!half_length_) return Fftw<Real>::run_complex_to_real(backward_x_.get(), row, line);
  half_length_->from_real(row);
  Fftw<Real>::run_complex(backward_x_.get(), row, line);
}

template class Plans<double>;
template class Plans<float>;

}  // namespace rc_fft
