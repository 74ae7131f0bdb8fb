// The load whose contact has a given area, found from one load to the next.
#pragma once

#include <cstdint>

namespace rc {

class AreaSearch {
 public:
  // Largest distance from the target, relative to it.
  static constexpr double tolerance = 1e-3;

  // The limits of a search: points of the grid, those that may carry pressure, and the load above which no more is tried.
  struct Limits {
    double points, included, most;
  };

  // target: share of the points; first: the load to begin with.
  AreaSearch(double target, double first, const Limits& limits);

  double load() const { return load_; }
  bool done() const { return done_; }
  // Puts in the area at load().
  void add(double share);
  // The load whose area is the nearest to the target so far, and whether that is within the tolerance, or half a point.
  double nearest() const { return nearest_.load; }
  bool found() const { return near(nearest_.share); }

 private:
  struct End {
    double load = 0, share = 0;  // 0: not known
  };

  double next() const;
  bool near(double share) const;

  double target_, load_;
  Limits limits_;
  End below_, above_, nearest_ = {0, -1};
  int tries_ = 0, same_side_ = 0;
  bool done_ = false;
};

}  // namespace rc
