// The certificate against naive code, and on pressures that are wrong in one respect each.
#include <algorithm>

#include "certificate_tests.h"
#include "support/naive.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

// Small enough for the naive matrix; periodic surfaces touch in part up to their mean plane.
Problem small_problem(std::int32_t boundary) {
  Problem problem = rough_problem(8, 7, boundary);
  problem.target *= 1.5;
  return problem;
}

Answer certified(const Problem& problem, const Pair& pair, const Field& p) {
  return Contact(problem, pair, {{RC_OPT_TOL, "1e-9"}}).certify(problem.step(), p);
}

void check_rejected(const Problem& problem, const Pair& pair, const Field& p) {
  const Answer answer = certified(problem, pair, p);
  check_status(answer, RC_UNCERTIFIED);
  check(!answer.message.empty(), "the message is empty");
  check_against_naive(problem, answer);
  check_same(answer.p, p, "the given pressures");
}

void accepts_the_solution(const Problem& problem, const Pair& pair) {
  const Answer answer = certified(problem, pair, solved(problem, pair).p);
  check_status(answer, RC_OK);
  check_against_naive(problem, answer);
  check_equal(answer.result.iterations, 0, "iterations");
}

void rejects_a_shift(const Problem& problem, const Pair& pair) {
  Field p = solved(problem, pair).p;
  std::rotate(p.begin(), p.begin() + 1, p.end());
  check_rejected(problem, pair, p);
}

void rejects_a_missing_contact(const Problem& problem, const Pair& pair) {
  Field p = solved(problem, pair).p;
  *std::max_element(p.begin(), p.end()) = 0;
  check_rejected(problem, pair, p);
}

void rejects_tension(const Problem& problem, const Pair& pair) {
  Field p = solved(problem, pair).p;
  *std::min_element(p.begin(), p.end()) = -1e-4 * largest(p);
  check_rejected(problem, pair, p);
  check_near(certified(problem, pair, p).result.kkt_primal, 1e-4, 1e-12, "kkt_primal");
}

void rejects_no_pressure(const Problem& problem, const Pair& pair) {
  const Answer answer = certified(problem, pair, Field(problem.points(), 0.0));
  check_status(answer, RC_UNCERTIFIED);
  check_near(answer.result.kkt_dual, 1, 1e-15, "kkt_dual");
}

void rejects_a_wrong_load(const Problem& problem, const Pair& pair) {
  const Answer right = solved(problem, pair);
  const Problem loaded = at_load(problem, 1.001 * right.result.load);
  const Answer answer = certified(loaded, pair, right.p);
  check_status(answer, RC_UNCERTIFIED);
  check_near(answer.result.kkt_control, 1e-3 / 1.001, 1e-12, "kkt_control");
  check(std::max({answer.result.kkt_primal, answer.result.kkt_dual, answer.result.kkt_complementarity}) <= 1e-9,
        "only the load is wrong");
}

void finds_the_approach_of_a_load(const Problem& problem, const Pair& pair) {
  const Answer right = solved(problem, pair);
  const Answer answer = certified(at_load(problem, right.result.load), pair, right.p);
  check_status(answer, RC_OK);
  check_near(answer.result.approach, problem.target, 1e-11 * problem.target, "approach");
}

void other_backend_agrees(const Problem& problem, const Pair& pair) {
  for (const std::string& certifier : backend_names()) {
    if (!obstacle({pair.solver, certifier}, problem.system, RC_CONTROL_APPROACH).empty()) continue;
    check_against_naive(problem, solved(problem, pair, {{"certify_backend", certifier}}));
  }
}

std::vector<Test> tests_by_naive_code() {
  using Body = void (*)(const Problem&, const Pair&);
  const std::pair<const char*, Body> bodies[] = {
      {"certificate_accepts_the_solution", accepts_the_solution},
      {"certificate_rejects_a_pressure_off_by_one_cell", rejects_a_shift},
      {"certificate_rejects_a_missing_contact", rejects_a_missing_contact},
      {"certificate_rejects_a_tensile_pressure", rejects_tension},
      {"certificate_rejects_no_pressure_at_all", rejects_no_pressure},
      {"certificate_rejects_a_wrong_load", rejects_a_wrong_load},
      {"certificate_finds_the_approach_of_a_load", finds_the_approach_of_a_load},
      {"certificate_by_any_backend_is_the_same", other_backend_agrees},
  };
  std::vector<Test> tests;
  for (const auto& [name, body] : bodies)
    for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
      add_for_pairs(tests, name, boundary, [boundary, body = body](const Pair& pair) { body(small_problem(boundary), pair); });

  for (const std::string& kernel : kernel_names()) {
    Problem problem = small_problem(kernel == "spectral" ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE);
    problem.kernel = kernel;
    add_for_pairs(tests, "every_kernel_is_certified_by_naive_code/" + kernel, problem.system.boundary,
                  [problem](const Pair& pair) {
                    const Answer answer = solved(problem, pair);
                    check_against_naive(problem, answer);
                    check_against_naive(at_load(problem, answer.result.load), solved(at_load(problem, answer.result.load), pair));
                  });
  }
  return tests;
}

void append(std::vector<Test>& tests, const std::vector<Test>& more) { tests.insert(tests.end(), more.begin(), more.end()); }

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  std::vector<Test> tests = tests_by_naive_code();
  append(tests, tests_of_liars());
  append(tests, tests_on_cases());
  return run_group("pairs.certificate", tests, argc, argv);
}
