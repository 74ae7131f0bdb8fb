// C functions for bench/native.py: what must be compiled to be timed, and the readers of surface files. Each returns null, or why
// it failed, which is valid until the thread's next call.
#include <roughcontact/roughcontact.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <thread>

#include "formats/surface.h"
#include "guarded.h"
#include "padded_product.h"

namespace {

using namespace bench;

// work(thread) on all of them at once.
template <class Work> void on_threads(int threads, const Work& work) {
  std::vector<std::jthread> helpers;
  for (int t = 1; t < threads; ++t) helpers.emplace_back([&, t] { work(t); });
  work(0);
}

template <class Real> double time_transform(std::int64_t length, std::int64_t repeats, int threads, double budget) {
  struct Line {
    std::unique_ptr<Real[], void (*)(void*)> data{nullptr, fftw_free};
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
    on_threads(threads, [&](int t) {
      for (std::int64_t k = 0; k < repeats; ++k) Fftw<Real>::execute(lines[static_cast<std::size_t>(t)].plan);
    });
  });
  for (Line& line : lines) Fftw<Real>::destroy(line.plan);
  return times.best;
}

struct Padded {
  std::unique_ptr<PaddedProductIn<double>> in_double;
  std::unique_ptr<PaddedProductIn<float>> in_single;
};

}  // namespace

extern "C" {

// commit, compiler, build type, flags and FFTW, a line each
const char* bench_build() {
  static const std::string text = std::string(RC_BENCH_BUILD) + fftw_version;
  return text.c_str();
}

const char* bench_padded_create(std::int64_t n, int threads, int measure, double limit, int single, void** out,
                                double* planning) {
  return guarded([&] {
    auto padded = std::make_unique<Padded>();
    const unsigned effort = measure ? FFTW_MEASURE : FFTW_ESTIMATE;
    if (single)
      padded->in_single = std::make_unique<PaddedProductIn<float>>(n, threads, effort, limit);
    else
      padded->in_double = std::make_unique<PaddedProductIn<double>>(n, threads, effort, limit);
    *planning = single ? padded->in_single->planning_seconds() : padded->in_double->planning_seconds();
    *out = padded.release();
  });
}

void bench_padded_destroy(void* padded) { delete static_cast<Padded*>(padded); }

// x and y: [points]; times: best and median
const char* bench_padded_time(void* handle, std::int64_t points, const double* x, double budget, double* times, double* y) {
  return guarded([&] {
    Padded& padded = *static_cast<Padded*>(handle);
    CallTimes calls;
    if (padded.in_single) {
      const std::vector<float> given(x, x + points);
      std::vector<float> product(given.size());
      calls = time_calls(budget, [&] { padded.in_single->multiply(given.data(), product.data()); });
      std::copy(product.begin(), product.end(), y);
    } else {
      calls = time_calls(budget, [&] { padded.in_double->multiply(x, y); });
    }
    times[0] = calls.best;
    times[1] = calls.median;
  });
}

// Seconds of a = b + s c with n values.
const char* bench_time_triad(std::int64_t n, int threads, double budget, double* seconds) {
  return guarded([&] {
    const auto array = [n] { return std::unique_ptr<double[]>(new double[static_cast<std::size_t>(n)]); };
    const std::unique_ptr<double[]> a = array(), b = array(), c = array();
    const auto share = [&](int t, const auto& body) {
      double *const x = a.get(), *const y = b.get(), *const z = c.get();
      for (std::int64_t i = n * t / threads; i < n * (t + 1) / threads; ++i) body(x[i], y[i], z[i]);
    };
    on_threads(threads, [&](int t) {
      share(t, [](double& x, double& y, double& z) {
        x = 0;
        y = 1;
        z = 2;
      });
    });
    *seconds = time_calls(budget, [&] {
                 on_threads(threads, [&](int t) { share(t, [](double& x, double y, double z) { x = y + 3 * z; }); });
               }).best;
  });
}

// Seconds of `repeats` complex transforms on every thread, each on one line in the cache.
const char* bench_time_transform(std::int64_t length, std::int64_t repeats, int threads, double budget, int single,
                                 double* seconds) {
  return guarded([&] {
    *seconds = single ? time_transform<float>(length, repeats, threads, budget)
                      : time_transform<double>(length, repeats, threads, budget);
  });
}

// shape: nx, ny; pitch: hx, hy, 1 where the file does not say [m]; heights: [ny][nx] [m], the caller frees them
const char* bench_read_surface(const char* file, std::int64_t* shape, double* pitch, double** heights) {
  return guarded([&] {
    const cli::Surface surface = cli::read_surface(file, 1);
    shape[0] = surface.nx;
    shape[1] = surface.ny;
    pitch[0] = surface.hx.value_or(1);
    pitch[1] = surface.hy.value_or(1);
    const std::size_t bytes = surface.heights.size() * sizeof(double);
    *heights = static_cast<double*>(std::malloc(bytes));
    if (!*heights) throw std::bad_alloc();
    std::memcpy(*heights, surface.heights.data(), bytes);
  });
}

}  // extern "C"
