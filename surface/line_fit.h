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

// At least 3 points. Variance that the points' own does not explain (a spectrum that is no perfect power law) is estimated and
// added to all; points further than two deviations off weigh less (Huber 1964).
Line fit_line(std::span<const double> x, std::span<const double> y, std::span<const double> variance);

// Cuts points 0 .. n-1 into consecutive pieces of at least `shortest`, each with a line of its own, so that the squared residuals
// over the variances plus `price` a piece are least. Returns the first points of the pieces, then n.
std::vector<std::size_t> cut_into_lines(std::span<const double> x, std::span<const double> y, std::span<const double> variance,
                                        std::size_t shortest, double price);

}  // namespace rc::surface
