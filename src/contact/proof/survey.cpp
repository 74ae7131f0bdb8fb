#include "contact/proof/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rc {

namespace {

struct Largest {
  double product = 0, gap = 0;

  friend Largest operator+(const Largest& a, const Largest& b) {
    return {std::max(a.product, b.product), std::max(a.gap, b.gap)};
  }
};

}  // namespace

Survey survey(const StepSurface& surface, double compression, const Deflected& answer) {
  constexpr double most = std::numeric_limits<double>::max();
  const auto n = static_cast<std::int64_t>(answer.size());
  Marks touching(n);
  const auto body = [&](std::int64_t begin, std::int64_t count) {
    Largest largest;
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(begin + count); ++k) {
      const std::size_t i = answer.point(k);
      const double gap = answer.product[k] - (compression - surface.height(i));
      const bool apart = gap >= 0 && gap <= most;
      largest.product = std::max(largest.product, std::abs(answer.product[k]));
      if (surface.included(i)) largest.gap = std::max(largest.gap, std::abs(gap));
      if (answer.p()[k] != 0 || !apart) touching.add(k);
    }
    return largest;
  };
  const Largest largest = surface.united(reduce<Largest>(n, surface.team(), body));
  return {touching.list(), largest.product, largest.gap};
}

}  // namespace rc
