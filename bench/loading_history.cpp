#include "loading_history.h"

#include "child.h"
#include "rough_surface.h"

namespace bench {

LoadingHistory loading_history(std::int64_t levels, double hurst, std::uint64_t seed, std::int64_t steps) {
  LoadingHistory history;
  history.n = std::int64_t{1} << levels;
  history.gap = gap_below_highest(midpoint_surface(levels, hurst, seed));
  const double deepest = mean_of(history.gap) / 2;
  for (std::int64_t k = 1; k <= steps; ++k)
    history.approaches.push_back(deepest * static_cast<double>(k) / static_cast<double>(steps));
  return history;
}

std::vector<HistoryStep> run_history(const LoadingHistory& history, const Settings& settings, bool warm) {
  Options options;
  Contact contact(unit_square(history.n), options.set(settings));
  std::vector<HistoryStep> steps;
  rc_step step = RC_STEP_INIT;
  step.gap = history.gap.data();
  for (const double approach : history.approaches) {
    step.target = approach;
    step.warm_start = warm;
    const double before = cpu_seconds();
    const rc_result result = contact.solve(step);
    steps.push_back({result, cpu_seconds() - before});
    step.gap = warm ? nullptr : history.gap.data();
    if (result.status == RC_STOP_TIME) break;  // the later steps are no shorter
    if (!warm) contact.reset();
  }
  return steps;
}

}  // namespace bench
