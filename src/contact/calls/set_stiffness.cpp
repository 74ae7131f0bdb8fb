#include "contact/calls/set_stiffness.h"

#include <atomic>
#include <utility>
#include <vector>

#include "contact/choice.h"
#include "contact/operators.h"
#include "contact/spectrum.h"
#include "core/error.h"

namespace rc {

rc_status set_stiffness(const rc_system& given, const std::uint8_t* mask, const rc_options& options,
                        StiffnessInterval& stiffness) {
  GridProblem problem(given, options, nullptr);
  const System& system = problem.system;
  std::vector<std::int64_t> points;
  for (std::int64_t i = 0; i < system.points(); ++i)
    if (!mask || mask[i] != 0) points.push_back(i);
  const auto count = static_cast<std::int64_t>(points.size());
  const bool all = count == system.points();
  if (count == 0 || (all && system.periodic())) {
    stiffness.value = stiffness.lower = stiffness.upper = count == 0 ? 0 : std::numeric_limits<double>::infinity();
    return RC_OK;
  }
  problem.facts.spectrum = std::make_shared<const Spectrum>(spectrum_of(system));
  TrialSet trial{count, {}};
  if (!all) trial.index = points;
  const Choice choice = choose_for(problem, trial, RC_CONTROL_APPROACH, {}, false);
  Operator& op = problem.operators().bound(*choice.backend, trial);
  const std::atomic<bool> never{false};
  const Monitor monitor(never, {}, options.real(RC_OPT_TIME_LIMIT), options.integer(RC_OPT_MAX_ITER));
  const Operator::Watch watch(op, [&] { return monitor.ask(); });
  return stiffness_of_points(problem, op, points, stiffness);
}

}  // namespace rc
