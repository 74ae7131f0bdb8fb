#include "contact/step/solve.h"

#include <algorithm>
#include <string>
#include <utility>

#include "contact/operators.h"
#include "contact/step/sparse_by_rows.h"
#include "contact/step/sparse_contact.h"
#include "contact/step/whole_contact.h"
#include "core/error.h"

namespace rc {

namespace {

// Passes over this component in the next attempt, if "auto" may choose another one. Returns whether that is so.
bool pass_over(const GridProblem& problem, const std::string& name, const char* option, const std::string& reason,
               Attempt& attempt) {
  if (!problem.company().may_pass_over() || problem.options.text(option) != "auto" ||
      problem.options.integer(RC_OPT_ALLOW_FALLBACK) == 0 || name == problem.options.text(RC_OPT_CERTIFY_BACKEND) ||
      std::ranges::find(attempt.failed, name) != attempt.failed.end())
    return false;
  attempt.failed.push_back(name);
  try {
    choose(problem.options, problem.system, {}, attempt.failed);
  } catch (const Error&) {
    attempt.failed.pop_back();
    return false;
  }
  attempt.skipped.add(join("auto: skipped ", name, ": ", reason));
  return true;
}

// The same for the component that an error names.
bool pass_over(const GridProblem& problem, const Error& error, Attempt& attempt) {
  const AtFault& at_fault = error.at_fault();
  const bool device = error.code() == RC_ERR_EXTERNAL && problem.system.halfspace();  // which calls nothing of the caller's
  const bool lacking =
      device || error.code() == RC_ERR_MEMORY || error.code() == RC_ERR_PLUGIN || error.code() == RC_ERR_INCOMPATIBLE;
  if (!lacking || at_fault.backend.empty()) return false;
  // A solver that has a device of its own may fail with every backend.
  if (!at_fault.solver.empty() && (device || problem.options.text(RC_OPT_SOLVER) == "auto"))
    return pass_over(problem, at_fault.solver, RC_OPT_SOLVER, error.what(), attempt);
  if (!pass_over(problem, at_fault.backend, RC_OPT_BACKEND, error.what(), attempt)) return false;
  problem.operators().drop(at_fault.backend.c_str());
  return true;
}

StepResult solve_and_certify(const GridProblem& problem, const Memory& memory, const Step& step, const Outputs& outputs,
                             const std::optional<Estimate>& nearer, Attempt& attempt) {
  const Target& target = step.target;
  if (!target.touches(problem.surface)) return certify_and_write(problem, target, {}, attempt, outputs);
  const Start start(memory, step);
  std::optional<Choice> few;
  if (!start.given()) few = choose_for_few(problem, target.control);
  if (problem.rows().shared()) {
    if (std::optional<StepResult> all = sparse_by_rows(problem, target, start, few, attempt, outputs)) return std::move(*all);
    few.reset();
  }
  Pyramid pyramid(problem, target, attempt.monitor);
  const auto solved = [&]() -> Answer {
    SparseContact sparse{{}, nearer};
    if (few && nearer) sparse.answer = sparse_contact_near(*nearer, problem, target, *few, attempt);
    if (few && !nearer) sparse = sparse_contact(problem, target, start, *few, pyramid, attempt);
    if (sparse.answer) return std::move(*sparse.answer);
    return whole_contact(problem, target, start, attempt, std::move(sparse.instead));
  };
  std::optional<Error> first;           // why "auto" passed over the first backend
  std::optional<StepResult> delivered;  // an answer that is not certified: the caller's arrays hold it if nothing better follows
  for (;;) {
    try {
      StepResult found = certify_and_write(problem, target, solved(), attempt, outputs);
      const rc_status status = found.numbers.status;
      const bool hopeless = status == RC_STOP_STALLED || status == RC_UNCERTIFIED;
      const std::string reason = hopeless ? join("which ended with: ", rc_status_text(status)) : "";
      if (!hopeless || !pass_over(problem, found.by.solver->name, RC_OPT_SOLVER, reason, attempt)) return found;
      delivered = StepResult{.numbers = found.numbers, .by = found.by};
      clear_message();
    } catch (const Error& error) {
      if (pass_over(problem, error, attempt)) {
        if (!first) first = error;
        continue;
      }
      if (pyramid.climbing() && error.code() != RC_ERR_MEMORY) {  // the given grid may succeed where a coarser one failed
        pyramid.give_up();
        continue;
      }
      if (!delivered && first) fail(first->code(), first->what(), "; the next choice of auto failed, too: ", error.what());
      if (!delivered) throw;
      set_message(join(rc_status_text(delivered->numbers.status), "; the next choice of auto failed: ", error.what()).c_str());
      return std::move(*delivered);
    }
  }
}

}  // namespace

Solved solve_step(const GridProblem& problem, const Memory& memory, const Step& step, Monitor& monitor, const Outputs& outputs,
                  const std::optional<Estimate>& nearer) {
  Attempt attempt{monitor, step.warm};
  StepResult answer = solve_and_certify(problem, memory, step, outputs, nearer, attempt);
  const Choice by = answer.by;
  return {std::move(answer), {by, std::move(attempt.failed)}};
}

}  // namespace rc
