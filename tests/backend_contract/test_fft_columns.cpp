// The passes of backend fft's own, over columns and over halves of rows, against sums written out, for every instruction set that
// this processor has.
#include <cmath>
#include <complex>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "fft/column_passes.h"
#include "fft/half_length_passes.h"
#include "support/cmocka.hpp"

namespace {

using rc_fft::ColumnBlock;
using rc_fft::ColumnProduct;
using rc_fft::columns_per_block;

template <class T> struct Release {
  void operator()(T* p) const { std::free(p); }
};
template <class T> std::unique_ptr<T[], Release<T>> aligned_array(std::int64_t size) {
  const std::int64_t bytes = rc_fft::round_up(size * static_cast<std::int64_t>(sizeof(T)), rc_fft::alignment);
  T* const p = static_cast<T*>(std::aligned_alloc(rc_fft::alignment, static_cast<std::size_t>(bytes)));
  assert_non_null(p);
  std::uninitialized_fill_n(p, size, T{});
  return std::unique_ptr<T[], Release<T>>(p);
}

struct Shape {
  std::int64_t length, first_source, sources, targets;
};

// One block of columns in an array of two; the rest of it must stay as it is.
template <class Real> class Columns {
 public:
  using Complex = std::complex<Real>;
  static constexpr std::int64_t width = columns_per_block<Real>, stride = 2 * width;

  explicit Columns(const Shape& shape) : shape_(shape), plan_(shape.length), x_(static_cast<std::size_t>(shape.length * stride)) {
    std::mt19937 generator(static_cast<unsigned>(shape.length));
    std::uniform_real_distribution<Real> number(-1, 1);
    for (Complex& value : x_) value = {number(generator), number(generator)};
    eigenvalues_ = aligned_array<Real>((shape.length / 2 + 1) * width);
    for (std::int64_t k = 0; k <= shape.length / 2; ++k)
      for (std::int64_t c = 0; c < width; ++c)
        eigenvalues_[static_cast<std::size_t>(plan_.rank(k) * width + c)] = eigenvalue(k, c);
  }

  template <class Run> std::vector<Complex> product(const Run& run) {
    auto rows = aligned_array<Complex>(shape_.length * stride);
    auto scratch = aligned_array<Complex>(ColumnProduct<Real>::scratch_rows(shape_.length) * width);
    std::copy(x_.begin(), x_.end(), rows.get());
    run(plan_, ColumnBlock<Real>{rows.get() + width, stride, shape_.first_source, shape_.sources, shape_.targets,
                                 eigenvalues_.get(), scratch.get()});
    return {rows.get(), rows.get() + shape_.length * stride};
  }

  // Largest error; x where nothing is to be written.
  double error(const std::vector<Complex>& y) const {
    double largest = 0;
    const std::int64_t n = shape_.length;
    std::vector<std::complex<double>> turn(static_cast<std::size_t>(n)), circle(turn.size());
    for (std::int64_t k = 0; k < n; ++k)
      turn[static_cast<std::size_t>(k)] = std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n));
    for (std::int64_t column = 0; column < stride; ++column) {
      const std::int64_t c = column - width;
      const bool ours = c >= 0;
      // Coefficients of the circular product; few of the columns, since all are treated alike.
      if (ours && c % 3 != 0) continue;
      if (ours) {
        for (std::int64_t d = 0; d < n; ++d) {
          circle[static_cast<std::size_t>(d)] = 0;
          for (std::int64_t k = 0; k < n; ++k)
            circle[static_cast<std::size_t>(d)] +=
                static_cast<double>(eigenvalue(std::min(k, n - k), c)) * turn[static_cast<std::size_t>(k * d % n)];
        }
      }
      for (std::int64_t i = 0; i < n; ++i) {
        std::complex<double> expected = x_[static_cast<std::size_t>(i * stride + column)];
        if (ours && i < shape_.targets) {
          expected = 0;
          for (std::int64_t j = shape_.first_source; j < shape_.first_source + shape_.sources; ++j)
            expected += circle[static_cast<std::size_t>((i - j + n) % n)] *
                        std::complex<double>(x_[static_cast<std::size_t>(j * stride + column)]);
        }
        largest = std::max(largest, std::abs(expected - std::complex<double>(y[static_cast<std::size_t>(i * stride + column)])));
      }
    }
    return largest;
  }

 private:
  // Decreasing, as those of a contact are, and of sum 1.
  Real eigenvalue(std::int64_t k, std::int64_t c) const {
    return static_cast<Real>((1.0 + 0.1 * static_cast<double>(c)) / static_cast<double>((1 + k) * shape_.length));
  }

  Shape shape_;
  ColumnProduct<Real> plan_;
  std::vector<Complex> x_;
  std::unique_ptr<Real[], Release<Real>> eigenvalues_;
};

template <class Real> void check(const Shape& shape, double tolerance) {
  using Builds = rc_fft::ColumnBuilds<Real>;
  Columns<Real> columns(shape);
  const auto verify = [&](const char* passes, const auto& run) {
    const double error = columns.error(columns.product(run));
    if (!(error <= tolerance))
      fail_msg("length %lld, %lld rows from %lld to %lld, %s: error %.1e", static_cast<long long>(shape.length),
               static_cast<long long>(shape.sources), static_cast<long long>(shape.first_source),
               static_cast<long long>(shape.targets), passes, error);
  };
  verify("chosen", [](const auto& plan, const auto& block) { plan.multiply(block); });
  verify("16 bytes", Builds::template any<rc_fft::Passes<Real, 16>>);
#ifdef RC_HAS_WIDER_VECTORS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    verify("AVX2", Builds::template avx2<rc_fft::Passes<Real, 32>>);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    verify("AVX-512", Builds::template avx512<rc_fft::Passes<Real, 64>>);
#endif
}

void columns_are_multiplied_as_the_sums_say(void**) {
  const bool quick = std::getenv("RC_TEST_QUICK") != nullptr;
  for (const std::int64_t n :
       {1,  2,  3,  4,  5,  6,  7,  8,  9,  10,  12,  14,  15,  16,  18,  20,  21,  24,  25,  28,   30,   32,
        35, 40, 48, 49, 50, 56, 60, 64, 96, 105, 112, 128, 192, 210, 256, 343, 375, 512, 630, 1152, 2048, 2401}) {
    if (n > 300 && quick) continue;
    std::vector<Shape> shapes{{n, 0, n, n}, {n, 0, (n + 1) / 2, (n + 1) / 2}, {n, 0, n / 2, n / 2}};
    if (n < 300) {
      shapes.push_back({n, n / 3, n - n / 3, n});
      shapes.push_back({n, n / 2, 1, n / 2 + 1});
      shapes.push_back({n, 0, 1, 1});
    }
    for (const Shape& shape : shapes) {
      if (n > 600 && shape.sources == n) continue;
      check<double>(shape, 2e-15 * static_cast<double>(n > 64 ? 4 : 2));
      check<float>(shape, 1e-6 * static_cast<double>(n > 64 ? 4 : 2));
    }
  }
}

// sum over j of x[j] exp(-2 pi i jk/n)
std::complex<double> wave(const std::vector<std::complex<double>>& x, std::size_t k) {
  std::complex<double> sum = 0;
  for (std::size_t j = 0; j < x.size(); ++j)
    sum += x[j] * std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(j * k % x.size()) / static_cast<double>(x.size()));
  return sum;
}

template <class Real> void check_halves(std::size_t length, double tolerance) {
  using Builds = rc_fft::HalfLengthBuilds<Real>;
  using Row = std::vector<std::complex<Real>>;
  const rc_fft::HalfLength<Real> plan(static_cast<std::int64_t>(length));
  const std::size_t half = length / 2;
  std::mt19937 generator(static_cast<unsigned>(length));
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<std::complex<double>> line(length), pairs(half);
  for (std::complex<double>& value : line) value = number(generator);
  for (std::size_t j = 0; j < half; ++j) pairs[j] = {line[2 * j].real(), line[2 * j + 1].real()};
  Row packed(half + 1);
  for (std::size_t k = 0; k < half; ++k) packed[k] = std::complex<Real>(wave(pairs, k));
  const auto verify = [&](const char* passes, const auto& to_real, const auto& from_real) {
    Row row = packed;
    to_real(plan, row.data());
    double error = 0;
    for (std::size_t k = 0; k <= half; ++k) error = std::max(error, std::abs(std::complex<double>(row[k]) - 2.0 * wave(line, k)));
    from_real(plan, row.data());  // twice what to_real() began with, twice over
    for (std::size_t k = 0; k < half; ++k)
      error = std::max(error, 0.25 * static_cast<double>(std::abs(row[k] - Real{4} * packed[k])));
    if (!(error <= tolerance * static_cast<double>(length)))
      fail_msg("half of %lld, %s: error %.1e", static_cast<long long>(length), passes, error);
  };
  verify(
      "chosen", [](const auto& p, auto* row) { p.to_real(row); }, [](const auto& p, auto* row) { p.from_real(row); });
  verify("16 bytes", Builds::template any<rc_fft::HalfLengthPass<Real, 16, false>>,
         Builds::template any<rc_fft::HalfLengthPass<Real, 16, true>>);
#ifdef RC_HAS_WIDER_VECTORS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    verify("AVX2", Builds::template avx2<rc_fft::HalfLengthPass<Real, 32, false>>,
           Builds::template avx2<rc_fft::HalfLengthPass<Real, 32, true>>);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    verify("AVX-512", Builds::template avx512<rc_fft::HalfLengthPass<Real, 64, false>>,
           Builds::template avx512<rc_fft::HalfLengthPass<Real, 64, true>>);
#endif
}

void real_lines_are_made_of_halves_as_the_sums_say(void**) {
  for (const std::size_t n : {2, 4, 6, 8, 10, 30, 34, 62, 64, 66, 70, 96, 128, 130, 270, 384}) {
    check_halves<double>(n, 1e-15);
    check_halves<float>(n, 5e-7);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(columns_are_multiplied_as_the_sums_say),
                              cmocka_unit_test(real_lines_are_made_of_halves_as_the_sums_say)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
