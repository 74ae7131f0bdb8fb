#include "line_fit.h"

#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rc::surface {

namespace {

constexpr double huber = 2;

// Student's 97.5 % quantile, by the first terms of its expansion about the normal one (within 2 % from 3 degrees on).
double student(double freedom) { return 1.96 + 2.37 / freedom + 2.8 / (freedom * freedom); }

// The variance that must be added to all points so that the sum of squared residuals has its expected value (Paule & Mandel
// 1982).
double excess_variance(std::span<const double> squares, std::span<const double> variance, double freedom) {
  const auto surplus = [&](double extra) {
    double sum = 0;
    for (std::size_t i = 0; i < squares.size(); ++i) sum += std::min(squares[i] / (variance[i] + extra), huber * huber);
    return sum - freedom;
  };
  if (surplus(0) <= 0) return 0;
  double low = 0, high = *std::ranges::max_element(squares);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (surplus(middle) > 0 ? low : high) = middle;
  }
  return high;
}

}  // namespace

Line fit_line(std::span<const double> x, std::span<const double> y, std::span<const double> variance) {
  const std::size_t n = x.size();
  const double freedom = static_cast<double>(n) - 2;
  std::vector<double> weight(n), squares(n), mistrust(n, 1.0);
  Line line;
  double extra = 0;
  for (int round = 0; round < 30; ++round) {
    for (std::size_t i = 0; i < n; ++i) weight[i] = 1 / ((variance[i] + extra) * mistrust[i]);
    double cov00 = 0, cov01 = 0, cov11 = 0, chi2 = 0;
    gsl_fit_wlinear(x.data(), 1, weight.data(), 1, y.data(), 1, n, &line.intercept, &line.slope, &cov00, &cov01, &cov11, &chi2);
    line.slope_error = student(freedom) * std::sqrt(cov11 * std::max(1.0, chi2 / freedom));
    for (std::size_t i = 0; i < n; ++i) squares[i] = (y[i] - line.at(x[i])) * (y[i] - line.at(x[i]));
    extra = excess_variance(squares, variance, freedom);
    for (std::size_t i = 0; i < n; ++i) mistrust[i] = std::max(1.0, std::sqrt(squares[i] / (variance[i] + extra)) / huber);
  }
  return line;
}

namespace {

// Sums from which the squared residuals of the best line through any run of points follow.
class Residuals {
 public:
  Residuals(std::span<const double> x, std::span<const double> y, std::span<const double> variance) : sums_(x.size() + 1) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double w = 1 / variance[i], terms[] = {w, w * x[i], w * y[i], w * x[i] * x[i], w * x[i] * y[i], w * y[i] * y[i]};
      for (std::size_t k = 0; k < 6; ++k) sums_[i + 1][k] = sums_[i][k] + terms[k];
    }
  }

  double operator()(std::size_t first, std::size_t end) const {
    double s[6];
    for (std::size_t k = 0; k < 6; ++k) s[k] = sums_[end][k] - sums_[first][k];
    const double xx = s[3] - s[1] * s[1] / s[0], xy = s[4] - s[1] * s[2] / s[0], yy = s[5] - s[2] * s[2] / s[0];
    return std::max(0.0, xx > 0 ? yy - xy * xy / xx : yy);
  }

 private:
  struct Sums {
    double value[6] = {};
    double& operator[](std::size_t k) { return value[k]; }
    double operator[](std::size_t k) const { return value[k]; }
  };
  std::vector<Sums> sums_;
};

}  // namespace

std::vector<std::size_t> cut_into_lines(std::span<const double> x, std::span<const double> y, std::span<const double> variance,
                                        std::size_t shortest, double price) {
  const std::size_t n = x.size();
  const Residuals residuals{x, y, variance};
  // Bellman's recursion: the best cut of the first `end` points is a best cut of the first `first`, and one more piece.
  std::vector<double> cost(n + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> previous(n + 1, 0);
  cost[0] = 0;
  for (std::size_t end = std::min(shortest, n); end <= n; ++end) {
    for (std::size_t first = 0; first + std::min(shortest, n) <= end; ++first) {
      const double with = cost[first] + residuals(first, end) + price;
      if (with < cost[end]) {
        cost[end] = with;
        previous[end] = first;
      }
    }
  }
  std::vector<std::size_t> cuts{n};
  while (cuts.back() > 0) cuts.push_back(previous[cuts.back()]);
  std::ranges::reverse(cuts);
  return cuts;
}

}  // namespace rc::surface
