// A result is overwritten in full, and its numbers add up.
#include <cmath>
#include <cstring>

#include "invariance_tests.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

Problem repeated_problem(std::int32_t boundary) {
  Problem problem = rough_problem(33, 26, boundary, 0.5, 0.75);
  problem.target *= 1.4;
  return problem;
}

template <class Check> void by_load_and_approach(std::int32_t boundary, const Pair& pair, const Check& compare) {
  const Problem problem = repeated_problem(boundary);
  compare(problem);
  compare(at_load(problem, solved(problem, pair).result.load));
}

// Whatever the result holds before, it is written as far as struct_size goes, and nothing beyond.
void result_is_written_in_full(std::int32_t boundary, const Pair& pair) {
  by_load_and_approach(boundary, pair, [&](const Problem& problem) {
    const Contact contact(problem, pair, {{RC_OPT_STIFFNESS, "1"}});
    rc_result results[2];
    Field p[2], gap[2];
    const int fillings[2] = {0xAA, 0x55};
    for (int k = 0; k < 2; ++k) {
      p[k].assign(problem.points(), -7 - k);
      gap[k].assign(problem.points(), -7 - k);
      std::memset(&results[k], fillings[k], sizeof results[k]);
      results[k].struct_size = sizeof results[k];
      results[k].p = {p[k].data(), RC_NATIVE, 0, nullptr};
      results[k].gap = {gap[k].data(), RC_NATIVE, 0, nullptr};
      const rc_step step = problem.step();
      check(rc_contact_reset(contact.handle()) == RC_OK, rc_last_error());
      check(rc_contact_solve(contact.handle(), &step, &results[k]) == RC_OK, rc_last_error());
      check(results[k].seconds >= 0 && results[k].seconds < 1e4, "seconds are not written");
      check(results[k].setup_seconds >= 0 && results[k].setup_seconds < 1e4, "setup_seconds are not written");
    }
    // The two differ in the addresses and the times only.
    results[1].p = results[0].p;
    results[1].gap = results[0].gap;
    results[1].seconds = results[0].seconds;
    results[1].setup_seconds = results[0].setup_seconds;
    const rc_result &a = results[0], &b = results[1];
    check(std::memcmp(&a, &b, offsetof(rc_result, solver)) == 0, "a number of the result is not written");
    check_equal(a.status, RC_OK, "status");
    check_equal(a.homogeneous, 1, "homogeneous");
    check(std::string(a.solver) == b.solver && std::string(a.backend) == b.backend && std::string(a.kernel) == b.kernel &&
              std::string(a.note) == b.note,
          "a text of the result is not written");
    check_same(p[0], p[1], "p");
    check_same(gap[0], gap[1], "gap");
  });
}

void result_adds_up(std::int32_t boundary, const Pair& pair) {
  by_load_and_approach(boundary, pair, [&](const Problem& problem) {
    const Answer answer = solved(problem, pair);
    const rc_result& r = answer.result;
    const double n = static_cast<double>(problem.points()), load = sum(answer.p) * problem.cell_area();
    check_near(r.load, load, 1e-13 * load, "load");
    check_near(r.mean_pressure, load / (n * problem.cell_area()), 1e-13 * load, "mean_pressure");
    check_near(r.contact_area, static_cast<double>(r.contacts) * problem.cell_area(), 1e-12 * r.contact_area, "contact_area");
    check_equal(r.points, static_cast<std::int64_t>(problem.points()), "points");
    check(r.contacts <= r.candidates && r.candidates <= r.points && r.modelled <= r.points && r.candidates <= r.modelled,
          "contacts <= candidates <= modelled <= points");
    check(std::isnan(r.stiffness), "stiffness was not asked for");
    check(r.products > 0, "products");
    check(pair.solver == r.solver && pair.backend == r.backend, "solver and backend");
    check(std::string(r.kernel) == (boundary == RC_BOUNDARY_PERIODIC ? "spectral" : "love"), "kernel");
  });
}

}  // namespace

std::vector<Test> repetition_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const auto add = [&](const char* name, void (*body)(std::int32_t, const Pair&)) {
      add_for_pairs(tests, name, boundary, [=](const Pair& pair) { body(boundary, pair); });
    };
    add("result_is_written_in_full", result_is_written_in_full);
    add("result_adds_up", result_adds_up);
  }
  return tests;
}

}  // namespace pairs
