#include "contact/calls/contact.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "contact/slopes/derivatives.h"
#include "contact/step/target.h"
#include "core/error.h"

namespace rc {

namespace {

// None where the state has none, or nothing but zeros.
Indentation indentation_of(const rc_state& state, const System& system) {
  if (!state.indentation) return {};
  const std::span<const double> depth(state.indentation, static_cast<std::size_t>(system.points()));
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (!(depth[i] >= 0 && std::isfinite(depth[i])))
      fail(RC_ERR_ARGUMENT, "rc_state.indentation[", i, "] = ", depth[i], " must be finite and >= 0");
    if (depth[i] > 0 && !system.capped())
      fail(RC_ERR_ARGUMENT, "rc_state.indentation[", i, "] = ", depth[i], " but the system has no hardness");
  }
  if (std::all_of(depth.begin(), depth.end(), [](double value) { return value == 0; })) return {};
  return {depth, std::span(state.undeformed_gap, depth.size())};
}

}  // namespace

Contact::Contact(const rc_system& system, const rc_options& options, const Ranks* ranks)
    : grid_(system, options, nullptr, ranks) {
  grid_.leave_indentations();
  grid_.work().goal = goal_of(options);
  grid_.work().keeps_history = true;
}

void Contact::set_options(const rc_options& options) {
  grid_.set_options(options);
  grid_.work().goal = goal_of(options);
}

std::int64_t Contact::ask_stiffness(std::int64_t wanted) {
  rc_options& options = grid_.work().options;
  const std::int64_t before = options.integer(RC_OPT_STIFFNESS);
  options.set(RC_OPT_STIFFNESS, wanted);
  return before;
}

void Contact::begin(const rc_step& step) {
  grid_.begin(step);
  if (work().options.integer(RC_OPT_RESUMABLE) != 0) goal_.forget();
}

rc_status Contact::solve(const rc_step& step, rc_result& result) {
  OnHost host(grid_.work(), held_, step, result, false);
  begin(host.step);
  const Cancellation cancellation(*this);
  const rc_status status = solve_begun(host.step, host.result);
  host.give(result);
  return status;
}

rc_status Contact::solve_begun(const rc_step& step, rc_result& result) {
  Monitor monitor = grid_.monitor();
  // With a hardness the whole grid is solved: what the accuracy goal knows of errors holds for elastic contact.
  const bool coarser_may_do =
      work().goal.error > 0 && work().system.halfspace() && !work().system.capped() && !nothing_touches(step, work());
  std::optional<Estimate> nearer;
  if (coarser_may_do && goal_.solve(grid_, step, monitor, result, nearer)) return result.status;
  const rc_status status = grid_.solve_begun(step, monitor, result, std::move(nearer));
  if (coarser_may_do) {
    goal_.add_work(result);
    result.seconds = std::max(0.0, monitor.seconds() - result.setup_seconds);
  }
  return status;
}

rc_status Contact::certify(const rc_step& step, rc_result& result) {
  OnHost host(grid_.work(), held_, step, result, true);
  const rc_status status = grid_.certify(host.step, host.result);
  host.give(result);
  return status;
}

rc_status Contact::gradient(rc_gradient& gradient) {
  const Cancellation cancellation(*this);
  const Rest after(grid_.work());
  return differentiate(grid_.work(), memory(), grid_.monitor(), gradient);
}

rc_status Contact::tangent(rc_tangent& tangent) {
  const Cancellation cancellation(*this);
  const Rest after(grid_.work());
  return differentiate(grid_.work(), memory(), grid_.monitor(), tangent);
}

const std::string& Contact::explain() {
  const StepRecord& record = work().record;
  return explanation_ = record.choice.solver ? explained(work().options, work().system, record.choice, record.failed) : "";
}

void Contact::reset() {
  grid_.reset();
  goal_.clear();
  drop_copies();
}

void Contact::forget() {
  grid_.forget();
  goal_.forget();
  drop_copies();
}

// After the surface has been cleared.
void Contact::drop_copies() {
  grid_.work().gap_on_device = {};
  held_.clear();
}

void Contact::restore(const rc_state& state) {
  const System& system = work().system;
  const auto n = static_cast<std::size_t>(system.points());
  if (!state.undeformed_gap) fail(RC_ERR_ARGUMENT, "rc_state.undeformed_gap is null");
  if (!state.p && state.p_before) fail(RC_ERR_ARGUMENT, "rc_state.p is null but rc_state.p_before is not");
  const std::span<const double> gap(state.undeformed_gap, n);
  const std::span<const std::uint8_t> mask(state.mask, state.mask ? n : 0);
  Indentation indentation = indentation_of(state, system);
  const std::vector<double> indented = indentation.indented();
  StepSurface surface({system.given.nx, system.given.ny, indentation.none() ? GapValues(gap) : GapValues(indented), mask, false},
                      work().team());
  Memory memory = memory_of(state, surface, system.points());
  goal_.forget();
  grid_.restore(std::move(memory), std::move(surface), std::move(indentation));
  drop_copies();
}

}  // namespace rc
