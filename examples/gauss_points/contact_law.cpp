#include "contact_law.h"

#include <roughcontact/history.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <exception>
#include <thread>

namespace {

void check(rc_status status) {
  if (status != RC_OK && status != RC_WITHIN_GOAL) throw ContactLawError(rc_last_error());
}

}  // namespace

ContactLaw::ContactLaw(const rc_system& system, const std::vector<double>& heights, const Options& options) : system_(system) {
  if (heights.size() != static_cast<std::size_t>(system.nx * system.ny))
    throw ContactLawError("ContactLaw: " + std::to_string(heights.size()) + " heights for a grid of " +
                          std::to_string(system.nx) + " by " + std::to_string(system.ny));
  rc_options* created = nullptr;
  check(rc_options_create(nullptr, &created));
  options_.reset(created);
  check(rc_options_set_number(created, RC_OPT_STIFFNESS, 1));
  check(rc_options_set_number(created, RC_OPT_RESUMABLE, 1));  // between trials a contact keeps pressures and no factors
  check(rc_options_set_number(created, RC_OPT_TOL, 1e-10));
  for (const auto& [key, value] : options) check(rc_options_set_text(created, key.c_str(), value.c_str()));
  rc_contact* contact = nullptr;
  check(rc_contact_create(&system, created, &contact));
  contact_.reset(contact);
  const double highest = *std::max_element(heights.begin(), heights.end());
  gap_.reserve(heights.size());
  for (const double z : heights) gap_.push_back(highest - z);
  area_ = static_cast<double>(heights.size()) * system.hx * system.hy;
}

void ContactLaw::tabulate(double p_lower, double p_upper, double tolerance) {
  rc_law_spec spec = RC_LAW_SPEC_INIT;
  spec.undeformed_gap = RC_IN(gap_.data());
  spec.p_lower = p_lower;
  spec.p_upper = p_upper;
  spec.tolerance = tolerance;
  spec.bulk = bulk_stiffness_ > 0 ? RC_LAW_BULK_GIVEN : RC_LAW_BULK_NONE;
  spec.bulk_stiffness = bulk_stiffness_;
  rc_law* law = nullptr;
  const rc_status status = rc_law_create(&system_, options_.get(), &spec, &law);
  law_.reset(law);
  if (status != RC_UNCERTIFIED) check(status);  // then the tolerance is met by estimate
  rc_law_info info = RC_LAW_INFO_INIT;
  check(rc_law_describe(law, &info));
  law_from_ = info.x_lower;
  law_to_ = info.x_upper;
}

bool ContactLaw::law_holds(double displacement) const {
  const bool first_loading = displacement >= state_.deepest;
  return law_ && displacement >= law_from_ && displacement <= law_to_ && (first_loading || system_.hardness == 0);
}

// Presses the surface that the committed steps have left.
ContactLaw::Answer ContactLaw::press(double approach) {
  check(rc_contact_reset(contact_.get()));  // nothing of other trials is left
  const std::vector<double>* gap = &gap_;
  if (!state_.indentation.empty()) {
    indented_gap_ = gap_;
    for (std::size_t i = 0; i < gap_.size(); ++i) indented_gap_[i] += state_.indentation[i];
    gap = &indented_gap_;
  }
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.warm_start = 0;
  step.target = approach;
  step.undeformed_gap = RC_IN(gap->data());
  step.borrow = 1;  // it stays where it is until the next step
  step.p0 = RC_IN(state_.pressures.empty() ? nullptr : state_.pressures.data());
  trial_.pressures.resize(gap_.size());
  rc_result result = RC_RESULT_INIT;
  result.p = RC_OUT(trial_.pressures.data());
  check(rc_contact_solve(contact_.get(), &step, &result));
  return {result.load, result.stiffness, result.contact_area};
}

ContactLaw::Answer ContactLaw::evaluate(double displacement) {
  trial_ = state_;
  if (!(displacement > 0)) {
    trial_.pressures.clear();
    return {};
  }
  if (law_holds(displacement)) {
    rc_law_point point = RC_LAW_POINT_INIT;
    check(rc_law_evaluate(law_.get(), displacement, &point));
    trial_.deepest = std::max(state_.deepest, displacement);
    return {point.p * area_, point.slope * area_, point.area_fraction * area_, true};
  }
  if (system_.hardness == 0) return solve(displacement);
  const auto indent = [this](double deepest) {  // by the step that has been solved
    std::vector<double> indentation(gap_.size());
    check(rc_contact_indentation(contact_.get(), RC_OUT(indentation.data())));
    trial_.indentation = state_.indentation;
    trial_.indentation.resize(gap_.size());
    for (std::size_t i = 0; i < gap_.size(); ++i) trial_.indentation[i] += indentation[i];
    trial_.deepest = trial_.indented = deepest;
  };
  if (state_.indented < state_.deepest) {  // loading by the law has left no indentation yet
    solve(state_.deepest);
    indent(state_.deepest);
    state_ = trial_;
  }
  const Answer answer = solve(displacement);
  indent(std::max(state_.deepest, displacement));
  return answer;
}

// With a bulk stiffness k the approach d solves d - F(d)/k = displacement. F is convex, so Newton's method from below goes up to
// the solution, and the tangent follows from the same equation.
ContactLaw::Answer ContactLaw::solve(double displacement) {
  Answer answer = press(displacement);
  if (bulk_stiffness_ == 0) return answer;
  double approach = displacement;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double slope = 1 - answer.tangent / bulk_stiffness_;
    const double excess = approach - answer.force / bulk_stiffness_ - displacement;
    if (!(slope > 1e-3)) break;
    if (std::abs(excess) <= 1e-9 * approach) return {answer.force, answer.tangent / slope, answer.contact_area};
    approach -= excess / slope;
    answer = press(approach);
  }
  char message[200];
  std::snprintf(
      message, sizeof message,
      "ContactLaw: at displacement %g the patch is as stiff as the bulk that is subtracted, %g: it is closed; press less",
      displacement, bulk_stiffness_);
  throw ContactLawError(message);
}

std::vector<ContactLaw::Answer> evaluate_all(std::vector<ContactLaw>& laws, const std::vector<double>& displacements,
                                             int threads) {
  std::vector<ContactLaw::Answer> answers(laws.size());
  std::vector<std::exception_ptr> failures(laws.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < laws.size(); i = next++) {
      try {
        answers[i] = laws[i].evaluate(displacements.at(i));
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  const std::size_t count = std::min<std::size_t>(static_cast<std::size_t>(std::max(threads, 1)), laws.size());
  std::vector<std::thread> others;
  try {
    others.reserve(count);
    while (others.size() + 1 < count) others.emplace_back(work);
  } catch (const std::exception&) {
    // The system gives no more threads: those that are there do the work.
  }
  work();
  for (std::thread& other : others) other.join();
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
  return answers;
}
