#include "one_thread.h"

#include <cstdlib>
#include <mutex>
#include <new>

// OpenMP's functions exist only if CHOLMOD or the BLAS is built with it, OpenBLAS' only if it is the BLAS.
extern "C" {
__attribute__((weak)) int omp_get_max_active_levels(void);
__attribute__((weak)) void omp_set_max_active_levels(int);
__attribute__((weak)) int omp_get_max_threads(void);
__attribute__((weak)) void omp_set_num_threads(int);
__attribute__((weak)) int openblas_get_parallel(void);
__attribute__((weak)) int openblas_get_num_threads(void);
__attribute__((weak)) void openblas_set_num_threads(int);
}

namespace rc_cholmod {

namespace {

bool has_openmp() { return omp_get_max_active_levels && omp_set_max_active_levels && omp_get_max_threads && omp_set_num_threads; }

// Whether OpenBLAS has threads of its own. Built with OpenMP, it asks that for their number.
bool blas_has_threads() {
  constexpr int own_threads = 1;
  return openblas_get_parallel && openblas_get_num_threads && openblas_set_num_threads && openblas_get_parallel() == own_threads;
}

// How many threads OpenBLAS uses is a setting of the process: the first to enter saves it, the last to leave restores it.
struct BlasThreads {
  std::mutex lock;
  int inside = 0, before = 0;
};
BlasThreads blas_threads;

}  // namespace

// OpenBLAS takes 128 MiB of addresses in its first call and ends the process if it gets none. Asked for here first, their lack is
// an error.
void require_blas_workspace() {
  constexpr std::size_t workspace = std::size_t{129} << 20;
  if (!openblas_get_parallel) return;
  void* volatile room = std::malloc(workspace);  // not to be left out by the compiler
  if (!room) throw std::bad_alloc();
  std::free(room);
}

OneThread::OneThread() {
  if (has_openmp()) {
    levels_ = omp_get_max_active_levels();
    threads_ = omp_get_max_threads();
    omp_set_max_active_levels(0);
    omp_set_num_threads(1);
  }
  if (!blas_has_threads()) return;
  const std::lock_guard hold(blas_threads.lock);
  if (blas_threads.inside++ > 0) return;
  blas_threads.before = openblas_get_num_threads();
  if (blas_threads.before != 1) openblas_set_num_threads(1);
}

OneThread::~OneThread() {
  if (has_openmp()) {
    omp_set_num_threads(threads_);
    omp_set_max_active_levels(levels_);
  }
  if (!blas_has_threads()) return;
  const std::lock_guard hold(blas_threads.lock);
  if (--blas_threads.inside == 0 && blas_threads.before != 1) openblas_set_num_threads(blas_threads.before);
}

}  // namespace rc_cholmod
