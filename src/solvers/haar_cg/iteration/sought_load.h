// The search for the load at a prescribed approach, if steps keep the load: the datum that a load has beyond the approach
// grows with it and must vanish.
#pragma once

#include <limits>

#include "core/by_value.h"

namespace rc {

class SoughtLoad {
 public:
  // The next load to try after one whose datum is known, neither of them 0: by the secant between the last two, within the
  // nearest on both sides.
  constexpr double next(double datum, double load) {
    if (datum > 0) {
      above_ = load;
      if (below_ >= load) below_ = 0;  // its datum was not as well known
    } else {
      below_ = load;
      if (above_ <= load) above_ = infinite;
    }
    const double slope = (load - last_load_) / (datum - last_datum_);
    last_load_ = load;
    last_datum_ = datum;
    const double depth = larger_of(1 + datum, 1 / most_ratio);
    double wanted = slope > 0 && slope < infinite ? load - slope * datum : load / (depth * depth);
    if (!(wanted > below_ && wanted < above_)) wanted = above_ < infinite ? 0.5 * (below_ + above_) : infinite;
    return within(wanted, load / most_ratio, load * most_ratio);
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr double most_ratio = 4;  // of two loads that follow each other

  double below_ = 0, above_ = infinite;
  double last_load_ = std::numeric_limits<double>::quiet_NaN(), last_datum_ = 0;
};

}  // namespace rc
