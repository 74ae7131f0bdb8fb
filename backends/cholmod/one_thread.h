// Runs CHOLMOD's loops and the BLAS below it only on the calling thread. Threads of an OpenMP library would outlive the call,
// and after fork() a child that uses them again would wait for ever. OpenBLAS ends the process if it gets no memory to share work
// out.
#pragma once

namespace rc_cholmod {

class OneThread {
 public:
  OneThread();
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int levels_ = 0, threads_ = 0;  // of OpenMP, which keeps them for each thread that calls
};

// Throws std::bad_alloc if OpenBLAS is the BLAS and the memory for its workspace is missing: it would ask for it for ever.
void require_blas_workspace();

}  // namespace rc_cholmod
