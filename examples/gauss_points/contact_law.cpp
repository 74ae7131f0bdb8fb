#include "contact_law.h"

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

struct DestroyOptions {
  void operator()(rc_options* options) const { rc_options_destroy(options); }
};

}  // namespace

ContactLaw::ContactLaw(const rc_system& system, const std::vector<double>& heights, const Options& options) {
  if (heights.size() != static_cast<std::size_t>(system.nx * system.ny))
    throw ContactLawError("ContactLaw: " + std::to_string(heights.size()) + " heights for a grid of " +
                          std::to_string(system.nx) + " by " + std::to_string(system.ny));
  rc_options* created = nullptr;
  check(rc_options_create(nullptr, &created));
  const std::unique_ptr<rc_options, DestroyOptions> checked(created);
  check(rc_options_set_int(created, RC_OPT_STIFFNESS, 1));
  check(rc_options_set_int(created, RC_OPT_RESUMABLE, 1));  // between trials a contact keeps pressures and no factors
  check(rc_options_set_real(created, RC_OPT_TOL, 1e-10));
  for (const auto& [key, value] : options) check(rc_options_parse(created, key.c_str(), value.c_str()));
  rc_contact* contact = nullptr;
  check(rc_contact_create(&system, created, &contact));
  contact_.reset(contact);
  const double highest = *std::max_element(heights.begin(), heights.end());
  gap_.reserve(heights.size());
  for (const double z : heights) gap_.push_back(highest - z);
  area_ = static_cast<double>(heights.size()) * system.hx * system.hy;
}

ContactLaw::Answer ContactLaw::press(double approach) {
  check(rc_contact_reset(contact_.get()));  // nothing of other trials is left
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.warm_start = 0;
  step.target = approach;
  step.undeformed_gap.data = gap_.data();
  step.borrow = 1;  // gap_ stays where it is while the law lives
  step.p0.data = state_.empty() ? nullptr : state_.data();
  trial_.resize(gap_.size());
  rc_result result = RC_RESULT_INIT;
  result.p.data = trial_.data();
  check(rc_contact_solve(contact_.get(), &step, &result));
  return {result.load, result.stiffness, result.contact_area};
}

// With a bulk stiffness k the approach d solves d - F(d)/k = displacement. F is convex, so Newton's method from below goes up to
// the solution, and the tangent follows from the same equation.
ContactLaw::Answer ContactLaw::evaluate(double displacement) {
  if (!(displacement > 0)) {
    trial_.clear();
    return {};
  }
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
