// The unknowns of sparse contact: in tiles or at single points.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "contact/problem.h"
#include "contact/surface/points_below.h"

namespace rc {

// The unknowns: in tiles or at points, whose numbers are ascending.
class Region {
 public:
  Region(const GridProblem& problem, bool of_tiles) : surface_(problem.surface), of_tiles_(of_tiles) {}

  // Returns whether any of the points is new to it.
  bool add(const std::vector<std::int64_t>& points) {
    const std::size_t before = members_.size();
    for (const std::int64_t point : points) {
      const std::int64_t member = of_tiles_ ? surface_.tiles().of(point) : point;
      if (members_.empty() || members_.back() != member) members_.push_back(member);
    }
    std::sort(members_.begin(), members_.end());
    members_.erase(std::unique(members_.begin(), members_.end()), members_.end());
    return members_.size() > before;
  }

  // The points of its tiles with a gap below the limit.
  TrialSet below(double limit) const {
    if (of_tiles_) return points_below(limit, surface_, members_);
    return {static_cast<std::int64_t>(members_.size()), members_};
  }
  bool of_tiles() const { return of_tiles_; }

 private:
  const StepSurface& surface_;
  const bool of_tiles_;
  std::vector<std::int64_t> members_;
};

}  // namespace rc
