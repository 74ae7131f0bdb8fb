// The load whose contact has a given area, found from one load to the next.
#pragma once

#include <cstdint>

namespace cli {

class AreaSearch {
 public:
  // Largest distance from the target, relative to it.
  static constexpr double tolerance = 1e-3;

  // target: share of the points; points: of the grid; first: the load to begin with; most: the load above which no more is tried.
  AreaSearch(double target, double points, double first, double most)
      : target_(target), points_(points), load_(target > 0 ? first : 0), most_(most) {}

  double load() const { return load_; }
  bool done() const { return done_; }
  // The area at load(). True if it is the nearest to the target so far.
  bool add(double share);
  // Whether the nearest area is within the tolerance, or half a point.
  bool found() const { return near(nearest_); }

 private:
  struct End {
    double load = 0, share = 0;  // 0: not known
  };

  bool near(double share) const;
  double next() const;

  double target_, points_, load_, most_;
  End below_, above_;
  double nearest_ = -1;
  int tries_ = 0, same_side_ = 0;
  bool done_ = false;
};

}  // namespace cli
