// How many steps are made between two bounds, and which points enter the free set. Both become stricter where sets cycle, and go
// back once they do not.
#pragma once

#include "core/by_value.h"

namespace rc {

class HaarPace {
 public:
  static constexpr int first_interval = 2, longest_interval = 16;
  static constexpr double first_admission = 0.1, strictest_admission = 0.9, admission_step = 0.2;
  static constexpr double capped_admission = 0.3;  // at least, if points are at the cap

  constexpr int interval() const { return interval_; }  // steps between two bounds
  // A point at an end of its pressures enters the free set where it violates its condition by more than this share of the
  // residual.
  constexpr double admission(bool capped) const { return capped ? larger_of(admission_, capped_admission) : admission_; }

  constexpr void begin_at_cap() { admission_ = strictest_admission; }
  constexpr void admit_fewer() {
    calm_ = 0;
    admission_ = smaller_of(strictest_admission, admission_ + admission_step);
  }
  constexpr void make_more_steps() { interval_ = smaller_of(longest_interval, 2 * interval_); }
  // After a bound without trouble. rose: the violation is larger than at the last one. Strict admission lets few points in at a
  // time, which is slow once sets no longer cycle.
  constexpr void relieve(bool rose) {
    calm_ = rose ? 0 : calm_ + 1;
    if (calm_ < relief) return;
    calm_ = 0;
    interval_ = larger_of(first_interval, interval_ / 2);
    admission_ = larger_of(first_admission, admission_ - admission_step);
  }
  // After a bound where points are at the cap. A point that leaves one end drives its neighbours to the other, so fewer may leave
  // their ends at once if that makes things worse.
  constexpr void adapt(bool rose) {
    admission_ = within(admission_ + (rose ? capped_rise : -capped_relief), first_admission, strictest_admission);
  }

 private:
  static constexpr double capped_rise = 0.3, capped_relief = 0.2;
  static constexpr int relief = 2;  // bounds in which nothing rose

  int interval_ = first_interval, calm_ = 0;
  double admission_ = first_admission;
};

}  // namespace rc
