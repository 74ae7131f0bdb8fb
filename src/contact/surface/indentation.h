// The indentation that steps leave at points with the hardness: the overlap there is plastic and is added to the undeformed
// gap of the steps that follow.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "contact/surface/pressures.h"
#include "grid/gap_values.h"

namespace rc {

class Indentation {
 public:
  Indentation() = default;
  // depth: of earlier steps, >= 0, or none; gap: undeformed, without it. Both [n].
  Indentation(std::span<const double> depth, const GapValues& gap)
      : depth_(depth.begin(), depth.end()),
        gap_(gap.visit([&](const auto* values) { return std::vector<double>(values, values + gap.size()); })) {}

  bool none() const { return depth_.empty(); }
  // The given gap, without any indentation; empty if it is not kept.
  std::span<const double> given_gap() const { return gap_; }

  // The indentation after one more step with this overlap. gap: the undeformed gap without any indentation.
  Indentation with(const Overlap& overlap, const GapValues& gap) const {
    Indentation next(none() ? std::vector<double>(gap.size(), 0.0) : depth_, gap_.empty() ? gap : GapValues(gap_));
    overlap.add_to(next.depth_);
    return next;
  }
  // The same indentation of another given gap.
  Indentation of(const GapValues& gap) const { return {depth_, gap}; }

  // The gap with the indentation.
  std::vector<double> indented() const {
    std::vector<double> sum(gap_);
    for (std::size_t i = 0; i < depth_.size(); ++i) sum[i] += depth_[i];
    return sum;
  }
  void write(std::span<double> to) const {
    if (none())
      std::fill(to.begin(), to.end(), 0.0);
    else
      std::copy(depth_.begin(), depth_.end(), to.begin());
  }

 private:
  std::vector<double> depth_, gap_;  // [n], or empty; with a depth there is a gap
};

}  // namespace rc
