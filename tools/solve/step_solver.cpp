#include "solve/step_solver.h"

#include <roughcontact/history.h>

#include "text.h"

namespace cli {

StepSolver::StepSolver(rc_contact* contact, const Problem& problem)
    : contact_(contact), problem_(problem), gap_(problem.input.surface.heights.begin(), problem.input.surface.heights.end()) {
  check(rc_gap_from_heights(static_cast<std::int64_t>(gap_.size()), RC_IN(gap_.data()), {}, RC_OUT(gap_.data())), "");
}

void StepSolver::restore(const std::vector<CertifiedStep>& certified, const std::vector<double>& indentation, const Left& left) {
  rc_state state = RC_STATE_INIT;
  state.undeformed_gap = RC_IN(gap_.data());
  state.mask = RC_IN(problem_.input.mask);
  if (!certified.empty()) {
    state.p = RC_IN(certified[0].pressure.data());
    state.approach = certified[0].approach;
    state.load = certified[0].load;
  }
  if (certified.size() > 1) {
    state.p_before = RC_IN(certified[1].pressure.data());
    state.approach_before = certified[1].approach;
    state.load_before = certified[1].load;
  }
  if (!indentation.empty()) state.indentation = RC_IN(indentation.data());
  if (!left.creep.empty()) state.creep = RC_IN(left.creep.data());
  state.time = left.time;
  check(rc_contact_restore(contact_, &state), "--resume");
  gap_given_ = true;
}

StepRecord StepSolver::solve(int number, Fields& fields) {
  rc_step step = RC_STEP_INIT;
  step.control = problem_.step_control();
  step.target = problem_.step_target(static_cast<std::size_t>(number - 1));
  step.undeformed_gap.data = gap_given_ ? nullptr : gap_.data();
  step.mask.data = gap_given_ ? nullptr : problem_.input.mask;
  step.time = problem_.step_time(static_cast<std::size_t>(number - 1));
  step.borrow = 1;
  gap_given_ = true;

  StepRecord record{number, RC_RESULT_INIT, {}, {}};
  record.result.p.data = fields.pressure.data();
  record.result.gap.data = fields.gap.data();
  const rc_status status = rc_contact_solve(contact_, &step, &record.result);
  if (status > 0) record.message = last_message();
  check(status, format("step %d", number));
  if (!fields.indentation.empty()) check(rc_contact_indentation(contact_, RC_OUT(fields.indentation.data())), "");
  if (!fields.creep.empty()) check(rc_contact_creep(contact_, RC_OUT(fields.creep.data()), nullptr), "");
  record.measures = measure(problem_, fields.pressure);
  return record;
}

}  // namespace cli
