// The slope that Newton's steps go by: an estimate of it times a factor. What a step left of what it was to make up corrects the
// factor.
#pragma once

#include "core/by_value.h"

namespace rc {

class NewtonSlope {
 public:
  constexpr NewtonSlope(double least, double most) : least_(least), most_(most) {}

  constexpr bool known() const { return factor_ > 0; }
  constexpr double factor() const { return factor_; }
  constexpr void set(double factor) { factor_ = within(factor, least_, most_); }

  // missing: what is to be made up now. Steps that fell short are lengthened where `by_short`, steps that were too long are
  // shortened in full where `by_long`; where they diverge, they are shortened in any case.
  constexpr void correct(double missing, bool by_short, bool by_long) {
    const double left = missing / missing_;
    if (left < 0 ? by_long : by_short && left < 1)
      set(factor_ * (1 - (left < 0 ? larger_of(left, -1.0) : caution * left)));
    else if (left < -1)
      set(factor_ * damping);
  }
  // The missing load that the next step has to add; NaN: not known.
  constexpr void expect(double missing) { missing_ = missing; }

 private:
  static constexpr double caution = 0.7, damping = 1.2;  // lengthens steps less; shortens diverging ones

  double least_, most_, factor_ = 0, missing_ = 0;
};

}  // namespace rc
