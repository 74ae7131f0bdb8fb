// Lets the k-th allocation fail, k = 1, 2, ... until all succeed. Every call must then return RC_ERR_MEMORY or succeed, write
// nothing when it failed, lose nothing, and leave its objects fit for another try.
#include <roughcontact/derivatives.h>
#include <roughcontact/history.h>
#include <roughcontact/registry.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "support/cmocka.hpp"
#include "support/failing_new.h"
#include "support/unit_system.h"

namespace {

constexpr std::int64_t nx = 7, ny = 6, points = nx * ny;
constexpr double poison = -4321, hardness = 0.05;

struct Job {
  const char *name, *solver, *backend;
  std::int32_t op, boundary;
  double hardness = 0;
};

std::int32_t apply(const double* x, double* y, std::int64_t n, void*) {
  for (std::int64_t i = 0; i < n; ++i) y[i] = 2 * x[i] + (i > 0 ? 0.5 * x[i - 1] : 0) + (i + 1 < n ? 0.5 * x[i + 1] : 0);
  return 0;
}

struct Given {
  std::vector<double> gap, dense;
  rc_system system = support::unit_system();

  explicit Given(const Job& job) : gap(points), dense(points * points, 0.05) {
    for (std::int64_t i = 0; i < points; ++i) {
      const double x = static_cast<double>(i % nx) - 3, y = static_cast<double>(i / nx) - 2.5;
      gap[static_cast<std::size_t>(i)] = 0.03 * (x * x + y * y);
      dense[static_cast<std::size_t>(i * points + i)] = 1;
    }
    system.op = job.op;
    system.boundary = job.boundary;
    system.nx = nx;
    system.ny = ny;
    system.dense = dense.data();
    system.dense_ld = points;
    system.apply = apply;
    system.hardness = job.hardness;
  }
};

bool poisoned(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value == poison; });
}

struct Answer {
  std::vector<double> p = std::vector<double>(points, poison), gap = p;
  rc_result result{};

  Answer() {
    result = RC_RESULT_INIT;
    result.p.data = p.data();
    result.gap.data = gap.data();
  }
  bool untouched() const { return poisoned(p) && poisoned(gap) && result.points == 0; }
};

// The derivatives of a step, with all that can be asked for.
struct Derivatives {
  std::vector<double> given = std::vector<double>(points, 0.1), by_gap = std::vector<double>(points, poison), dp = by_gap,
                      dgap = dp;
  rc_gradient gradient = RC_GRADIENT_INIT;
  rc_tangent tangent = RC_TANGENT_INIT;

  Derivatives() {
    gradient.dJ_dp = gradient.dJ_dgap = RC_IN(given.data());
    gradient.dJ_dundeformed_gap = RC_OUT(by_gap.data());
    tangent.dundeformed_gap = RC_IN(given.data());
    tangent.dp = RC_OUT(dp.data());
    tangent.dgap = RC_OUT(dgap.data());
  }
  bool no_gradient() const { return poisoned(by_gap) && gradient.products == 0; }
  bool no_tangent() const { return poisoned(dp) && poisoned(dgap) && tangent.products == 0; }
};

// A life of a contact, call by call, up to the first that fails. Allocations of the test itself do not count.
class Life {
 public:
  Life(const Job& job, rc_context* context) : job_(job), given_(job), context_(context) {}
  ~Life() {
    rc_contact_destroy(contact_);
    rc_options_destroy(options_);
  }
  Life(const Life&) = delete;
  Life& operator=(const Life&) = delete;

  rc_status live() {
    if (!options_ && failed(rc_options_create(context_, &options_))) return status_;
    if (failed(rc_options_set_text(options_, RC_OPT_SOLVER, job_.solver)) ||
        failed(rc_options_set_text(options_, RC_OPT_BACKEND, job_.backend)))
      return status_;
    if (!contact_ && failed(rc_contact_create(&given_.system, options_, &contact_))) return status_;
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.undeformed_gap.data = given_.gap.data();
    step.target = 0.2;
    if (failed(rc_contact_solve(contact_, &step, &pressed_.result)) && left(pressed_.untouched(), "solve")) return status_;
    if (failed(rc_options_set_number(options_, RC_OPT_STIFFNESS, 2)) || failed(rc_contact_set_options(contact_, options_)))
      return status_;
    step.control = RC_CONTROL_LOAD;
    step.target = 0.5 * pressed_.result.load;
    step.undeformed_gap.data = nullptr;
    if (failed(rc_contact_solve(contact_, &step, &loaded_.result)) && left(loaded_.untouched(), "solve by load")) return status_;
    if (failed(rc_contact_gradient(contact_, &change_.gradient)) && left(change_.no_gradient(), "gradient")) return status_;
    if (failed(rc_contact_tangent(contact_, &change_.tangent)) && left(change_.no_tangent(), "tangent")) return status_;
    std::copy(loaded_.p.begin(), loaded_.p.end(), checked_.p.begin());
    if (failed(rc_contact_certify(contact_, &step, &checked_.result))) left(checked_.result.points == 0, "certify");
    return status_;
  }

  // Whether the call that failed did.
  bool wrote_nothing() const { return wrote_nothing_; }
  double load() const { return pressed_.result.load; }
  // The indentation that the contact has; none before the first step.
  std::vector<double> indentation() const {
    std::vector<double> depth(points, 0.0);
    if (pressed()) assert_int_equal(rc_contact_indentation(contact_, RC_OUT(depth.data())), RC_OK);
    return depth;
  }
  bool pressed() const { return pressed_.result.points > 0; }

 private:
  bool failed(rc_status status) {
    status_ = status;
    wrote_nothing_ = true;
    return status != RC_OK;
  }
  // What a failed call left; true.
  bool left(bool nothing, const char* call) {
    wrote_nothing_ = nothing;
    if (!nothing) print_error("%s wrote something and failed: %s\n", call, rc_last_error());
    return true;
  }

  const Job job_;
  const Given given_;
  rc_context* context_;
  rc_options* options_ = nullptr;
  rc_contact* contact_ = nullptr;
  Answer pressed_, loaded_, checked_;
  Derivatives change_;
  rc_status status_ = RC_OK;
  bool wrote_nothing_ = true;
};

rc_context* made_context() {
  rc_context* context = nullptr;
  return rc_context_create(0, RC_PLUGINS, nullptr, nullptr, &context) == RC_OK ? context : nullptr;
}

bool has(rc_context* context, const char* backend) {
  for (std::int64_t i = 0; i < rc_component_count(context, RC_COMPONENT_BACKEND); ++i) {
    rc_component component{};
    component.struct_size = sizeof component;
    if (rc_component_describe(context, RC_COMPONENT_BACKEND, i, &component) == RC_OK && std::strcmp(component.name, backend) == 0)
      return true;
  }
  return false;
}

void assert_memory(rc_status status, std::int64_t k) {
  if (status == RC_OK) return;
  if (status != RC_ERR_MEMORY)
    print_error("allocation %ld failed: %s: %s\n", static_cast<long>(k), rc_status_name(status), rc_last_error());
  assert_int_equal(status, RC_ERR_MEMORY);
  const std::string message = rc_last_error();
  const bool explained = message.find("memory") != std::string::npos || message.find("cannot allocate") != std::string::npos;
  if (!explained) print_error("allocation %ld failed: %s\n", static_cast<long>(k), message.c_str());
  assert_true(explained);
}

// Sanitizers are slow: every seventh allocation will do there.
std::int64_t stride() { return std::getenv("RC_TEST_QUICK") ? 7 : 1; }

void lives_through_every_failed_allocation(void** state) {
  const Job& job = *static_cast<const Job*>(*state);
  rc_context* const context = made_context();
  assert_non_null(context);
  if (!has(context, job.backend)) {
    rc_context_destroy(context);
    skip();
  }
  double wanted = 0;
  std::vector<double> indentation;
  {
    Life life(job, context);
    assert_int_equal(life.live(), RC_OK);
    wanted = life.load();
    indentation = life.indentation();
    assert_true((*std::max_element(indentation.begin(), indentation.end()) > 0) == (job.hardness > 0));
  }
  for (const bool forever : {false, true}) {
    bool reached = true;
    std::int64_t k = 1;
    for (; reached; k += stride()) {
      Life life(job, context);
      support::fail_allocation(k, forever);
      const rc_status status = life.live();
      reached = support::allocation_failed();
      support::fail_allocation(0);
      assert_memory(status, k);
      if (status != RC_OK) assert_true(life.wrote_nothing());
      if (life.pressed()) assert_true(life.indentation() == indentation);
      assert_int_equal(life.live(), RC_OK);
      assert_true(std::abs(life.load() - wanted) <= 1e-6 * wanted);
    }
    print_message("%s: %ld allocations\n", job.name, static_cast<long>(k - stride()));
    assert_true(k > 20);
  }
  rc_context_destroy(context);
}

// The registry as well: what failed to load once can be loaded later.
void a_context_survives_every_failed_allocation(void**) {
  rc_context* const complete = made_context();
  const std::int64_t backends = rc_component_count(complete, RC_COMPONENT_BACKEND),
                     options = rc_component_count(complete, RC_COMPONENT_OPTION);
  rc_context_destroy(complete);
  for (const bool forever : {false, true}) {
    bool reached = true;
    for (std::int64_t k = 1; reached; k += stride()) {
      rc_context* context = nullptr;
      support::fail_allocation(k, forever);
      const rc_status status = rc_context_create(0, RC_PLUGINS, nullptr, nullptr, &context);
      if (status == RC_OK) rc_component_count(context, RC_COMPONENT_SOLVER);
      reached = support::allocation_failed();
      support::fail_allocation(0);
      assert_memory(status, k);
      if (status == RC_OK) {
        assert_int_equal(rc_component_count(context, RC_COMPONENT_BACKEND), backends);
        assert_int_equal(rc_component_count(context, RC_COMPONENT_OPTION), options);
      } else {
        assert_null(context);
      }
      rc_context_destroy(context);
    }
  }
}

// Messages are made without memory.
void a_message_needs_no_memory(void**) {
  support::fail_allocation(1, true);
  rc_context* context = nullptr;
  const rc_status status = rc_context_create(0, nullptr, nullptr, nullptr, &context);
  const std::string message = (support::fail_allocation(0), rc_last_error());
  assert_int_equal(status, RC_ERR_MEMORY);
  assert_string_equal(message.c_str(), "rc_context_create: out of memory");
}

Job jobs[] = {
    {"dense*nnls", "nnls", "dense", RC_OPERATOR_HALFSPACE, RC_BOUNDARY_FREE},
    {"dense*polonsky-keer", "polonsky-keer", "dense", RC_OPERATOR_HALFSPACE, RC_BOUNDARY_FREE},
    {"dense*nnls, the caller's matrix", "nnls", "dense", RC_OPERATOR_DENSE, RC_BOUNDARY_FREE},
    {"dense*nnls, periodic", "nnls", "dense", RC_OPERATOR_HALFSPACE, RC_BOUNDARY_PERIODIC},
    {"callback*nnls", "nnls", "callback", RC_OPERATOR_CALLBACK, RC_BOUNDARY_FREE},
    {"callback*polonsky-keer", "polonsky-keer", "callback", RC_OPERATOR_CALLBACK, RC_BOUNDARY_FREE},
    {"cholmod*nnls", "nnls", "cholmod", RC_OPERATOR_HALFSPACE, RC_BOUNDARY_FREE},
    {"cholmod*nnls, the caller's matrix", "nnls", "cholmod", RC_OPERATOR_DENSE, RC_BOUNDARY_FREE},
    {"fft*polonsky-keer", "polonsky-keer", "fft", RC_OPERATOR_HALFSPACE, RC_BOUNDARY_FREE},
    {"fft*nnls, periodic", "nnls", "fft", RC_OPERATOR_HALFSPACE, RC_BOUNDARY_PERIODIC},
    {"dense*nnls, hardness", "nnls", "dense", RC_OPERATOR_HALFSPACE, RC_BOUNDARY_FREE, hardness},
    {"callback*polonsky-keer, hardness", "polonsky-keer", "callback", RC_OPERATOR_CALLBACK, RC_BOUNDARY_FREE, hardness},
    {"fft*haar-cg, hardness", "haar-cg", "fft", RC_OPERATOR_HALFSPACE, RC_BOUNDARY_FREE, hardness},
    {"fft*haar-cg, periodic, hardness", "haar-cg", "fft", RC_OPERATOR_HALFSPACE, RC_BOUNDARY_PERIODIC, hardness},
    {"cholmod*admm, hardness", "admm", "cholmod", RC_OPERATOR_HALFSPACE, RC_BOUNDARY_FREE, hardness},
};

}  // namespace

int main() {
  std::vector<CMUnitTest> tests = {cmocka_unit_test(a_message_needs_no_memory),
                                   cmocka_unit_test(a_context_survives_every_failed_allocation)};
  for (Job& job : jobs) tests.push_back({job.name, lives_through_every_failed_allocation, nullptr, nullptr, &job});
  return _cmocka_run_group_tests("faults", tests.data(), tests.size(), nullptr, nullptr);
}
