// Valid input of absurd magnitude, drawn at random: an answer is finite, a refusal is documented, nothing hangs or crashes.
#include <roughcontact/roughcontact.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "support/cmocka.hpp"
#include "support/unit_system.h"

namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : generator_(seed) {}

  std::int64_t below(std::int64_t limit) { return static_cast<std::int64_t>(generator_() % static_cast<std::uint64_t>(limit)); }
  bool rarely(std::int64_t odds) { return below(odds) == 0; }
  double magnitude() {
    constexpr double all[] = {1, 1e-9, 1e9, 1e-30, 1e30, 1e-150, 1e150, 1e-300, 1e300, 1e308, 5e-324, 2.3e-308};
    return all[below(12)];
  }
  double fraction() { return static_cast<double>(below(1000)) / 1000; }

 private:
  std::mt19937_64 generator_;
};

void solve_one(Draw& draw, rc_options* options) {
  rc_system system = support::unit_system();
  system.nx = 1 + draw.below(6);
  system.ny = 1 + draw.below(6);
  system.boundary = draw.rarely(2) ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE;
  system.hx = draw.rarely(2) ? draw.magnitude() : 1;
  system.hy = draw.rarely(2) ? draw.magnitude() : system.hx;
  system.modulus = draw.rarely(2) ? draw.magnitude() : 1;
  const double height = draw.rarely(2) ? draw.magnitude() : 1;
  std::vector<double> gap(static_cast<std::size_t>(system.nx * system.ny)), p0(gap.size()), p(gap.size()), g(gap.size());
  for (double& value : gap) value = height * draw.fraction() * (draw.rarely(20) ? draw.magnitude() : 1);
  for (double& value : p0) value = draw.magnitude();
  rc_step step = RC_STEP_INIT;
  step.control = draw.rarely(2) ? RC_CONTROL_LOAD : RC_CONTROL_APPROACH;
  step.target = 2 * draw.fraction() * (draw.rarely(2) ? draw.magnitude() : 1) * (draw.rarely(2) ? height : 1);
  step.undeformed_gap.data = gap.data();
  if (draw.rarely(3)) step.p0.data = p0.data();
  for (const char* key : {RC_OPT_SOLVER, RC_OPT_BACKEND}) {
    constexpr const char* solvers[] = {"auto", "nnls", "polonsky-keer"};
    constexpr const char* backends[] = {"auto", "dense", "fft"};
    rc_options_set_text(options, key, (key[0] == 's' ? solvers : backends)[draw.below(3)]);
  }
  rc_options_set_number(options, RC_OPT_STIFFNESS, draw.below(2));

  rc_result result = RC_RESULT_INIT;
  result.p.data = p.data();
  result.gap.data = g.data();
  const rc_status status = rc_solve(&system, &step, options, &result);
  if (status == RC_ERR_NO_BACKEND) return;
  const auto finite = [](double value) { return std::isfinite(value); };
  const bool documented = status >= 0 || status == RC_ERR_ARGUMENT || status == RC_ERR_INFEASIBLE || status == RC_ERR_NUMERIC;
  if (!documented) print_error("%s: %s\n", rc_status_name(status), rc_last_error());
  assert_true(documented);
  if (status < 0) return;
  assert_true(std::all_of(p.begin(), p.end(), finite) && std::all_of(g.begin(), g.end(), finite));
  assert_true(finite(result.load) && finite(result.energy) && finite(result.approach));
}

void absurd_magnitudes_give_a_finite_answer_or_a_refusal(void**) {
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(nullptr, &options), RC_OK);
  for (std::uint64_t seed = 5; seed <= 8; ++seed) {
    Draw draw(seed);
    for (int k = 0; k < 1000; ++k) solve_one(draw, options);
  }
  rc_options_destroy(options);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(absurd_magnitudes_give_a_finite_answer_or_a_refusal)};
  return cmocka_run_group_tests_name("extremes", tests, nullptr, nullptr);
}
