#include "plan.h"

#include "common/planner_memory.h"

namespace rc_fft {

namespace {

[[noreturn]] void no_plan(Lengths lengths) {
  fail(RC_ERR_INTERNAL, "FFTW made no plan for a ", lengths.x, "x", lengths.y, " transform; check the FFTW installation");
}

void require_planner_memory(Lengths lengths) {
  if (!rc_common::planner_has_memory(lengths.x + lengths.y))
    fail(RC_ERR_MEMORY, "cannot allocate the memory to plan a ", lengths.x, "x", lengths.y, " transform; use a coarser grid");
}

}  // namespace

template <class Real>
Plans<Real>::Plans(const rc_host* host, Lengths lengths, Planning& planning, Real* line, std::complex<Real>* row,
                   std::complex<Real>* column, std::complex<Real>* waves)
    : host_(host), length_x_(static_cast<double>(lengths.x)) {
  const int nx = static_cast<int>(lengths.x), ny = static_cast<int>(lengths.y);
  const bool own_columns = has_small_factors(lengths.y);
  if (nx % 2 == 0) half_length_.emplace(lengths.x);
  require_planner_memory(lengths);
  try {
    const PlannerLock<Real> lock(host_);
    planning.recall<Real>();
    const unsigned effort = planning.effort();
    if (half_length_) {
      forward_x_ = Fftw<Real>::complex_to_complex(nx / 2, line, row, FFTW_FORWARD, effort | FFTW_PRESERVE_INPUT);
      backward_x_ = Fftw<Real>::complex_to_complex(nx / 2, row, line, FFTW_BACKWARD, effort | FFTW_DESTROY_INPUT);
    } else {
      forward_x_ = Fftw<Real>::real_to_complex(nx, line, row, effort | FFTW_PRESERVE_INPUT);
      backward_x_ = Fftw<Real>::complex_to_real(nx, row, line, effort | FFTW_DESTROY_INPUT);
    }
    if (!own_columns) {
      forward_y_ = Fftw<Real>::complex_to_complex(ny, column, waves, FFTW_FORWARD, effort | FFTW_DESTROY_INPUT);
      backward_y_ = Fftw<Real>::complex_to_complex(ny, waves, column, FFTW_BACKWARD, effort | FFTW_DESTROY_INPUT);
    }
    planning.remember<Real>();
  } catch (...) {
    destroy();
    throw;
  }
  if (forward_x_ && backward_x_ && (own_columns || (forward_y_ && backward_y_))) return;
  destroy();
  no_plan(lengths);
}

template <class Real> Plans<Real>::~Plans() { destroy(); }

template <class Real> void Plans<Real>::line_to_row(Real* line, std::complex<Real>* row) const {
  if (!half_length_) return Fftw<Real>::run_real_to_complex(forward_x_, line, row);
  Fftw<Real>::run_complex(forward_x_, line, row);
  half_length_->to_real(row);
}

template <class Real> void Plans<Real>::row_to_line(std::complex<Real>* row, Real* line) const {
  if (!half_length_) return Fftw<Real>::run_complex_to_real(backward_x_, row, line);
  half_length_->from_real(row);
  Fftw<Real>::run_complex(backward_x_, row, line);
}

template <class Real> void Plans<Real>::destroy() {
  const PlannerLock<Real> lock(host_);
  for (Plan plan : {forward_x_, backward_x_, forward_y_, backward_y_}) Fftw<Real>::destroy(plan);
}

template class Plans<double>;
template class Plans<float>;

EvenPlans::EvenPlans(const rc_host* host, Lengths lengths, std::complex<double>* in, std::complex<double>* out) : host_(host) {
  const int nx = static_cast<int>(lengths.x), ny = static_cast<int>(lengths.y);
  require_planner_memory(lengths);
  {
    const PlannerLock<double> lock(host_);
    along_x_ = Fftw<double>::complex_to_complex(nx, in, out, FFTW_FORWARD, FFTW_ESTIMATE);
    along_y_ = Fftw<double>::complex_to_complex(ny, in, out, FFTW_FORWARD, FFTW_ESTIMATE);
  }
  if (along_x_ && along_y_) return;
  destroy();
  no_plan(lengths);
}

EvenPlans::~EvenPlans() { destroy(); }

void EvenPlans::destroy() {
  const PlannerLock<double> lock(host_);
  for (fftw_plan plan : {along_x_, along_y_}) Fftw<double>::destroy(plan);
}

}  // namespace rc_fft
