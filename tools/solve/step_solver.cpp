#include "solve/step_solver.h"

#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solve/area_search.h"
#include "solve/conclusion.h"
#include "text.h"

namespace cli {

namespace {

// The rms of the height differences between neighbours over the pitch; missing points are left out.
double rms_slope(const Problem& problem) {
  const Surface& surface = problem.input.surface;
  double sum = 0, count = 0;
  const auto add = [&](std::int64_t i, std::int64_t other, double pitch) {
    const double slope =
        (surface.heights[static_cast<std::size_t>(other)] - surface.heights[static_cast<std::size_t>(i)]) / pitch;
    if (std::isnan(slope)) return;
    sum += slope * slope;
    ++count;
  };
  for (std::int64_t y = 0; y < surface.ny; ++y) {
    for (std::int64_t x = 0; x < surface.nx; ++x) {
      const std::int64_t i = y * surface.nx + x;
      if (x + 1 < surface.nx) add(i, i + 1, *surface.hx);
      if (y + 1 < surface.ny) add(i, i + surface.nx, *surface.hy);
    }
  }
  return count > 0 ? std::sqrt(2 * sum / count) : 0;
}

double whole_area(const Problem& problem) {
  return static_cast<double>(problem.system.nx) * static_cast<double>(problem.system.ny) * problem.system.hx * problem.system.hy;
}

}  // namespace

StepSolver::StepSolver(rc_contact* contact, const Problem& problem)
    : contact_(contact), problem_(problem), gap_(problem.input.surface.heights) {
  check(rc_gap_from_heights(static_cast<std::int64_t>(gap_.size()), RC_IN(gap_.data()), {}, RC_OUT(gap_.data())), "");
}

void StepSolver::restore(std::vector<CertifiedStep> certified, std::vector<double> indentation) {
  certified_ = std::move(certified);
  indentation_ = std::move(indentation);
  restore_contact();
}

void StepSolver::restore_contact() {
  rc_state state = RC_STATE_INIT;
  state.undeformed_gap = RC_IN(gap_.data());
  state.mask = RC_IN(problem_.input.mask.empty() ? nullptr : problem_.input.mask.data());
  if (!certified_.empty()) {
    state.p = RC_IN(certified_[0].pressure.data());
    state.approach = certified_[0].approach;
    state.load = certified_[0].load;
  }
  if (certified_.size() > 1) {
    state.p_before = RC_IN(certified_[1].pressure.data());
    state.approach_before = certified_[1].approach;
    state.load_before = certified_[1].load;
  }
  if (!indentation_.empty()) state.indentation = RC_IN(indentation_.data());
  check(rc_contact_restore(contact_, &state), "--resume");
  gap_given_ = true;
}

StepRecord StepSolver::solve(int number, Fields& fields) {
  if (problem_.control == "area") return find_area(number, fields);
  return press(number, problem_.step_control(), problem_.step_target(static_cast<std::size_t>(number - 1)), fields);
}

StepRecord StepSolver::press(int number, int32_t control, double target, Fields& fields) {
  rc_step step = RC_STEP_INIT;
  step.control = control;
  step.target = target;
  step.undeformed_gap.data = gap_given_ ? nullptr : gap_.data();
  step.mask.data = !gap_given_ && !problem_.input.mask.empty() ? problem_.input.mask.data() : nullptr;
  step.borrow = 1;
  gap_given_ = true;

  StepRecord record{number, RC_RESULT_INIT, RC_ACCURACY_INIT, {}, {}, {}};
  record.result.p.data = fields.pressure.data();
  record.result.gap.data = fields.gap.data();
  const rc_status status = rc_contact_solve(contact_, &step, &record.result);
  if (status > 0) record.message = last_message();
  check(status, format("step %d", number));
  check(rc_contact_accuracy(contact_, &record.accuracy), "");
  if (!fields.indentation.empty()) check(rc_contact_indentation(contact_, RC_OUT(fields.indentation.data())), "");
  record.measures = measure(problem_, fields.pressure);
  return record;
}

// The load of the last certified step, scaled; without one Persson's at light loads, of half the modulus times the slope.
double StepSolver::first_load(double share) const {
  const double unit = problem_.system.modulus * whole_area(problem_);
  if (!certified_.empty()) {
    const auto contacts = std::ranges::count_if(certified_[0].pressure, [](double p) { return p > 0; });
    const double before = static_cast<double>(contacts) / static_cast<double>(gap_.size());
    if (before > 0 && certified_[0].load > 0) return certified_[0].load * share / before;
  }
  const double slope = rms_slope(problem_);
  return unit * share * (slope > 0 ? 0.5 * slope : 1e-3);
}

// Every step begins from the same state whether or not a run was interrupted before it. If the bodies yield, every load does,
// because a load that was too large would leave its indentation.
StepRecord StepSolver::find_area(int number, Fields& fields) {
  constexpr double most_pressure = 1e3;  // over E*
  const double target = problem_.targets[static_cast<std::size_t>(number - 1)];
  AreaSearch search{target, static_cast<double>(gap_.size()), first_load(target),
                    most_pressure * problem_.system.modulus * whole_area(problem_)};
  Fields tried = fields;
  StepRecord found{number, RC_RESULT_INIT, RC_ACCURACY_INIT, {}, {}, {}};
  std::int64_t iterations = 0, products = 0;
  double seconds = 0, setup = 0;
  for (bool first = true; !search.done(); first = false) {
    if (first ? gap_given_ : !fields.indentation.empty()) restore_contact();
    StepRecord step = press(number, RC_CONTROL_LOAD, search.load(), tried);
    iterations += step.result.iterations;
    products += step.result.products;
    seconds += step.result.seconds;
    setup += step.result.setup_seconds;
    const bool good = step.good();
    if (!good || search.add(step.result.area_fraction)) {
      found = std::move(step);
      std::swap(fields, tried);
    }
    if (!good) break;
  }
  if (found.good() && !search.found())
    found.remark = asked(problem_, static_cast<std::size_t>(number - 1)) + " asked, " + reached(problem_, found) +
                   " is the nearest that a load gives on this grid";
  found.result.iterations = iterations;
  found.result.products = products;
  found.result.seconds = seconds;
  found.result.setup_seconds = setup;
  found.result.p.data = fields.pressure.data();
  found.result.gap.data = fields.gap.data();
  indentation_ = fields.indentation;
  if (found.good()) {
    certified_.insert(certified_.begin(), {fields.pressure, found.result.approach, found.result.load});
    certified_.resize(std::min<std::size_t>(certified_.size(), 2));
  }
  return found;
}

}  // namespace cli
