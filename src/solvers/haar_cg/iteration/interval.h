// The steps between two bounds. Pressures may become negative until the interval ends.
#pragma once

#include "solvers/haar_cg/iteration/pace.h"

namespace rc {

class HaarInterval {
 public:
  constexpr void begin(int planned) {
    planned_ = planned;
    steps_ = 0;
  }
  // Whether a step of this slope would tell nothing: the set is solved.
  constexpr bool needless(double slope) const { return steps_ > 0 && slope <= nothing * first_slope_; }
  // After a step; slope: (w, t), curvature: (t, H t). A step that gains little ends the interval, as one that descends nowhere
  // does.
  constexpr void add(double slope, double curvature) {
    ++steps_;
    const double gain = slope * slope / curvature;
    if (steps_ == 1) first_slope_ = slope, first_gain_ = gain;
    if (!(curvature > 0) || (steps_ > HaarPace::first_interval && gain < little * first_gain_)) steps_ = planned_;
  }
  constexpr bool over() const { return steps_ >= planned_; }

 private:
  static constexpr double little = 1e-4;    // of the energy that the first step gains
  static constexpr double nothing = 1e-10;  // of the first step's slope

  int planned_ = HaarPace::first_interval, steps_ = 0;
  double first_slope_ = 0, first_gain_ = 0;  // of the first step: its slope, twice the energy gained
};

}  // namespace rc
