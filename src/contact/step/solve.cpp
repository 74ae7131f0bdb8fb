#include "contact/step/solve.h"

#include <string>
#include <utility>

#include "contact/sparse/shared_sparse_contact.h"
#include "contact/sparse/sparse_contact.h"
#include "contact/step/approach.h"
#include "contact/step/by_load.h"
#include "core/error.h"

namespace rc {

namespace {

// Whether "auto" may pass over this component; if so, notes that it did.
bool pass_over(Workspace& work, const char* name, const char* option, const std::string& reason) {
  if (work.ranks() || work.alike() || !work.passes_over || work.options.text(option) != "auto" ||
      work.options.integer(RC_OPT_ALLOW_FALLBACK) == 0)
    return false;
  work.record.failed.emplace_back(name);
  try {
    choose(work.options, work.system, {}, work.record.failed);
  } catch (const Error&) {
    return false;
  }
  work.record.remarks.push_back(join("auto: passed over ", name, ", ", reason));
  return true;
}

Answer answer_of(Workspace& work, const Memory& memory, const rc_step& step, Monitor& monitor,
                 const std::optional<Estimate>& nearer) {
  std::optional<Estimate> estimate = nearer;
  if (std::optional<Answer> sparse = sparse_contact(work, memory, step, monitor, estimate)) return std::move(*sparse);
  return step.control == RC_CONTROL_LOAD ? at_load(work, memory, step, monitor, std::move(estimate))
                                         : at_approach(work, memory, step, monitor, std::move(estimate));
}

}  // namespace

Finished solve_step(Workspace& work, const Memory& memory, const rc_step& step, Monitor& monitor, rc_result& result,
                    std::optional<Estimate> nearer) {
  if (std::optional<Finished> sparse = shared_sparse_contact(work, memory, step, monitor, result)) return std::move(*sparse);
  const Choice& choice = work.record.choice;
  std::optional<Error> first;  // why "auto" passed over the first backend
  bool delivered = false;      // an answer that is not certified: the caller's arrays hold it if nothing better follows
  for (;;) {
    work.record.choice = {};
    work.record.by_solver = false;
    try {
      Finished finished = certified_result(work, step, answer_of(work, memory, step, monitor, nearer), monitor, result);
      const rc_status status = finished.status;
      const bool hopeless = status == RC_STOP_STALLED || status == RC_UNCERTIFIED;
      if (!hopeless || !pass_over(work, choice.solver->name, RC_OPT_SOLVER, join("which ended with: ", rc_status_text(status))))
        return finished;
      delivered = true;
      clear_message();
    } catch (const Error& error) {
      const bool device = error.code() == RC_ERR_EXTERNAL && work.system.halfspace();  // which calls nothing of the caller's
      const bool lacking =
          device || error.code() == RC_ERR_MEMORY || error.code() == RC_ERR_PLUGIN || error.code() == RC_ERR_INCOMPATIBLE;
      // A solver that has a device of its own may fail with every backend.
      const bool by_solver = work.record.by_solver && (device || work.options.text(RC_OPT_SOLVER) == "auto");
      const bool passed = lacking && choice.backend &&
                          (by_solver ? pass_over(work, choice.solver->name, RC_OPT_SOLVER, error.what())
                                     : pass_over(work, choice.backend->name, RC_OPT_BACKEND, error.what()));
      if (passed) {
        if (!by_solver) work.drop_operator(choice.backend->name);
        if (!first) first = error;
        continue;
      }
      if (!delivered && first) fail(first->code(), first->what(), "; the next choice of auto failed, too: ", error.what());
      if (!delivered) throw;
      set_message(join(rc_status_text(result.status), "; the next choice of auto failed: ", error.what()).c_str());
      return {result.status, {}};
    }
  }
}

}  // namespace rc
