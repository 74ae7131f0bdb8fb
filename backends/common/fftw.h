// FFTW in both precisions under one name. Its planners are global to the process, so plans are made and destroyed under the
// host's "fftw" lock. It ends the process where it gets no memory: so there is a look for memory before plans are made, and no
// transform is in place, which would allocate.
#pragma once

#include <fftw3.h>

#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <roughcontact/plugin.hpp>
#include <type_traits>

namespace rc_common {

// Complex numbers are pairs of reals, given by a pointer to either.
template <class Real> struct Fftw;

#define RC_FFTW(Real, PREFIX)                                                                                           \
  template <> struct Fftw<Real> {                                                                                       \
    using Plan = PREFIX##_plan;                                                                                         \
    using Complex = PREFIX##_complex;                                                                                   \
    static Complex* pairs(auto* values) { return reinterpret_cast<Complex*>(values); }                                  \
    static Plan real_to_complex(int n, Real* in, auto* out, unsigned flags) {                                           \
      return PREFIX##_plan_dft_r2c_1d(n, in, pairs(out), flags);                                                        \
    }                                                                                                                   \
    static Plan complex_to_real(int n, auto* in, Real* out, unsigned flags) {                                           \
      return PREFIX##_plan_dft_c2r_1d(n, pairs(in), out, flags);                                                        \
    }                                                                                                                   \
    static Plan complex_to_complex(int n, auto* in, auto* out, int sign, unsigned flags) {                              \
      return PREFIX##_plan_dft_1d(n, pairs(in), pairs(out), sign, flags);                                               \
    }                                                                                                                   \
    static void run_real_to_complex(Plan plan, Real* in, auto* out) { PREFIX##_execute_dft_r2c(plan, in, pairs(out)); } \
    static void run_complex_to_real(Plan plan, auto* in, Real* out) { PREFIX##_execute_dft_c2r(plan, pairs(in), out); } \
    static void run_complex(Plan plan, auto* in, auto* out) { PREFIX##_execute_dft(plan, pairs(in), pairs(out)); }      \
    static void destroy(Plan plan) { PREFIX##_destroy_plan(plan); }                                                     \
    static void make_planner_thread_safe() { PREFIX##_make_planner_thread_safe(); }                                     \
    static int planner_threads() { return PREFIX##_planner_nthreads(); }                                                \
    static void plan_with_threads(int n) { PREFIX##_plan_with_nthreads(n); }                                            \
    static bool import_wisdom(const char* wisdom) { return PREFIX##_import_wisdom_from_string(wisdom) != 0; }           \
    static char* export_wisdom() { return PREFIX##_export_wisdom_to_string(); }                                         \
    static const char* version() { return PREFIX##_version; }                                                           \
  };
RC_FFTW(float, fftwf)
RC_FFTW(double, fftw)
#undef RC_FFTW

// While it lives, plans are made for one thread, whatever the host program has set. Its setting is restored.
template <class Real> class PlannerLock {
 public:
  explicit PlannerLock(const rc_host* host) : lock_(host, "fftw") {
    Fftw<Real>::make_planner_thread_safe();  // the host program may plan without our lock
    threads_ = Fftw<Real>::planner_threads();
    // Only where FFTW's threads are already in use: the first such call initialises them and drops all wisdom.
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

template <class Real> struct DestroyPlan {
  const rc_host* host = nullptr;  // null: it may be gone; FFTW's own lock, which PlannerLock has set up, is then enough
  void operator()(typename Fftw<Real>::Plan plan) const {
    std::optional<PlannerLock<Real>> lock;
    if (host) lock.emplace(host);
    Fftw<Real>::destroy(plan);
  }
};
template <class Real> using OwnedPlan = std::unique_ptr<std::remove_pointer_t<typename Fftw<Real>::Plan>, DestroyPlan<Real>>;

// Makes the plans of one transform, out of place, while it holds the lock. No plan may be destroyed meanwhile.
template <class Real> class Planner {
 public:
  // Throws if there is too little memory to plan lines of these lengths: it tries to allocate ten times what that takes.
  Planner(const rc_host* host, const roughcontact::Component& component, std::int64_t nx, std::int64_t ny)
      : host_(host), component_(component), nx_(nx), ny_(ny), lock_(host) {
    void* const block = ::operator new((std::size_t{4} << 20) + 256 * static_cast<std::size_t>(nx + ny), std::nothrow);
    ::operator delete(block);
    if (!block)
      roughcontact::fail(component_, RC_ERR_MEMORY, "cannot allocate the memory to plan a ", nx, "x", ny,
                         " transform; use a coarser grid");
  }

  OwnedPlan<Real> real_to_complex(std::int64_t n, Real* in, auto* out, unsigned flags) const {
    return made(Fftw<Real>::real_to_complex(static_cast<int>(n), in, out, flags));
  }
  OwnedPlan<Real> complex_to_real(std::int64_t n, auto* in, Real* out, unsigned flags) const {
    return made(Fftw<Real>::complex_to_real(static_cast<int>(n), in, out, flags));
  }
  OwnedPlan<Real> complex_to_complex(std::int64_t n, auto* in, auto* out, int sign, unsigned flags) const {
    return made(Fftw<Real>::complex_to_complex(static_cast<int>(n), in, out, sign, flags));
  }

 private:
  OwnedPlan<Real> made(typename Fftw<Real>::Plan plan) const {
    if (!plan)
      roughcontact::fail(component_, RC_ERR_INTERNAL, "FFTW made no plan for a ", nx_, "x", ny_,
                         " transform; check the FFTW installation");
    return {plan, {host_}};
  }

  const rc_host* host_;
  const roughcontact::Component& component_;
  std::int64_t nx_, ny_;
  PlannerLock<Real> lock_;
};

}  // namespace rc_common
