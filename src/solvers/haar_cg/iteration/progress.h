// Whether the iteration makes progress: it is in trouble where the merit rises, or where the residual stays as it is.
#pragma once

#include <cmath>
#include <limits>

namespace rc {

class HaarProgress {
 public:
  // After a bound. noise: relative rise of the merit that rounding explains; without `falls` the merit may rise.
  constexpr bool in_trouble(double residual, double merit, double noise, bool falls) {
    bool trouble = falls && merit > merit_before_ + noise * std::abs(merit);
    merit_before_ = merit;
    ++since_best_;
    ++stalled_;
    if (residual < progress * best_) {
      best_ = residual;
      since_best_ = stalled_ = 0;
    }
    if (since_best_ >= patience) {
      trouble = true;
      since_best_ = 0;
    }
    return trouble;
  }
  constexpr int stalled() const { return stalled_; }  // bounds since the residual halved
  // From here on the merit is another.
  constexpr void forget_merit() { merit_before_ = infinite; }
  // Another problem begins.
  constexpr void restart() {
    forget_merit();
    since_best_ = 0;
  }

 private:
  static constexpr int patience = 10;  // bounds in which the residual has not halved
  static constexpr double progress = 0.5;
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  double best_ = infinite, merit_before_ = infinite;
  int since_best_ = 0, stalled_ = 0;  // bounds since the residual halved or patience ran out; since it halved
};

}  // namespace rc
