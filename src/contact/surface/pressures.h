// Pressures on a set of points, 0 elsewhere, the deflections that they cause, and the overlap that stays.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "contact/surface/outputs.h"
#include "operator/operator.h"

namespace rc {

struct Pressures {
  TrialSet on;
  std::vector<double> p;  // [pressure], one for each point of `on`

  bool empty() const { return p.empty(); }
  std::int64_t contacts() const {
    return std::count_if(p.begin(), p.end(), [](double value) { return value > 0; });
  }
  // The pressures at the points of another set.
  std::vector<double> at(const TrialSet& other) const;
  void write(const OutputArray& everywhere, std::int64_t points, const rc_team& team) const;
  void write(double* everywhere, std::int64_t points, const rc_team& team) const { write(OutputArray(everywhere), points, team); }
  // The positive pressures, on their points alone.
  Pressures positive(const rc_team& team) const;
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

// Overlaps [length] at the points where one step has the hardness.
struct Overlap {
  std::vector<std::int64_t> point;
  std::vector<double> depth;

  bool empty() const { return point.empty(); }
  void add_to(std::span<double> indentation) const {
    for (std::size_t k = 0; k < point.size(); ++k) indentation[static_cast<std::size_t>(point[k])] += depth[k];
  }
};

}  // namespace rc
