#include "fourier.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_fft_complex.h>

#include <bit>
#include <cmath>

#include "core/error.h"
#include "stop.h"
#include "structs.h"

namespace rc::surface {

namespace {

// The length must be a power of two: any other would call GSL's error handler.
void power_of_two(std::vector<Complex>& row, Direction direction) {
  auto* data = reinterpret_cast<double*>(row.data());
  const int status = direction == Direction::forward ? gsl_fft_complex_radix2_forward(data, 1, row.size())
                                                     : gsl_fft_complex_radix2_backward(data, 1, row.size());
  if (status != GSL_SUCCESS) fail(RC_ERR_INTERNAL, "the transform of length ", row.size(), " failed");
}

// Transforms rows of one length. Lengths that are no power of two by Bluestein (1970): with jk = (j^2 + k^2 - (k - j)^2) / 2
// the transform is a convolution with the chirp exp(i pi k^2 / n), computed at a power of two.
class Rows {
 public:
  Rows(std::int64_t length, Direction direction) : length_(static_cast<std::size_t>(length)), direction_(direction) {
    if (std::has_single_bit(length_)) return;
    const double sign = direction == Direction::forward ? 1 : -1;
    work_.resize(std::bit_ceil(2 * length_ - 1));
    chirp_.resize(length_);
    spectrum_.resize(work_.size());
    for (std::size_t k = 0; k < length_; ++k) {
      const auto turns = static_cast<double>(k * k % (2 * length_)) / static_cast<double>(length_);
      chirp_[k] = std::polar(1.0, sign * pi * turns);
      spectrum_[k] = chirp_[k];
      if (k > 0) spectrum_[spectrum_.size() - k] = chirp_[k];
    }
    power_of_two(spectrum_, Direction::forward);
    for (Complex& value : spectrum_) value /= static_cast<double>(work_.size());
  }

  void transform(std::vector<Complex>& row) {
    if (chirp_.empty()) return power_of_two(row, direction_);
    for (std::size_t k = 0; k < length_; ++k) work_[k] = product(row[k], std::conj(chirp_[k]));
    for (std::size_t k = length_; k < work_.size(); ++k) work_[k] = 0;
    power_of_two(work_, Direction::forward);
    for (std::size_t k = 0; k < work_.size(); ++k) work_[k] = product(work_[k], spectrum_[k]);
    power_of_two(work_, Direction::backward);
    for (std::size_t k = 0; k < length_; ++k) row[k] = product(work_[k], std::conj(chirp_[k]));
  }

 private:
  // Faster than operator*, because it has no special case for infinite factors.
  static Complex product(Complex a, Complex b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
  }

  std::size_t length_;
  Direction direction_;
  std::vector<Complex> work_, chirp_, spectrum_;
};

void along(std::vector<Complex>& values, std::int64_t length, std::int64_t step, std::int64_t rows, std::int64_t row_step,
           Direction direction) {
  Rows transformer{length, direction};
  std::vector<Complex> row(static_cast<std::size_t>(length));
  for (std::int64_t r = 0; r < rows; ++r) {
    stop_if_asked();
    for (std::int64_t k = 0; k < length; ++k)
      row[static_cast<std::size_t>(k)] = values[static_cast<std::size_t>(r * row_step + k * step)];
    transformer.transform(row);
    for (std::int64_t k = 0; k < length; ++k)
      values[static_cast<std::size_t>(r * row_step + k * step)] = row[static_cast<std::size_t>(k)];
  }
}

}  // namespace

void fourier(std::vector<Complex>& values, std::int64_t nx, std::int64_t ny, Direction direction) {
  if (nx > 1) along(values, nx, 1, ny, nx, direction);
  if (ny > 1) along(values, ny, nx, nx, 1, direction);
}

}  // namespace rc::surface
