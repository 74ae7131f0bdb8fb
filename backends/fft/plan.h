// FFTW plans. FFTW's planner is global to the process: plans are made and destroyed under the host's "fftw" lock.
#pragma once

#include <fftw3.h>

#include "buffer.h"

namespace rc_fft {

inline fftw_complex* as_complex(double* p) { return reinterpret_cast<fftw_complex*>(p); }

// Single-threaded plans of one transform, executed on any arrays with the alignment of Buffer.
class Plans {
 public:
  // Planning may overwrite `line` (x doubles), `row` (x/2+1 complex) and `column` (y complex).
  Plans(const rc_host* host, Lengths lengths, unsigned effort, double* line, double* row, double* column);
  ~Plans();
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  void line_to_row(double* line, double* row) const { fftw_execute_dft_r2c(forward_x_, line, as_complex(row)); }
  void row_to_line(double* row, double* line) const { fftw_execute_dft_c2r(backward_x_, as_complex(row), line); }
  void forward(double* column) const { fftw_execute_dft(forward_y_, as_complex(column), as_complex(column)); }
  void backward(double* column) const { fftw_execute_dft(backward_y_, as_complex(column), as_complex(column)); }

 private:
  void destroy();

  const rc_host* host_;
  fftw_plan forward_x_ = nullptr;                         // real to complex, keeps its input
  fftw_plan backward_x_ = nullptr;                        // complex to real, destroys its input
  fftw_plan forward_y_ = nullptr, backward_y_ = nullptr;  // in place
};

}  // namespace rc_fft
