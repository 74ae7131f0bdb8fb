// Runs CHOLMOD's loops on the calling thread alone. Threads of an OpenMP library would outlive the call, and after fork() a child
// that uses them again would wait for ever.
#pragma once

// They exist only where CHOLMOD is built with OpenMP.
extern "C" {
__attribute__((weak)) int omp_get_max_active_levels(void);
__attribute__((weak)) void omp_set_max_active_levels(int);
}

namespace rc_cholmod {

// The setting is the calling thread's own.
class OneThread {
 public:
  OneThread() {
    if (!has_openmp()) return;
    levels_ = omp_get_max_active_levels();
    omp_set_max_active_levels(0);
  }
  ~OneThread() {
    if (has_openmp()) omp_set_max_active_levels(levels_);
  }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  static bool has_openmp() { return omp_get_max_active_levels && omp_set_max_active_levels; }

  int levels_ = 0;
};

}  // namespace rc_cholmod
