#include "contact/calls/history.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "contact/calls/controls.h"
#include "contact/calls/step_outputs.h"
#include "core/error.h"
#include "core/host_call.h"

namespace rc {

namespace {

double target(const rc_history& history, std::int64_t i) { return values_of<double>(history.targets)[i]; }

double time_at(const rc_history& history, std::int64_t i) { return history.times.data ? values_of<double>(history.times)[i] : 0; }

void check_times(const rc_history& history) {
  if (history.n > 0 && !history.times.data)
    fail(RC_ERR_ARGUMENT, "rc_history.times is null but the system creeps; give the time of each step");
  for (std::int64_t i = 0; i < history.n; ++i) {
    if (!std::isfinite(time_at(history, i)))
      fail(RC_ERR_ARGUMENT, "rc_history.times[", i, "] = ", time_at(history, i), " is not finite");
    if (i > 0 && time_at(history, i) < time_at(history, i - 1))
      fail(RC_ERR_ARGUMENT, "rc_history.times[", i, "] = ", time_at(history, i), " is before that of the step before it, ",
           time_at(history, i - 1), "; times must not go back");
  }
}

void check_history(const rc_history& history) {
  if (history.n < 0) fail(RC_ERR_ARGUMENT, "rc_history.n = ", history.n, " must be >= 0");
  check_control(history.control, "rc_history.control");
  if (history.n > 0 && !history.targets.data) fail(RC_ERR_ARGUMENT, "rc_history.targets is null but rc_history.n = ", history.n);
  for (std::int64_t i = 0; i < history.n; ++i)
    if (!std::isfinite(target(history, i)))
      fail(RC_ERR_ARGUMENT, "rc_history.targets[", i, "] = ", target(history, i), " is not finite");
}

rc_step history_step(const rc_history& history, std::int64_t i) {
  rc_step step = RC_STEP_INIT;
  step.control = history.control;
  step.warm_start = history.warm_start;
  step.target = target(history, i);
  step.time = time_at(history, i);
  if (i == 0) {  // later steps keep the surface of the first
    step.undeformed_gap = history.undeformed_gap;
    step.mask = history.mask;
  }
  return step;
}

std::string where(const rc_history& history, std::int64_t i) {
  return join("step ", i, ", targets[", i, "] = ", target(history, i));
}

std::int32_t shown(const rc_history& history, std::int64_t i, const rc_result& result) {
  const HostsTurn turn;
  return history.fn(i, &result, history.user);
}

// While it lives, each step is asked for what the history wants.
class Asking {
 public:
  Asking(Contact& contact, const HistoryWants& wants) : contact_(contact), before_(asked(contact.problem())) {
    contact.ask(
        {std::max(before_.stiffness, wants.columns.stiffness), std::max(before_.bounds, wants.columns.bounds), !wants.virgin});
  }
  ~Asking() { contact_.ask(before_); }
  Asking(const Asking&) = delete;
  Asking& operator=(const Asking&) = delete;

 private:
  static Asked asked(const GridProblem& problem) {
    return {problem.options.integer(RC_OPT_STIFFNESS), problem.options.integer(RC_OPT_BOUNDS), problem.goal.changes_bodies};
  }

  Contact& contact_;
  const Asked before_;
};

}  // namespace

HistoryWants wants_of(const rc_history& history) {
  HistoryWants wants;
  wants.virgin = history.virgin != 0;
  wants.shown_gap = history.fn && history.want_gap != 0;
  wants.gap = wants.shown_gap || history.columns.mean_gap.data;
  wants.columns = wants_of(history.columns);
  return wants;
}

rc_status solve_history(Contact& contact, const rc_history& history, const HistoryWants& wants, std::int64_t& completed) {
  check_history(history);
  if (!contact.system().creep.empty()) check_times(history);
  if (history.n == 0) return RC_OK;
  // A cancellation between two steps must reach the next one, so it is cleared only when the history ends.
  const Cancellable cancellable(contact.watcher());
  const Asking asking(contact, wants);

  std::vector<double> p, gap;
  contact.problem().rows().on_all([&] {
    const auto points = static_cast<std::size_t>(contact.problem().own_points());
    p.resize(history.fn ? points : 0);
    gap.resize(wants.gap ? points : 0);
  });
  std::string within_goal;  // what the last step said that was within its goal
  for (std::int64_t i = 0; i < history.n; ++i) {
    const rc_step step = history_step(history, i);
    const Outputs outputs{{history.fn ? p.data() : nullptr}, {gap.empty() ? nullptr : gap.data()}};
    Numbers numbers;
    try {
      const Prepared prepared = contact.prepare(step);
      clear_message();
      numbers.status = RC_STOP_CANCELLED;
      if (!contact.problem().rows().any(cancellable.cancelled())) numbers = contact.solve_prepared(prepared, outputs);
    } catch (const Error& error) {
      fail(error.code(), where(history, i), ": ", error.what());
    }
    const rc_status status = numbers.status;
    if (status == RC_WITHIN_GOAL) within_goal = last_message();
    if (status != RC_OK && status != RC_WITHIN_GOAL) {
      set_message(where(history, i).c_str(), last_message()[0] != '\0' ? last_message() : rc_status_text(status));
      return status;
    }
    put_numbers(history.columns, i, numbers, contact.problem().system);
    completed = i + 1;
    if (!history.fn) continue;
    rc_result result = result_with({outputs.p, wants.shown_gap ? outputs.gap : OutputArray()});
    write(numbers, contact.problem().system, result);
    if (shown(history, i, result) != 0) {
      set_message(where(history, i).c_str(), "rc_history.fn ended the history after this step");
      return RC_STOP_CANCELLED;
    }
  }
  set_message(within_goal.c_str());
  return within_goal.empty() ? RC_OK : RC_WITHIN_GOAL;
}

}  // namespace rc
