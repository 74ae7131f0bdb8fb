#include "plan.h"

#include "common/planner_memory.h"

namespace rc_fft {

namespace {

template <class Real> class PlannerLock {
 public:
  explicit PlannerLock(const rc_host* host) : lock_(host, "fftw") {
    Fftw<Real>::make_planner_thread_safe();  // the host program may plan without our lock
    threads_ = Fftw<Real>::planner_threads();
    // Only where FFTW's threads are in use already: otherwise this call would initialise them and drop all wisdom.
    if (threads_ != 1) Fftw<Real>::plan_with_threads(1);
  }
  ~PlannerLock() {
    if (threads_ != 1) Fftw<Real>::plan_with_threads(threads_);
  }
  PlannerLock(const PlannerLock&) = delete;
  PlannerLock& operator=(const PlannerLock&) = delete;

 private:
  roughcontact::HostLock lock_;
  int threads_;
};

[[noreturn]] void no_plan(Lengths lengths) {
  fail(RC_ERR_INTERNAL, "FFTW made no plan for a ", lengths.x, "x", lengths.y, " transform; check the FFTW installation");
}

void require_planner_memory(Lengths lengths) {
  if (!rc_common::planner_has_memory(lengths.x + lengths.y))
    fail(RC_ERR_MEMORY, "cannot allocate what planning a ", lengths.x, "x", lengths.y, " transform takes; use a coarser grid");
}

template <class Real>
typename Fftw<Real>::Plan plan_line(int n, std::complex<Real>* in, std::complex<Real>* out, int sign, unsigned effort) {
  return Fftw<Real>::plan_complex(1, &n, 1, as_fftw(in), nullptr, 1, n, as_fftw(out), nullptr, 1, n, sign, effort);
}

template <class Real> std::complex<Real>* as_pairs(Real* line) { return reinterpret_cast<std::complex<Real>*>(line); }

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
      forward_x_ = plan_line(nx / 2, as_pairs(line), row, FFTW_FORWARD, effort | FFTW_PRESERVE_INPUT);
      backward_x_ = plan_line(nx / 2, row, as_pairs(line), FFTW_BACKWARD, effort | FFTW_DESTROY_INPUT);
    } else {
      forward_x_ = Fftw<Real>::plan_real(nx, line, as_fftw(row), effort | FFTW_PRESERVE_INPUT);
      backward_x_ = Fftw<Real>::plan_real_back(nx, as_fftw(row), line, effort | FFTW_DESTROY_INPUT);
    }
    if (!own_columns) {
      forward_y_ = plan_line(ny, column, waves, FFTW_FORWARD, effort | FFTW_DESTROY_INPUT);
      backward_y_ = plan_line(ny, waves, column, FFTW_BACKWARD, effort | FFTW_DESTROY_INPUT);
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
  if (!half_length_) return Fftw<Real>::execute_real(forward_x_, line, as_fftw(row));
  Fftw<Real>::execute_complex(forward_x_, as_fftw(as_pairs(line)), as_fftw(row));
  half_length_->to_real(row);
}

template <class Real> void Plans<Real>::row_to_line(std::complex<Real>* row, Real* line) const {
  if (!half_length_) return Fftw<Real>::execute_real_back(backward_x_, as_fftw(row), line);
  half_length_->from_real(row);
  Fftw<Real>::execute_complex(backward_x_, as_fftw(row), as_fftw(as_pairs(line)));
}

template <class Real> void Plans<Real>::destroy() {
  const PlannerLock<Real> lock(host_);
  for (Plan plan : {forward_x_, backward_x_, forward_y_, backward_y_})
    if (plan) Fftw<Real>::destroy(plan);
}

template class Plans<double>;
template class Plans<float>;

EvenPlans::EvenPlans(const rc_host* host, Lengths lengths, std::complex<double>* in, std::complex<double>* out) : host_(host) {
  const int nx = static_cast<int>(lengths.x), ny = static_cast<int>(lengths.y);
  require_planner_memory(lengths);
  {
    const PlannerLock<double> lock(host_);
    along_x_ = plan_line<double>(nx, in, out, FFTW_FORWARD, FFTW_ESTIMATE);
    along_y_ = plan_line<double>(ny, in, out, FFTW_FORWARD, FFTW_ESTIMATE);
  }
  if (along_x_ && along_y_) return;
  destroy();
  no_plan(lengths);
}

EvenPlans::~EvenPlans() { destroy(); }

void EvenPlans::destroy() {
  const PlannerLock<double> lock(host_);
  for (fftw_plan plan : {along_x_, along_y_})
    if (plan) fftw_destroy_plan(plan);
}

}  // namespace rc_fft
