// Robust straight lines through points of known variance.
#pragma once

#include <span>
#include <vector>

namespace rc::surface {

struct Line {
  double intercept = 0, slope = 0;
  double slope_error = 0;  // half of the 95 % confidence interval
  double at(double x) const { return intercept + slope * x; }
};

// Needs at least 3 points. Scatter beyond the points' own variance (no spectrum is a perfect power law) is estimated and added to
// all variances. Points more than two deviations from the line weigh less (Huber 1964).
Line fit_line(std::span<const double> x, std::span<const double> y, std::span<const double> variance);

// Cuts points 0 .. n-1 into consecutive pieces of at least `shortest` points, each with its own line. The sum of squared
// residuals over the variances, plus `price` for each piece, is least. Returns the first points of the pieces, then n.
std::vector<std::size_t> cut_into_lines(std::span<const double> x, std::span<const double> y, std::span<const double> variance,
                                        std::size_t shortest, double price);

}  // namespace rc::surface
