#include "solvers/residual.h"

#include <algorithm>
#include <cmath>

#include "core/limits.h"
#include "core/sums.h"

namespace rc {

namespace {

void scale(const Problem& problem, Vector& p) {
  const double sum = sum_of(p.size(), [&](std::size_t i) { return p[i]; });
  for (double& value : p) value = sum > 0 ? value * (problem.load() / sum) : problem.load() / static_cast<double>(p.size());
}

double approach_without_free(const Vector& p, const Vector& hp, const double* u, double cap) {
  double least = -infinite, most = infinite;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p[i] >= cap)
      least = std::max(least, hp[i] - u[i]);
    else
      most = std::min(most, hp[i] - u[i]);
  return least <= most ? least : 0.5 * (least + most);
}

// The shift for which clamp(v + shift, 0, cap) has the sum wanted: Newton's method on a sum that is piecewise linear in the
// shift. Every third step halves the bracket instead.
double shift_in_box(const Vector& v, double cap, double wanted) {
  const auto [least, most] = std::minmax_element(v.begin(), v.end());
  double low = -*most, high = cap - *least, shift = std::clamp(0.0, low, high);
  for (int step = 0;; ++step) {
    const double sum = sum_of(v.size(), [&](std::size_t i) { return std::clamp(v[i] + shift, 0.0, cap); });
    const double slope = sum_of(v.size(), [&](std::size_t i) { return v[i] + shift > 0 && v[i] + shift < cap ? 1.0 : 0.0; });
    const double newton = shift + (wanted - sum) / slope;
    if (sum == wanted || newton == shift) return shift;
    (sum < wanted ? low : high) = shift;
    const double next = step % 3 < 2 && newton > low && newton < high ? newton : 0.5 * (low + high);
    if (!(next > low && next < high)) return shift;
    shift = next;
  }
}

}  // namespace

void clip(const Problem& problem, Vector& p) {
  for (double& value : p) value = std::min(std::max(value, 0.0), problem.cap());
}

// Without a cap p = max(0, v + shift): the shift is found by leaving out the components that it makes negative, again and again
// (Michelot 1986).
void project(const Problem& problem, Vector& v) {
  double shift = 0;
  if (problem.load_control()) {
    double count = static_cast<double>(v.size());
    double sum = sum_of(v.size(), [&](std::size_t i) { return v[i]; });
    while (true) {
      shift = (problem.load() - sum) / count;
      const auto stays = [&](std::size_t i) { return v[i] + shift > 0; };
      const double remaining = sum_of(v.size(), [&](std::size_t i) { return stays(i) ? 1.0 : 0.0; });
      if (remaining == count || remaining == 0) break;
      count = remaining;
      sum = sum_of(v.size(), [&](std::size_t i) { return stays(i) ? v[i] : 0.0; });
    }
  }
  const double cap = problem.cap();
  const auto exceeds = [&](double value) { return value + shift > cap; };
  const bool capped = cap < infinite && problem.load_control() && std::any_of(v.begin(), v.end(), exceeds);
  if (capped) shift = shift_in_box(v, cap, problem.load());
  for (double& value : v) value = std::min(std::max(0.0, value + shift), cap);
  if (!problem.load_control() || capped) return;
  scale(problem, v);  // removes the round-off in the sum
  if (cap < infinite) clip(problem, v);
}

Residual residual_of(const Problem& problem, const Vector& p, const Vector& hp) {
  const double* u = problem.u();
  const std::size_t n = p.size();
  const double cap = problem.cap();
  const auto is_free = [&](std::size_t i) { return p[i] > 0 && p[i] < cap; };
  Residual result{0, 0, 1};
  if (problem.load_control()) {
    const double count = sum_of(n, [&](std::size_t i) { return is_free(i) ? 1.0 : 0.0; });
    result.approach = count > 0 ? sum_of(n, [&](std::size_t i) { return is_free(i) ? hp[i] - u[i] : 0.0; }) / count
                                : approach_without_free(p, hp, u, cap);
    result.scale = std::max(result.approach + *std::max_element(u, u + n), problem.least_scale());
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double gap = hp[i] - u[i] - result.approach, violation = p[i] >= cap ? gap : p[i] > 0 ? std::abs(gap) : -gap;
    if (std::isnan(violation)) problem.fail("the operator returned values that are not finite");
    result.worst = std::max(result.worst, violation);
  }
  result.worst = result.scale > 0 ? result.worst / result.scale : infinite;
  return result;
}

void scale_to_load(const Problem& problem, Vector& p) {
  if (!problem.load_control()) return;
  const double cap = problem.cap();
  for (bool again = true; again;) {
    double free = 0, at_cap = 0;
    for (const double value : p) (value < cap ? free : at_cap) += std::min(value, cap);
    const double factor = (problem.load() - at_cap) / free;
    if (at_cap == 0 && !(factor * *std::max_element(p.begin(), p.end()) > cap)) return scale(problem, p);
    if (!(factor > 0 && factor < infinite)) return project(problem, p);
    again = false;
    for (double& value : p) {
      const bool below = value < cap;
      value = below ? std::min(value * factor, cap) : cap;
      again = again || (below && value == cap);
    }
  }
}

}  // namespace rc
