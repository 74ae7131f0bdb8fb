// C functions for bench/native.py: what must be compiled to be timed. Each returns null, or why it failed, which is valid until
// the thread's next call.
#include <functional>

#include "padded_product.h"

namespace {

using namespace bench;

// A padded product whose precision the caller of the C functions does not see: seconds of the best call.
using AnyProduct = std::function<double(std::int64_t points, const double* x, double budget, double* y)>;

template <class Real> AnyProduct* any_product(std::int64_t n, std::int64_t threads, unsigned effort, double limit) {
  const auto product = std::make_shared<PaddedProduct<Real>>(n, threads, effort, limit);
  return new AnyProduct([product](std::int64_t points, const double* x, double budget, double* y) {
    const std::vector<Real> given(x, x + points);
    std::vector<Real> found(given.size());
    const double best = best_time(budget, [&] { product->multiply(given.data(), found.data()); });
    std::copy(found.begin(), found.end(), y);
    return best;
  });
}

}  // namespace

extern "C" {

// compiler, flags and FFTW, a line each
const char* bench_build() {
  static const std::string text = std::string(RC_BENCH_BUILD) + fftw_version;
  return text.c_str();
}

const char* bench_padded_create(std::int64_t n, std::int64_t threads, std::int64_t measure, double limit, std::int64_t single,
                                void** out) {
  return guarded([&] {
    const unsigned effort = measure ? FFTW_MEASURE : FFTW_ESTIMATE;
    *out = single ? any_product<float>(n, threads, effort, limit) : any_product<double>(n, threads, effort, limit);
  });
}

// x and y: [points]
const char* bench_padded_time(void* product, std::int64_t points, const double* x, double budget, double* y, double* seconds) {
  return guarded([&] { *seconds = (*static_cast<AnyProduct*>(product))(points, x, budget, y); });
}

}  // extern "C"
