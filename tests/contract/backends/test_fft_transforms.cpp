// The Fourier transforms of backend fft against sums written out, for every instruction set that this processor has.
#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "fft/lines.h"
#include "support/cmocka.hpp"

namespace {

using namespace rc_fft;

template <class Real> class Rows {
 public:
  explicit Rows(std::int64_t count) {
    buffer_.reserve<Real>(count, row_size<Real>, {count, 1});
    std::fill_n(data(), count * row_size<Real>, Real{0});
  }
  Real* data() { return buffer_.data<Real>(); }
  std::complex<long double> get(std::int64_t row, std::int64_t c) {
    return {data()[row * row_size<Real> + c], data()[row * row_size<Real> + width<Real> + c]};
  }

 private:
  Buffer buffer_;
};

using Exact = std::complex<long double>;

std::vector<Exact> roots(std::int64_t n) {
  std::vector<Exact> result;
  for (std::int64_t k = 0; k < n; ++k)
    result.push_back(
        std::polar(1.0L, 2 * std::numbers::pi_v<long double> * static_cast<long double>(k) / static_cast<long double>(n)));
  return result;
}

template <class Check> void for_each_instruction_set(const Check& check) {
  check(rc_common::Vectors::baseline, "16 bytes");
#ifdef RC_HAS_WIDER_VECTORS
  if (rc_common::widest_vectors() != rc_common::Vectors::baseline) check(rc_common::Vectors::avx2, "AVX2");
  if (rc_common::widest_vectors() == rc_common::Vectors::avx512) check(rc_common::Vectors::avx512, "AVX-512");
#endif
}

// y of the first `targets` rows from x in the first `sources`; rows after them stay as they are.
template <class Real> void check_product(std::int64_t n, std::int64_t sources, std::int64_t targets, double tolerance) {
  std::mt19937 generator(static_cast<unsigned>(n));
  std::uniform_real_distribution<Real> number(-1, 1);
  Rows<Real> x(n);
  for (std::int64_t i = 0; i < n * row_size<Real>; ++i) x.data()[i] = number(generator);
  // Decreasing, as those of a contact are, and of sum 1.
  const auto eigenvalue = [&](std::int64_t k, std::int64_t c) {
    return static_cast<Real>((1.0 + 0.1 * static_cast<double>(c)) / static_cast<double>((1 + k) * n));
  };
  const std::vector<Exact> turn = roots(n);
  for_each_instruction_set([&](rc_common::Vectors vectors, const char* name) {
    const Fourier<Real> fourier(n, vectors);
    Rows<Real> eigenvalues(n), scratch(Fourier<Real>::scratch_rows(n)), y(n);
    for (std::int64_t k = 0; k <= n / 2; ++k)
      for (std::int64_t c = 0; c < width<Real>; ++c) eigenvalues.data()[fourier.rank(k) * width<Real> + c] = eigenvalue(k, c);
    RowSource<Real> from(x.data(), row_size<Real>, sources);
    RowSink<Real> to(y.data(), row_size<Real>, targets, fourier.spare_row(scratch.data()));
    fourier.multiply(from, eigenvalues.data(), scratch.data(), to);
    double error = 0;
    for (const std::int64_t c : {std::int64_t{0}, width<Real> / 2 + 1, width<Real> - 1}) {
      std::vector<Exact> circle(turn.size());  // coefficients of the circular product
      for (std::int64_t d = 0; d < n; ++d)
        for (std::int64_t k = 0; k < n; ++k)
          circle[static_cast<std::size_t>(d)] +=
              static_cast<long double>(eigenvalue(std::min(k, n - k), c)) * turn[static_cast<std::size_t>(k * d % n)];
      for (std::int64_t i = 0; i < n; ++i) {
        Exact expected = 0;
        for (std::int64_t j = 0; j < sources && i < targets; ++j)
          expected += circle[static_cast<std::size_t>((i - j + n) % n)] * x.get(j, c);
        error = std::max(error, static_cast<double>(std::abs(expected - y.get(i, c))));
      }
    }
    if (!(error <= tolerance))
      fail_msg("product of length %lld, %lld rows to %lld, %s: error %.1e", static_cast<long long>(n),
               static_cast<long long>(sources), static_cast<long long>(targets), name, error);
  });
}

void columns_are_multiplied_as_the_sums_say(void**) {
  const bool quick = std::getenv("RC_TEST_QUICK") != nullptr;
  for (const std::int64_t n : {1,  2,  3,   4,   5,   6,   7,   8,   9,   10,  11,  12,  13,  14,  15,  16,   17,   18,
                               20, 21, 22,  24,  25,  28,  30,  32,  35,  37,  40,  48,  49,  50,  55,  56,   60,   64,
                               96, 97, 105, 112, 128, 169, 192, 210, 256, 257, 343, 375, 509, 512, 630, 1152, 2048, 2401}) {
    if (n > 300 && quick) continue;
    for (const auto& [sources, targets] : {std::pair{n, n}, {(n + 1) / 2, (n + 1) / 2}, {n / 2, n / 2}, {1, 1}}) {
      if (n > 600 && sources == n) continue;
      check_product<double>(n, sources, targets, n > 64 ? 8e-15 : 4e-15);
      check_product<float>(n, sources, targets, n > 64 ? 4e-6 : 2e-6);
    }
  }
}

// `count` lines of n elements, zero from `given` on: their waves against sums, and the lines again.
template <class Real> void check_lines(std::int64_t n, std::int64_t count, std::int64_t given, double tolerance) {
  std::mt19937 generator(static_cast<unsigned>(n));
  std::uniform_real_distribution<Real> number(-1, 1);
  std::vector<std::vector<Real>> x(static_cast<std::size_t>(count), std::vector<Real>(static_cast<std::size_t>(given)));
  for (auto& line : x)
    for (Real& value : line) value = number(generator);
  const std::vector<Exact> turn = roots(n);
  for_each_instruction_set([&](rc_common::Vectors vectors, const char* name) {
    const Fourier<Real> fourier(n, vectors);
    std::vector<std::vector<Real>> y = x;
    const Real* from[most_lines<Real>] = {};
    Real* to[most_lines<Real>] = {};
    for (std::size_t l = 0; l < x.size(); ++l) {
      from[l] = x[l].data();
      to[l] = y[l].data();
      std::fill(y[l].begin(), y[l].end(), Real{0});
    }
    Rows<Real> scratch(Fourier<Real>::scratch_rows(n));
    Rows<Real> spectra(round_up(fourier.waves(), width<Real>) / width<Real> * most_lines<Real>);
    LineSource<Real> source(fourier.passes(), from, given);
    fourier.forward(source, scratch.data());
    fourier.passes().to_spectra(scratch.data(), fourier.rows(), fourier.waves(), spectra.data());
    double error = 0;
    for (std::int64_t l = 0; l < most_lines<Real>; l += 3)
      for (std::int64_t k = 0; k < fourier.waves(); k += 1 + n / 50) {
        Exact expected = 0;
        for (std::int64_t j = 0; j < given && l < count; ++j)
          expected += 2 * static_cast<long double>(x[static_cast<std::size_t>(l)][static_cast<std::size_t>(j)]) *
                      std::conj(turn[static_cast<std::size_t>(j * k % n)]);
        const std::int64_t rank = fourier.rank(k);
        error = std::max(
            error,
            static_cast<double>(std::abs(spectra.get(rank / width<Real> * most_lines<Real> + l, rank % width<Real>) - expected)));
      }
    fourier.passes().from_spectra(spectra.data(), count, fourier.rows(), fourier.waves(), scratch.data());
    LineSink<Real> sink(fourier.passes(), to, given);
    fourier.backward(scratch.data(), sink);
    for (std::size_t l = 0; l < x.size(); ++l)
      for (std::size_t j = 0; j < x[l].size(); ++j)
        error =
            std::max(error, std::abs(static_cast<double>(y[l][j]) / static_cast<double>(2 * n) - static_cast<double>(x[l][j])));
    if (!(error <= tolerance * std::sqrt(static_cast<double>(n))))
      fail_msg("%lld lines of %lld, %lld given, %s: error %.1e", static_cast<long long>(count), static_cast<long long>(n),
               static_cast<long long>(given), name, error);
  });
}

void lines_are_transformed_as_the_sums_say(void**) {
  for (const std::int64_t n : {1, 2, 3, 4, 5, 7, 8, 9, 11, 16, 17, 30, 32, 34, 60, 62, 64, 66, 96, 101, 128, 130, 270, 384, 1024})
    for (const std::int64_t count : {std::int64_t{1}, std::int64_t{5}, std::int64_t{9}, std::int64_t{16}})
      for (const std::int64_t given : {n, (n + 1) / 2}) {
        check_lines<double>(n, count, given, 4e-15);
        check_lines<float>(n, 2 * count, given, 2e-6);
      }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(columns_are_multiplied_as_the_sums_say),
                              cmocka_unit_test(lines_are_transformed_as_the_sums_say)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
