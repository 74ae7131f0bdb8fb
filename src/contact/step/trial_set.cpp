#include "contact/step/trial_set.h"

#include <utility>

#include "contact/step/services.h"

namespace rc {

TrialSet trial_below(double limit, const Workspace& work) {
  if (work.ranks()) return {work.own_points(), {}};
  return work.system.positive ? work.surface.below(limit) : work.surface.all();
}

TrialSet widened(TrialSet trial, const Choice& choice, const Workspace& work) {
  constexpr std::uint64_t by_points = RC_CAP_SUBSET | RC_CAP_SCREEN;  // backends whose products cost more with every point
  if (work.ranks() || !(choice.solver->needs & RC_WANTS_BOX) || (choice.backend->caps & by_points) || !work.surface.whole())
    return trial;
  const rc_system& system = work.system.given;
  const std::int64_t box = box_points(trial, system.nx, system.ny);
  return trial.n < box && 2 * trial.n >= box ? box_of(trial, system.nx, system.ny) : trial;
}

Choice choose_for(const TrialSet& trial, std::int32_t control, Workspace& work) {
  const rc_system& system = work.system.given;
  const bool shared = work.ranks() != nullptr;
  const StepFacts facts{.control = control,
                        .candidates = shared ? work.system.points() : trial.n,
                        .box = shared ? work.system.points() : box_points(trial, system.nx, system.ny),
                        .tol = work.options.real(RC_OPT_TOL),
                        .partial = work.record.look > 0,
                        .shared = shared};
  return work.record.choice = choose(work.options, work.system, facts, work.record.failed);
}

Answer prepared(const TrialSet& trial, std::int32_t control, double length_unit, Workspace& work) {
  Answer answer;
  answer.choice = choose_for(trial, control, work);
  answer.length_unit = length_unit;
  answer.pressure_unit = length_unit / work.system.length_per_pressure;
  answer.hardness = work.system.hardness;
  return answer;
}

std::vector<double> compenetrations(const Answer& answer, double datum, const Workspace& work) {
  GatheredTiles* const tiles = work.surface.tiles();
  if (!tiles && work.system.halfspace() && takes_gap(*answer.choice.solver, work.options)) return {};
  const TrialSet& trial = answer.op->trial();
  if (tiles) tiles->hold_tiles_of(trial.index);
  std::vector<double> u(static_cast<std::size_t>(trial.n));
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] =
        (datum - work.surface.gap_at(static_cast<std::size_t>(trial.point(static_cast<std::int64_t>(i))))) / answer.length_unit;
  return u;
}

}  // namespace rc
