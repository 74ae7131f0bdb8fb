// The search for the datum between states of which the load is known exactly: every point is at an end of its pressures and
// should be there.
#pragma once

#include <cmath>
#include <limits>

#include "core/by_value.h"

namespace rc {

class KnownLoads {
 public:
  // The load at this datum, which is known but for an error, misses the load wanted by `missing`. Returns by how much to move the
  // datum: at least by `nearest`, where the first point leaves its end, and by no more where the missing load is small.
  constexpr double leave(double datum, double error, double load, double missing, double nearest, bool small) {
    const bool up = missing > 0;
    (up ? below_ : above_) = State{up ? datum - error : datum + error, load};
    const double share = std::abs(missing) / (above_.load - below_.load), apart = above_.datum - below_.datum;
    const double far = apart < infinite ? within(share, 1 - most_release, most_release) * apart : 2 * last_;
    last_ = small ? nearest : larger_of(far, nearest);
    return up ? last_ : -last_;
  }

  // A change of the datum that stays between the nearest states.
  constexpr double between(double datum, double change) const {
    if (datum + change >= above_.datum) change = larger_of(0.5 * (above_.datum - datum), -std::abs(change));
    if (datum + change <= below_.datum) change = smaller_of(0.5 * (below_.datum - datum), std::abs(change));
    return change;
  }

 private:
  struct State {
    double datum, load;
  };
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr double most_release = 0.9;  // of the way between two states

  State below_{-infinite, 0}, above_{infinite, infinite};  // the nearest to the load wanted
  double last_ = 0;                                        // by how much the datum moved last
};

}  // namespace rc
