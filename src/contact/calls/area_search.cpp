#include "contact/calls/area_search.h"

#include <algorithm>
#include <cmath>

namespace rc {

namespace {

constexpr int most_tries = 40, most_on_one_side = 2;
constexpr double least_bracket = 1e-9;  // relative width, below which the area jumps

}  // namespace

AreaSearch::AreaSearch(double target, double first, const Limits& limits)
    : target_(target), load_(target > 0 ? std::min(first, limits.most) : 0), limits_(limits) {}

bool AreaSearch::near(double share) const {
  return std::abs(share - target_) <= std::max(tolerance * target_, (0.5 + 1e-9) / limits_.points);
}

void AreaSearch::add(double share) {
  if (nearest_.share < 0 || std::abs(share - target_) < std::abs(nearest_.share - target_)) nearest_ = {load_, share};
  const bool low = share < target_;
  const int towards = low ? 1 : -1;
  same_side_ = (same_side_ > 0) == low ? same_side_ + towards : towards;
  (low ? below_ : above_) = {load_, share};
  const bool both = below_.load > 0 && above_.load > 0;
  const bool at_most = load_ >= limits_.most || share * limits_.points >= limits_.included - 0.5;
  done_ = near(share) || ++tries_ == most_tries || target_ <= 0 || (!low && share * limits_.points < 1.5) || (low && at_most) ||
          (both && above_.load <= (1 + least_bracket) * below_.load);
  if (!done_) load_ = std::min(next(), limits_.most);
}

// The area grows nearly as a power of the load: the secant is taken of the logarithms.
double AreaSearch::next() const {
  constexpr double least_step = 1.3, most_step = 30, margin = 0.05;
  if (!(above_.load > 0)) {
    return below_.load * (below_.share > 0 ? std::clamp(1.1 * target_ / below_.share, least_step, most_step) : most_step);
  }
  if (!(below_.load > 0)) return above_.load / std::clamp(1.1 * above_.share / target_, least_step, most_step);
  const double width = std::log(above_.load / below_.load);
  double place = 0.5;  // bisection if one end stays
  if (std::abs(same_side_) <= most_on_one_side && below_.share > 0)
    place = std::clamp(std::log(target_ / below_.share) / std::log(above_.share / below_.share), margin, 1 - margin);
  return below_.load * std::exp(place * width);
}

}  // namespace rc
