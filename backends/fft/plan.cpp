#include "plan.h"

namespace rc_fft {

namespace {

class PlannerLock {
 public:
  explicit PlannerLock(const rc_host* host) : lock_(host, "fftw") {
    fftw_make_planner_thread_safe();  // the host program may plan without our lock
    threads_ = fftw_planner_nthreads();
    // Only where FFTW's threads are in use already: otherwise this call would initialise them and drop all wisdom.
    if (threads_ != 1) fftw_plan_with_nthreads(1);
  }
  ~PlannerLock() {
    if (threads_ != 1) fftw_plan_with_nthreads(threads_);
  }
  PlannerLock(const PlannerLock&) = delete;
  PlannerLock& operator=(const PlannerLock&) = delete;

 private:
  roughcontact::HostLock lock_;
  int threads_;
};

}  // namespace

Plans::Plans(const rc_host* host, Lengths lengths, unsigned effort, double* line, double* row, double* column) : host_(host) {
  const int nx = static_cast<int>(lengths.x), ny = static_cast<int>(lengths.y);
  {
    const PlannerLock lock(host_);
    forward_x_ = fftw_plan_dft_r2c_1d(nx, line, as_complex(row), effort | FFTW_PRESERVE_INPUT);
    backward_x_ = fftw_plan_dft_c2r_1d(nx, as_complex(row), line, effort | FFTW_DESTROY_INPUT);
    forward_y_ = fftw_plan_dft_1d(ny, as_complex(column), as_complex(column), FFTW_FORWARD, effort);
    backward_y_ = fftw_plan_dft_1d(ny, as_complex(column), as_complex(column), FFTW_BACKWARD, effort);
  }
  if (!forward_x_ || !backward_x_ || !forward_y_ || !backward_y_) {
    destroy();
    fail(RC_ERR_INTERNAL, "FFTW made no plan for a ", nx, "x", ny, " transform; check the FFTW installation");
  }
}

Plans::~Plans() { destroy(); }

void Plans::destroy() {
  const PlannerLock lock(host_);
  for (fftw_plan plan : {forward_x_, backward_x_, forward_y_, backward_y_})
    if (plan) fftw_destroy_plan(plan);
}

}  // namespace rc_fft
