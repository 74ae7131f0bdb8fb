#include "cosines.h"

#include "aligned.h"
#include "common/fftw.h"
#include "common/planner_memory.h"
#include "failure.h"

namespace rc_split {

using rc_common::Fftw, rc_common::PlannerLock;

namespace {

// Complex transforms of lines of one length.
class Lines {
 public:
  Lines(const rc_host* host, std::int64_t threads, std::int64_t length)
      : host_(host), length_(length), stride_((2 * length + 15) / 16 * 16) {
    make_room(scratch_, 2 * threads * stride_);
    if (!rc_common::planner_has_memory(length))
      fail(RC_ERR_MEMORY, "cannot allocate the memory to plan a transform of ", length, " values");
    const PlannerLock<double> lock(host_);
    plan_ = Fftw<double>::complex_to_complex(static_cast<int>(length), in(0), out(0), FFTW_FORWARD, FFTW_ESTIMATE);
    if (!plan_) fail(RC_ERR_INTERNAL, "FFTW made no plan for ", length, " values; check the FFTW installation");
  }
  ~Lines() {
    const PlannerLock<double> lock(host_);
    Fftw<double>::destroy(plan_);
  }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  // Two even lines at once, one as real, the other as imaginary parts. Their transforms are real and do not mix. Line i is at
  // values + i * apart, its elements `step` apart.
  void transform(double* values, std::int64_t apart, std::int64_t step, bool two, std::int64_t thread) {
    double *const from = in(thread), *const to = out(thread);
    const std::int64_t half = length_ / 2;
    for (std::int64_t k = 0; k <= half; ++k) {
      const std::int64_t mirrored = k == 0 ? 0 : length_ - k;
      from[2 * k] = from[2 * mirrored] = values[k * step];
      from[2 * k + 1] = from[2 * mirrored + 1] = two ? values[apart + k * step] : 0;
    }
    Fftw<double>::run_complex(plan_, from, to);
    for (std::int64_t k = 0; k <= half; ++k) {
      values[k * step] = to[2 * k];
      if (two) values[apart + k * step] = to[2 * k + 1];
    }
  }

 private:
  double* in(std::int64_t thread) { return scratch_.data() + 2 * thread * stride_; }
  double* out(std::int64_t thread) { return in(thread) + stride_; }

  const rc_host* host_;
  std::int64_t length_, stride_;
  Array<double> scratch_;
  Fftw<double>::Plan plan_ = nullptr;
};

}  // namespace

void transform_even(const rc_host* host, const rc_team& team, std::int64_t nx, std::int64_t ny, double* table) {
  Lines along_x(host, team.threads, 2 * (nx - 1)), along_y(host, team.threads, 2 * (ny - 1));
  roughcontact::for_each(team, (ny + 1) / 2, true, [&](std::int64_t pair, std::int64_t thread) {
    along_x.transform(table + 2 * pair * nx, nx, 1, 2 * pair + 1 < ny, thread);
  });
  roughcontact::for_each(team, (nx + 1) / 2, true, [&](std::int64_t pair, std::int64_t thread) {
    along_y.transform(table + 2 * pair, 1, nx, 2 * pair + 1 < nx, thread);
  });
}

}  // namespace rc_split
