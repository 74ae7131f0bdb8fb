// C functions for bench/native.py: what must be compiled to be timed. Each returns null, or why it failed, which is valid until
// the thread's next call.
#include <cmath>
#include <functional>

#include "padded_product.h"

namespace {

using namespace bench;

template <class Real> double time_transform(std::int64_t length, std::int64_t repeats, std::int64_t threads, double budget) {
  struct Line {
    FftwArray<Real> data;
    typename Fftw<Real>::Plan plan = nullptr;
  };
  std::vector<Line> lines(static_cast<std::size_t>(threads));
  Fftw<Real>::init_threads();
  Fftw<Real>::plan_with_threads(1);
  for (Line& line : lines) {
    line.data.reset(Fftw<Real>::alloc_real(static_cast<std::size_t>(2 * length)));
    auto* const z = reinterpret_cast<typename Fftw<Real>::Complex*>(line.data.get());
    line.plan = Fftw<Real>::plan_complex(static_cast<int>(length), z, z, FFTW_FORWARD, FFTW_MEASURE);
    if (!line.plan) throw std::runtime_error("FFTW made no plan");
    std::fill_n(line.data.get(), 2 * length, Real{0});  // stays zero: values would grow beyond all bounds
  }
  const CallTimes times = time_calls(budget, [&] {
    in_parallel(threads, threads, [&](std::size_t t, std::int64_t, std::int64_t) {
      for (std::int64_t k = 0; k < repeats; ++k) Fftw<Real>::execute(lines[t].plan);
    });
  });
  for (Line& line : lines) Fftw<Real>::destroy(line.plan);
  return times.best;
}

// A padded product whose precision the caller of the C functions does not see.
struct AnyProduct {
  double planning_seconds = 0;
  std::function<CallTimes(std::int64_t points, const double* x, double budget, double* y)> time;
};

template <class Real> AnyProduct* any_product(std::int64_t n, std::int64_t threads, unsigned effort, double limit) {
  const auto product = std::make_shared<PaddedProduct<Real>>(n, threads, effort, limit);
  return new AnyProduct{product->planning_seconds(), [product](std::int64_t points, const double* x, double budget, double* y) {
                          const std::vector<Real> given(x, x + points);
                          std::vector<Real> found(given.size());
                          const CallTimes times = time_calls(budget, [&] { product->multiply(given.data(), found.data()); });
                          std::copy(found.begin(), found.end(), y);
                          return times;
                        }};
}

}  // namespace

extern "C" {

// compiler, build type, flags and FFTW, a line each
const char* bench_build() {
  static const std::string text = std::string(RC_BENCH_BUILD) + fftw_version;
  return text.c_str();
}

const char* bench_padded_create(std::int64_t n, std::int64_t threads, std::int64_t measure, double limit, std::int64_t single,
                                void** out, double* planning) {
  return guarded([&] {
    const unsigned effort = measure ? FFTW_MEASURE : FFTW_ESTIMATE;
    AnyProduct* const made =
        single ? any_product<float>(n, threads, effort, limit) : any_product<double>(n, threads, effort, limit);
    *planning = made->planning_seconds;
    *out = made;
  });
}

// x and y: [points]; times: best and median
const char* bench_padded_time(void* product, std::int64_t points, const double* x, double budget, double* times, double* y) {
  return guarded([&] {
    const CallTimes calls = static_cast<AnyProduct*>(product)->time(points, x, budget, y);
    times[0] = calls.best;
    times[1] = calls.median;
  });
}

// Seconds of a = b + s c with n values.
const char* bench_time_triad(std::int64_t n, std::int64_t threads, double budget, double* seconds) {
  return guarded([&] {
    const auto array = [n] { return std::unique_ptr<double[]>(new double[static_cast<std::size_t>(n)]); };
    const std::unique_ptr<double[]> a = array(), b = array(), c = array();
    in_parallel(n, threads, [&](std::size_t, std::int64_t first, std::int64_t last) {
      std::fill(a.get() + first, a.get() + last, 0.0);
      std::fill(b.get() + first, b.get() + last, 1.0);
      std::fill(c.get() + first, c.get() + last, 2.0);
    });
    *seconds =
        time_calls(budget, [&] {
          in_parallel(n, threads, [x = a.get(), y = b.get(), z = c.get()](std::size_t, std::int64_t first, std::int64_t last) {
            for (std::int64_t i = first; i < last; ++i) x[i] = y[i] + 3 * z[i];
          });
        }).best;
  });
}

// Seconds of `repeats` complex transforms on every thread, each on one line in the cache.
const char* bench_time_transform(std::int64_t length, std::int64_t repeats, std::int64_t threads, double budget,
                                 std::int64_t single, double* seconds) {
  return guarded([&] { *seconds = (single ? time_transform<float> : time_transform<double>)(length, repeats, threads, budget); });
}

}  // extern "C"
