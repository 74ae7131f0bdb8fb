// FFTW in both precisions. Its planners are global to the process: plans are made and destroyed under the host's "fftw" lock. No
// transform is in place: then FFTW takes no memory while it transforms, where it would end the process if there is none.
#pragma once

#include <fftw3.h>

#include <cstdint>
#include <roughcontact/plugin.hpp>

namespace rc_split {

template <class T> struct Fftw;

#define RC_FFTW(T, PREFIX)                                                                                                     \
  template <> struct Fftw<T> {                                                                                                 \
    using Plan = PREFIX##_plan;                                                                                                \
    using Complex = PREFIX##_complex;                                                                                          \
    static void make_planner_thread_safe() { PREFIX##_make_planner_thread_safe(); }                                            \
    static int planner_threads() { return PREFIX##_planner_nthreads(); }                                                       \
    static void plan_with_threads(int n) { PREFIX##_plan_with_nthreads(n); }                                                   \
    static Plan real_to_complex(int n, T* in, T* out) { return PREFIX##_plan_dft_r2c_1d(n, in, complex(out), FFTW_ESTIMATE); } \
    static Plan complex_to_real(int n, T* in, T* out) { return PREFIX##_plan_dft_c2r_1d(n, complex(in), out, FFTW_ESTIMATE); } \
    static Plan complex_to_complex(int n, T* in, T* out, int sign) {                                                           \
      return PREFIX##_plan_dft_1d(n, complex(in), complex(out), sign, FFTW_ESTIMATE);                                          \
    }                                                                                                                          \
    static void run_real_to_complex(Plan plan, T* in, T* out) { PREFIX##_execute_dft_r2c(plan, in, complex(out)); }            \
    static void run_complex_to_real(Plan plan, T* in, T* out) { PREFIX##_execute_dft_c2r(plan, complex(in), out); }            \
    static void run_complex(Plan plan, T* in, T* out) { PREFIX##_execute_dft(plan, complex(in), complex(out)); }               \
    static Complex* complex(T* values) { return reinterpret_cast<Complex*>(values); }                                          \
    static void destroy(Plan plan) {                                                                                           \
      if (plan) PREFIX##_destroy_plan(plan);                                                                                   \
    }                                                                                                                          \
  };
RC_FFTW(float, fftwf)
RC_FFTW(double, fftw)
#undef RC_FFTW

template <class T> class PlannerLock {
 public:
  explicit PlannerLock(const rc_host* host) : lock_(host, "fftw") {
    Fftw<T>::make_planner_thread_safe();  // the host program may plan without our lock
    threads_ = Fftw<T>::planner_threads();
    // Only where FFTW's threads are in use already: otherwise this call would initialise them and drop all wisdom.
    if (threads_ != 1) Fftw<T>::plan_with_threads(1);
  }
  ~PlannerLock() {
    if (threads_ != 1) Fftw<T>::plan_with_threads(threads_);
  }
  PlannerLock(const PlannerLock&) = delete;
  PlannerLock& operator=(const PlannerLock&) = delete;

 private:
  roughcontact::HostLock lock_;
  int threads_;
};

}  // namespace rc_split
