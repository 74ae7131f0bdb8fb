// Pressures on a set of points, 0 elsewhere, and the deflections that they cause.
#pragma once

#include <limits>
#include <vector>

#include "operator/operator.h"

namespace rc {

struct Pressures {
  TrialSet on;
  std::vector<double> p;  // [pressure], one for each point of `on`

  bool empty() const { return p.empty(); }
  // The pressures at the points of another set.
  std::vector<double> at(const TrialSet& other) const;
  void write(double* everywhere, std::int64_t points) const;
  // The positive pressures, on their points alone.
  Pressures positive() const;
};

// H p at the points listed. Every other point has a deformed gap above `beyond`, or an undeformed gap that is no smaller than the
// approach.
struct Deflected {
  Pressures pressures;
  std::vector<double> product;  // [length]
  double beyond = std::numeric_limits<double>::infinity();

  const TrialSet& on() const { return pressures.on; }
  const std::vector<double>& p() const { return pressures.p; }
  std::size_t size() const { return pressures.p.size(); }
  std::size_t point(std::size_t k) const { return on().index.empty() ? k : static_cast<std::size_t>(on().index[k]); }
};

}  // namespace rc
