#include "contact/calls/history.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"

namespace rc {

namespace {

void check_history(const rc_history& history) {
  if (history.n < 0) fail(RC_ERR_ARGUMENT, "rc_history.n = ", history.n, " must be >= 0");
  if (history.control != RC_CONTROL_APPROACH && history.control != RC_CONTROL_LOAD)
    fail(RC_ERR_ARGUMENT, "rc_history.control = ", history.control,
         " is neither RC_CONTROL_APPROACH (1) nor RC_CONTROL_LOAD (2)");
  if (history.n > 0 && !history.targets) fail(RC_ERR_ARGUMENT, "rc_history.targets is null but rc_history.n = ", history.n);
  for (std::int64_t i = 0; i < history.n; ++i)
    if (!std::isfinite(history.targets[i]))
      fail(RC_ERR_ARGUMENT, "rc_history.targets[", i, "] = ", history.targets[i], " is not finite");
}

rc_step history_step(const rc_history& history, std::int64_t i) {
  rc_step step = RC_STEP_INIT;
  step.control = history.control;
  step.warm_start = history.warm_start;
  step.target = history.targets[i];
  if (i == 0) {  // later steps keep the surface of the first
    step.undeformed_gap.data = history.undeformed_gap;
    step.mask.data = history.mask;
  }
  return step;
}

template <class Number> void put(Number* to, std::int64_t i, Number value) {
  if (to) to[i] = value;
}

void write_outputs(const rc_history& history, std::int64_t i, const Numbers& numbers, const System& system) {
  put(history.load, i, numbers.load(system));
  put(history.approach, i, numbers.approach);
  put(history.contact_area, i, numbers.contact_area(system));
  put(history.stiffness, i, numbers.stiffness.value);
  put(history.certificate, i, numbers.certificate.worst());
  put(history.products, i, numbers.work.products);
}

std::string where(const rc_history& history, std::int64_t i) {
  return join("step ", i, ", targets[", i, "] = ", history.targets[i]);
}

// While it lives, every step computes the stiffness, whatever the option says.
class StiffnessAsked {
 public:
  explicit StiffnessAsked(Contact& contact) : contact_(contact), before_(contact.ask_stiffness(1)) {
    if (before_ > 1) contact.ask_stiffness(before_);
  }
  ~StiffnessAsked() { contact_.ask_stiffness(before_); }
  StiffnessAsked(const StiffnessAsked&) = delete;
  StiffnessAsked& operator=(const StiffnessAsked&) = delete;

 private:
  Contact& contact_;
  const std::int64_t before_;
};

}  // namespace

rc_status solve_history(Contact& contact, const rc_history& history, std::int64_t& completed) {
  check_history(history);
  if (history.n == 0) return RC_OK;
  // A cancellation between two steps must reach the next one, so it is cleared only when the history ends.
  const Contact::Cancellation cancellation(contact);
  std::optional<StiffnessAsked> stiffness;
  if (history.stiffness) stiffness.emplace(contact);

  std::vector<double> p, gap;
  contact.problem().company().on_all([&] {
    p.resize(history.fn ? static_cast<std::size_t>(contact.problem().own_points()) : 0);
    gap.resize(history.want_gap != 0 ? p.size() : 0);
  });
  std::string within_goal;  // what the last step said that was within its goal
  for (std::int64_t i = 0; i < history.n; ++i) {
    const rc_step step = history_step(history, i);
    const Outputs outputs{{history.fn ? p.data() : nullptr}, {gap.empty() ? nullptr : gap.data()}};
    Numbers numbers;
    try {
      const Step begun = contact.begin(step);
      clear_message();
      numbers.status = RC_STOP_CANCELLED;
      if (!cancellation.requested()) numbers = contact.solve_begun(begun, outputs);
    } catch (const Error& error) {
      fail(error.code(), where(history, i), ": ", error.what());
    }
    const rc_status status = numbers.status;
    if (status == RC_WITHIN_GOAL) within_goal = last_message();
    if (status != RC_OK && status != RC_WITHIN_GOAL) {
      set_message(where(history, i).c_str(), last_message()[0] != '\0' ? last_message() : rc_status_text(status));
      return status;
    }
    write_outputs(history, i, numbers, contact.problem().system);
    completed = i + 1;
    if (!history.fn) continue;
    rc_result result = result_with(outputs);
    write(numbers, contact.problem().system, result);
    if (history.fn(i, &result, history.user) != 0) {
      set_message(where(history, i).c_str(), "rc_history.fn ended the history after this step");
      return RC_STOP_CANCELLED;
    }
  }
  set_message(within_goal.c_str());
  return within_goal.empty() ? RC_OK : RC_WITHIN_GOAL;
}

}  // namespace rc
