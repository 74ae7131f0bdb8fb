// Whether a residual still falls.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace rc {

// A value makes progress where it is below a share of the mark; then it becomes the mark. The first value sets the mark.
class Stall {
 public:
  // least: the mark is the least of all values, also of those that made no progress.
  enum class Mark { last_progress, least };

  Stall(double share, std::int64_t patience, Mark mark = Mark::last_progress)
      : share_(share), patience_(patience), follows_least_(mark == Mark::least) {}
  // The mark is given. The first value then makes progress, or does not count.
  static Stall from(double mark, double share, std::int64_t patience) {
    Stall stall(share, patience);
    stall.mark_ = mark;
    return stall;
  }

  // True if more than `patience` values in a row have made no progress.
  bool operator()(double value) {
    ++idle_;
    const bool progress = value < share_ * mark_;
    if (progress) idle_ = 0;
    if (progress || follows_least_) mark_ = std::min(mark_, value);
    return idle_ > patience_;
  }

 private:
  double share_;
  std::int64_t patience_;
  bool follows_least_;
  double mark_ = std::numeric_limits<double>::infinity();
  std::int64_t idle_ = -1;  // values since the last progress
};

}  // namespace rc
