#include "contact/history/path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/ranks.h"

namespace rc {

namespace {

void check_path(const rc_path& path) {
  if (path.n < 0) fail(RC_ERR_ARGUMENT, "rc_path.n = ", path.n, " must be >= 0");
  if (path.control != RC_CONTROL_DISPLACEMENT && path.control != RC_CONTROL_LOAD)
    fail(RC_ERR_ARGUMENT, "rc_path.control = ", path.control, " is neither RC_CONTROL_DISPLACEMENT (1) nor RC_CONTROL_LOAD (2)");
  if (path.n > 0 && !path.targets) fail(RC_ERR_ARGUMENT, "rc_path.targets is null but rc_path.n = ", path.n);
  for (std::int64_t i = 0; i < path.n; ++i)
    if (!std::isfinite(path.targets[i])) fail(RC_ERR_ARGUMENT, "rc_path.targets[", i, "] = ", path.targets[i], " is not finite");
}

rc_step step_of(const rc_path& path, std::int64_t i) {
  rc_step step = RC_STEP_INIT;
  step.control = path.control;
  step.warm_start = path.warm_start;
  step.target = path.targets[i];
  if (i == 0) {  // later steps keep the surface of the first
    step.undeformed_gap = path.undeformed_gap;
    step.mask = path.mask;
  }
  return step;
}

template <class Number> void put(Number* to, std::int64_t i, Number value) {
  if (to) to[i] = value;
}

void write_outputs(const rc_path& path, std::int64_t i, const rc_result& result) {
  put(path.load, i, result.load);
  put(path.approach, i, result.approach);
  put(path.contact_area, i, result.contact_area);
  put(path.stiffness, i, result.stiffness);
  put(path.certificate, i, std::max({result.kkt_primal, result.kkt_dual, result.kkt_complementarity, result.kkt_control}));
  put(path.applications, i, result.applications);
}

std::string where(const rc_path& path, std::int64_t i) { return join("step ", i, ", targets[", i, "] = ", path.targets[i]); }

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

rc_status solve_path(Contact& contact, const rc_path& path, std::int64_t& completed) {
  check_path(path);
  if (path.n == 0) return RC_OK;
  // A cancellation between two steps must reach the next one, so it is cleared only when the path ends.
  const Contact::Cancellation cancellation(contact);
  std::optional<StiffnessAsked> stiffness;
  if (path.stiffness) stiffness.emplace(contact);

  std::vector<double> p, gap;
  on_all(contact.work().ranks(), [&] {
    p.resize(path.fn ? static_cast<std::size_t>(contact.work().own_points()) : 0);
    gap.resize(p.size());
  });
  std::string within_goal;  // what the last step said that was within its goal
  for (std::int64_t i = 0; i < path.n; ++i) {
    const rc_step step = step_of(path, i);
    rc_result result{};
    result.struct_size = sizeof(rc_result);
    result.p = path.fn ? p.data() : nullptr;
    result.gap = path.fn ? gap.data() : nullptr;
    rc_status status = RC_OK;
    try {
      contact.begin(step);
      clear_message();
      status = cancellation.requested() ? RC_STOP_CANCELLED : contact.solve_begun(step, result);
    } catch (const Error& error) {
      fail(error.code(), where(path, i), ": ", error.what());
    }
    if (status == RC_WITHIN_GOAL) within_goal = last_message();
    if (status != RC_OK && status != RC_WITHIN_GOAL) {
      set_message(where(path, i).c_str(), last_message()[0] != '\0' ? last_message() : rc_status_text(status));
      return status;
    }
    write_outputs(path, i, result);
    completed = i + 1;
    if (path.fn && path.fn(i, &result, path.user) != 0) {
      set_message(where(path, i).c_str(), "rc_path.fn ended the path after this step");
      return RC_STOP_CANCELLED;
    }
  }
  set_message(within_goal.c_str());
  return within_goal.empty() ? RC_OK : RC_WITHIN_GOAL;
}

}  // namespace rc
