#include "network_flow.h"

#include <algorithm>
#include <cmath>

namespace rc::flow {

namespace {

// Cells below the floor are closed in the lower bound, and as high as the floor in the equations, so that conductances differ
// less: as a share of the constriction, and of the highest gap.
constexpr double floor_of_constriction = 0.05, floor_of_highest = 1e-3, finer = 1.0 / 8;
constexpr int rounds = 4;

double width(const Tensor& lower, const Tensor& upper) {
  const auto of = [](double low, double high) { return high > 0 ? (high - std::max(low, 0.0)) / high : 0.0; };
  return std::max(of(lower.xx, upper.xx), of(lower.yy, upper.yy));
}

Tensor scaled(const Tensor& tensor, double factor) { return {tensor.xx * factor, tensor.xy * factor, tensor.yy * factor}; }

// Both are lower (upper) bounds as forms; the entries of one matrix go together.
void improve(Tensor& best, const Tensor& found, bool upper) {
  const double sign = upper ? -1 : 1;
  if (sign * (found.xx + found.yy - best.xx - best.yy) > 0) best = found;
}

}  // namespace

Conductance conductance(const Grid& grid, Gap gap, const Wanted& wanted) {
  Conductance answer;
  const double highest = *std::max_element(gap.most.begin(), gap.most.end());
  answer.potential.assign(gap.most.size(), std::numeric_limits<double>::quiet_NaN());
  if (!(highest > 0)) return answer;
  const double cubed = cube(highest);
  if (!(cubed > 1e-280 && cubed < 1e280))
    fail(RC_ERR_ARGUMENT, "the highest gap is ", highest, ": its cube is out of the range of numbers; choose another unit");
  for (auto* each : {&gap.least, &gap.computed, &gap.most})
    for (double& g : *each) g /= highest;

  const Paths possible = find_paths(grid, gap.most);
  if (!possible.any()) return answer;
  const auto best = [&](const std::vector<double>& of) { return grid.cell ? Paths{} : find_paths(grid, of, Find::constriction); };
  const Paths of_gap = best(gap.computed);
  answer.constriction = of_gap.constriction * highest;
  answer.place = of_gap.place;

  const double narrowest = of_gap.constriction > 0 ? of_gap.constriction : best(gap.most).constriction;
  double floor = std::min(floor_of_highest, narrowest > 0 ? floor_of_constriction * narrowest : floor_of_highest);
  const std::size_t fields = grid.cell ? 2 : 1;
  std::vector<double> widened(gap.most.size()), kept(gap.most.size());
  for (int round = 0;; ++round, floor *= finer) {
    std::size_t closed = 0;
    for (std::size_t i = 0; i < widened.size(); ++i) {
      widened[i] = gap.most[i] > 0 ? std::max(gap.most[i], floor) : 0.0;
      kept[i] = gap.least[i] >= floor ? gap.least[i] : 0.0;
      closed += kept[i] == 0 && gap.computed[i] > 0;
    }
    Solved solved = solve_potentials(grid, widened, possible, fields, wanted.memory);
    const Tensor upper = dirichlet(grid, gap.most, possible, solved.potentials);
    const Tensor lower = thomson(grid, kept, find_paths(grid, kept), solved.potentials);
    if (round == 0) answer.upper = upper;
    const double before = round == 0 ? 2 : width(answer.lower, answer.upper);
    improve(answer.upper, upper, true);
    improve(answer.lower, lower, false);
    const double reached = width(answer.lower, answer.upper);
    if (reached < before) {
      answer.computed = dirichlet(grid, gap.computed, possible, solved.potentials);
      answer.dropped = static_cast<double>(closed) / static_cast<double>(widened.size());
      for (std::size_t i = 0; i < widened.size(); ++i)
        if (possible.on(static_cast<std::int64_t>(i))) answer.potential[i] = solved.potentials[0][i];
    }
    answer.iterations += solved.iterations;
    answer.narrow = reached <= wanted.width;
    if (answer.narrow || round + 1 == rounds || !(reached < 0.9 * before)) break;
  }
  for (Tensor* each : {&answer.lower, &answer.computed, &answer.upper}) *each = scaled(*each, cubed);
  return answer;
}

}  // namespace rc::flow
