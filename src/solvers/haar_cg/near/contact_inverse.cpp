#include "solvers/haar_cg/near/contact_inverse.h"

#include <algorithm>
#include <cstdlib>

#include "solvers/haar_cg/near/matrix_loops.h"

namespace rc {

namespace {

constexpr std::size_t lanes = 16;         // rows are a multiple of so many values
constexpr float least_pivot = 1.0F / 64;  // of a point's own deflection: a smaller one is rounding

}  // namespace

ContactInverse::ContactInverse(std::int64_t nx, std::int64_t ny, const std::vector<double>& coupling, std::size_t most)
    : nx_(nx),
      most_(most),
      stride_((most + lanes - 1) / lanes * lanes),
      coupling_(coupling.begin(), coupling.end()),
      inverse_(most_ * stride_),
      column_(stride_),
      change_(stride_),
      place_(static_cast<std::size_t>(nx * ny), -1) {
  x_.reserve(most_);  // so that points join without memory
  y_.reserve(most_);
}

double ContactInverse::coupling(std::int64_t a, std::int64_t b) const {
  return static_cast<double>(
      coupling_[static_cast<std::size_t>(std::abs(a / nx_ - b / nx_) * nx_ + std::abs(a % nx_ - b % nx_))]);
}

void ContactInverse::add_column(std::int64_t point, double p, std::vector<double>& to) const {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += p * coupling(point, static_cast<std::int64_t>(i));
}

// The inverse of a bordered matrix: with v = H^-1 h and s = h_0 - h'v it is H^-1 + v v'/s, -v/s and 1/s.
bool ContactInverse::add(std::int64_t point) {
  const std::size_t n = size();
  if (n == most_) return false;
  const auto x = static_cast<std::int32_t>(point % nx_), y = static_cast<std::int32_t>(point / nx_);
  std::fill(column_.begin(), column_.end(), 0.0F);
  for (std::size_t k = 0; k < n; ++k)
    column_[k] = coupling_[static_cast<std::size_t>(std::abs(y_[k] - y) * nx_ + std::abs(x_[k] - x))];
  multiply(column_, change_);
  double pivot = coupling_[0];
  for (std::size_t k = 0; k < n; ++k) pivot -= static_cast<double>(column_[k]) * static_cast<double>(change_[k]);
  if (!(pivot > static_cast<double>(least_pivot * coupling_[0]))) return false;
  change_[n] = -1;
  place_[static_cast<std::size_t>(point)] = static_cast<std::int32_t>(n);
  x_.push_back(x);
  y_.push_back(y);
  std::fill_n(row(n), stride_, 0.0F);
  best_matrix_loops().add_square(n + 1, stride_, static_cast<float>(1 / pivot), change_.data(), inverse_.data());
  return true;
}

// The last point takes its place.
void ContactInverse::remove(std::int64_t point) {
  const std::size_t at = place(point), last = size() - 1;
  if (at != last) {
    std::swap_ranges(row(at), row(at) + stride_, row(last));
    for (std::size_t k = 0; k <= last; ++k) std::swap(row(k)[at], row(k)[last]);
    x_[at] = x_[last];
    y_[at] = y_[last];
    place_[static_cast<std::size_t>(this->point(at))] = static_cast<std::int32_t>(at);
  }
  place_[static_cast<std::size_t>(point)] = -1;
  x_.pop_back();
  y_.pop_back();
  std::copy_n(row(last), stride_, change_.begin());
  const float factor = -1 / change_[last];
  change_[last] = 0;
  best_matrix_loops().add_square(last, stride_, factor, change_.data(), inverse_.data());
  for (std::size_t k = 0; k < last; ++k) row(k)[last] = 0;
}

void ContactInverse::multiply(const std::vector<float>& b, std::vector<float>& x, const std::vector<float>* c,
                              std::vector<float>* y) const {
  if (c)
    best_matrix_loops().multiply_two(size(), stride_, inverse_.data(), b.data(), x.data(), c->data(), y->data());
  else
    best_matrix_loops().multiply(size(), stride_, inverse_.data(), b.data(), x.data());
}

}  // namespace rc
