#include "request/budget/solves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace rc::request {

namespace {

// The library's message without the name of the function.
std::string_view last_text() {
  const std::string_view message = rc_last_error();
  return message.substr(std::min(message.size(), message.find(": ") + 2));
}

void check_call(rc_status status) {
  if (status < 0) fail(status, last_text());
}

std::int32_t tell(const rc_progress*, void* user) {
  const auto& progress = *static_cast<Progress*>(user);
  const rc_budget_spec& spec = progress.spec;
  return spec.progress ? spec.progress(progress.ended, progress.all, spec.user) : 0;
}

}  // namespace

double Pressing::highest() const {
  double most = -std::numeric_limits<double>::infinity();
  for (const double each : z)
    if (each > most) most = each;
  return most;
}

Pressing pressing(const rc_request& request, bool of_gap) {
  const rc_problem_view& view = request.view;
  const rc_system& system = view.system;
  Pressing made{system, {}, {}, RC_CONTROL_PRESSURE, request.targets.back()};
  made.z.assign(view.heights, view.heights + system.nx * system.ny);
  for (std::size_t i = 0; i < made.z.size(); ++i) {
    if (of_gap) made.z[i] = -made.z[i];
    if (view.mask && view.mask[i] == 0) made.z[i] = std::nan("");
  }
  if (of_gap) made.datum = 0;
  if (request.loading == "approach") made.control = RC_CONTROL_APPROACH;
  if (request.loading == "load") made.control = RC_CONTROL_LOAD;
  if (request.loading == "area") {
    made.control = RC_CONTROL_AREA;
    made.target *= static_cast<double>(system.nx * system.ny) * system.hx * system.hy;
  }
  return made;
}

Options options_of(const rc_budget_spec& spec, rc_context* context, const rc_request& request, bool proven) {
  rc_options* made = nullptr;
  check_call(spec.options ? rc_options_copy(spec.options, &made) : rc_options_create(context, &made));
  Options options{made, rc_options_destroy};
  for (const auto& [key, text] : request.options) check_call(rc_options_set_text(made, key.c_str(), text.c_str()));
  check_call(rc_options_set_number(made, RC_OPT_STIFFNESS, proven ? 2 : 1));
  check_call(rc_options_set_number(made, RC_OPT_BOUNDS, proven ? 1 : 0));
  return options;
}

Press::Press(const rc_system& system, const rc_options* options, Progress& progress) : progress_(progress) {
  rc_contact* made = nullptr;
  check_call(rc_contact_create(&system, options, &made));
  contact_.reset(made);
  check_call(rc_contact_on_progress(made, tell, &progress_, 1));
}

Outcome Press::solve(const Pressing& problem, const char* what) {
  if (problem.system.hardness > 0) check_call(rc_contact_reset(contact_.get()));  // indentations of other solves
  const std::size_t n = problem.z.size();
  const double datum = problem.datum.value_or(problem.highest());
  std::vector<double> gap(n);
  std::vector<std::uint8_t> mask(n);
  for (std::size_t i = 0; i < n; ++i) {
    mask[i] = std::isnan(problem.z[i]) ? 0 : 1;
    gap[i] = datum - problem.z[i];
  }
  deformed_.resize(n);
  rc_step step = RC_STEP_INIT;
  step.control = problem.control;
  step.target = problem.target;
  step.undeformed_gap = RC_IN(gap.data());
  step.mask = RC_IN(mask.data());
  step.borrow = 1;
  result_ = RC_RESULT_INIT;
  result_.gap = RC_OUT(deformed_.data());
  if (progress_.spec.value) {
    pressures_.resize(n);
    result_.p = RC_OUT(pressures_.data());
  }
  if (tell(nullptr, &progress_) != 0) throw Stopped{RC_STOP_CANCELLED};
  const rc_status status = rc_contact_solve(contact_.get(), &step, &result_);
  gap_ = std::move(gap);  // which the contact borrows, as it does the mask
  mask_ = std::move(mask);
  if (status == RC_STOP_CANCELLED || status == RC_STOP_TIME) throw Stopped{status};
  if (status < 0) fail(status, what, ": ", last_text());
  if (status != RC_OK && status != RC_WITHIN_GOAL) fail(RC_ERR_NUMERIC, what, ": the solve is not certified (", last_text(), ")");
  ++progress_.ended;
  Outcome found;
  found[of::load] = result_.load;
  found[of::approach] = result_.approach;
  found[of::area] = result_.area_fraction;
  found[of::mean_pressure] = result_.mean_pressure;
  found[of::stiffness] = result_.stiffness;
  found[of::mean_gap] = result_.mean_gap;
  const bool yields = problem.system.hardness > 0 && std::isfinite(problem.system.hardness);  // and conducts without stiffness
  found[of::conductance] = result_.homogeneous == 1 && !yields ? 2 * result_.stiffness / problem.system.modulus : std::nan("");
  found[of::further] = progress_.spec.value ? further(problem) : std::nan("");
  return found;
}

double Press::further(const Pressing& problem) {
  const rc_budget_spec& spec = progress_.spec;
  double value = std::nan("");
  further_lower_ = further_upper_ = value;
  if (spec.value(&problem.system, &result_, mask_.data(), spec.user, &value, &further_lower_, &further_upper_) != 0)
    fail(RC_ERR_EXTERNAL, "the caller's function of ", spec.value_name, " has ended the budget");
  return value;
}

std::vector<double> Press::derivative(const Pressing& problem, bool of_mean_gap) {
  if (result_.status != RC_OK || problem.control == RC_CONTROL_AREA || problem.system.hardness > 0) return {};
  const std::size_t n = problem.z.size();
  const auto known = static_cast<double>(std::ranges::count_if(problem.z, [](double z) { return !std::isnan(z); }));
  std::vector<double> weights(of_mean_gap ? n : 0, 1 / known), found(n);
  rc_gradient gradient = RC_GRADIENT_INIT;
  if (of_mean_gap) gradient.dJ_dgap = RC_IN(weights.data());
  gradient.dJ_dundeformed_gap = RC_OUT(found.data());
  const rc_status status = rc_contact_gradient(contact_.get(), &gradient);
  if (status == RC_STOP_CANCELLED || status == RC_STOP_TIME) throw Stopped{status};
  if (status < 0) return {};
  // The gap is datum - z: a change of the highest point changes all gaps.
  double sum = 0;
  for (double& each : found) {
    sum += each;
    each = -each;
  }
  if (!problem.datum) {
    const double highest = problem.highest();
    found[static_cast<std::size_t>(std::ranges::find(problem.z, highest) - problem.z.begin())] += sum;
  }
  return found;
}

}  // namespace rc::request
