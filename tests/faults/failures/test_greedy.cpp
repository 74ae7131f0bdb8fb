// Greedy elimination: Example 1 of Bemporad & Paggi (2015), which kernels it fails on, why, and that no failure passes for an
// answer.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "atlas.h"
#include "inverse_m.h"
#include "wilson.h"

namespace failures {

namespace {

const Pair greedy{"greedy", "dense"};
const Settings exact = {{"greedy.inner", "cholesky"}, {"greedy.repair", "0"}, {"tol", "1e-10"}};

struct Count {
  std::int64_t failures = 0, draws = 0;
};

Count count_failures(const std::string& kernel, std::int64_t side, std::int64_t spacing, std::int64_t draws) {
  Problem problem = example_one(side, spacing, 0);
  problem.kernel = kernel;
  const Contact eliminating(problem, greedy, exact), reference(problem, {"nnls", "dense"}, {{"tol", "1e-10"}});
  Count count;
  for (; count.draws < draws; ++count.draws) {
    problem.gap = example_one(side, spacing, static_cast<std::uint64_t>(count.draws)).gap;
    rc_step step = problem.step();
    step.warm_start = 0;
    const Answer found = eliminating.solve(step), truth = reference.solve(step);
    check_status(truth, RC_OK, "nnls");
    const bool wrong = difference(found.p, truth.p) > 1e-6;
    check(wrong == (found.status == RC_UNCERTIFIED),
          std::string(wrong ? "a wrong" : "the right") + " answer with " + rc_status_name(found.status));
    if (!wrong) continue;
    ++count.failures;
    check(found.result.kkt_dual > 1e-10, "the overlap is not in the certificate");
    check(std::string(found.result.note).find("greedy:") != std::string::npos, "no note says what is wrong");
  }
  return count;
}

// The share of failures lies where 1000 draws by an independent implementation put it. The intervals overlap unless one is in
// error a thousand times to one.
void check_share(const std::string& kernel, std::int64_t side, double lowest, double highest) {
  const std::int64_t draws = full() ? 1000 : quick() ? 30 : side < 20 ? 200 : 60;
  const Count count = count_failures(kernel, side, 1, draws);
  const Interval interval = wilson(count.failures, count.draws, 3.29);
  report(std::to_string(count.failures) + " of " + std::to_string(count.draws) + " draws fail");
  check(interval.lower <= highest && interval.upper >= lowest, "share between " + text(interval.lower) + " and " +
                                                                   text(interval.upper) + " instead of " + text(lowest) + " to " +
                                                                   text(highest));
}

void check_never(const std::string& kernel, std::int64_t spacing) {
  for (const std::int64_t side : {5, 10, 20}) {
    const std::int64_t draws = full() ? 1000 : quick() ? 5 : side < 20 ? 60 : 10;
    check_equal(count_failures(kernel, side, spacing, draws).failures, 0, "failures with side " + std::to_string(side));
  }
}

std::vector<Field> stored_draws() {
  std::ifstream in(RC_TEST_DATA "/cases/ex1_eq9_N10_failing_ubar.csv");
  std::vector<Field> draws;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    double value = 0;
    numbers >> value;  // the seed
    Field u;
    while (numbers >> value) u.push_back(value);
    check_equal(static_cast<std::int64_t>(u.size()), 100, "values in a line");
    draws.push_back(u);
  }
  check_equal(static_cast<std::int64_t>(draws.size()), 20, "draws");
  return draws;
}

Problem with_penetration(const Field& u, std::int64_t side, const std::string& kernel) {
  Problem problem;
  problem.system.nx = problem.system.ny = side;
  problem.kernel = kernel;
  for (const double value : u) problem.gap.push_back(-value);
  return problem;
}

// The points that overlap and the deepest of them are those of the note.
void check_note(const Problem& problem, const Answer& answer) {
  long long points = 0;
  double worst = 0, deepest = 0;
  check(std::sscanf(answer.result.note, "greedy: %lld points overlap, worst w = %lf", &points, &worst) == 2,
        std::string("note: ") + answer.result.note);
  const double depth = -problem.lowest_gap();
  for (const double gap : answer.gap) {
    points -= gap < -1e-12 * depth;
    deepest = std::max(deepest, -gap / depth);
  }
  check_equal(points, 0, "points of the note that do not overlap");
  check_near(-worst, deepest, 0.06 * deepest, "the worst overlap, two digits");
  check(answer.result.kkt_dual > 1e-6, "kkt_dual does not show it: " + text(answer.result.kkt_dual));
}

void stored_draws_fail_with_greedy_alone() {
  for (const Field& u : stored_draws()) {
    const Problem problem = with_penetration(u, 10, "eq9");
    const Answer truth = truth_of(problem);
    for (const Pair& pair : all_pairs())
      if (pair.solver != "greedy" && obstacle(pair, problem.system, RC_CONTROL_APPROACH).empty())
        check_near(solved(problem, pair).p, truth.p, 1e-9, pair.name());
    for (const char* inner : {"cg", "gauss-seidel", "cholesky"}) {
      const Answer failed = solve(problem, greedy, {{"greedy.inner", inner}, {"greedy.repair", "0"}});
      check_status(failed, RC_UNCERTIFIED, inner);
      check_note(problem, failed);
    }
    for (const char* backend : {"dense", "fft"})
      for (const Problem& each : {problem, at_load(problem, truth.result.load)}) {
        const Answer repaired = solved(each, {"greedy", backend}, {{"greedy.repair", "1"}});
        check_near(repaired.p, truth.p, 1e-9, "repaired");
        check(std::string(repaired.result.note).find("nnls has repaired it") != std::string::npos, repaired.result.note);
      }
  }
}

void unfit_inner_methods_are_refused() {
  Problem problem;
  problem.system.nx = 70;
  problem.system.ny = 60;
  problem.gap.assign(problem.points(), 0.0);
  problem.target = 1;
  const auto refused = [&](const Settings& settings, const std::string& word) {
    const Answer answer = solve(problem, {"greedy", "fft"}, settings);
    check_status(answer, RC_ERR_INCOMPATIBLE);
    check(answer.message.find(word) != std::string::npos, "the message does not name " + word + ": " + answer.message);
  };
  refused({{"greedy.inner", "gauss-seidel"}}, "4200 of at most 4096");
  refused({{"greedy.inner", "cholesky"}, {RC_OPT_ALLOW_FALLBACK, "0"}}, "greedy.inner = cg");
}

void check_coupling(const std::string& kernel, double expected, double tolerance) {
  for (const std::int64_t side : {10, 20, 30, 50}) {
    if (side > 20 && !full()) continue;
    const double found = largest_inverse_coupling(kernel, side, 1);
    report(kernel + ", n = " + std::to_string(side * side) + ": " + text(found));
    check_near(found, expected, tolerance, "the largest entry off the diagonal of H^-1");
  }
}

void inverse_has_positive_entries_where_greedy_fails() {
  check_coupling("eq9", 0.109, 0.001);
  check_coupling("galerkin", 0.0203, 0.0002);
  check_coupling("punch", 0.0047, 0.0001);
}

void inverse_has_none_where_greedy_is_exact() {
  for (const char* kernel : {"love", "disc"})
    for (const std::int64_t side : {5, 10, 20, 30}) {
      if (side > 20 && !full()) continue;
      check(largest_inverse_coupling(kernel, side, 1) <= 0, std::string(kernel) + " has a positive coupling");
    }
  for (const std::string kernel : {"eq9", "punch", "galerkin", "love", "disc"})
    for (const std::int64_t side : {5, 10, 20})
      check(largest_inverse_coupling(kernel, side, 2) <= 0, kernel + " has a positive coupling at two cells' distance");
}

// Necessity: whatever positive coupling there is makes a surface on which greedy fails.
void a_positive_coupling_makes_a_counterexample() {
  for (const std::string kernel : {"eq9", "galerkin", "punch"}) {
    const Problem problem = with_penetration(greedy_counterexample(kernel, 6), 6, kernel);
    const Answer found = solve(problem, greedy, exact), truth = truth_of(problem);
    check_status(found, RC_UNCERTIFIED, kernel);
    report(kernel + ": greedy's pressures are off by " + text(difference(found.p, truth.p)));
  }
  for (const char* kernel : {"love", "disc"}) check(greedy_counterexample(kernel, 6).empty(), "there should be none");
}

std::vector<Test> all_tests() {
  std::vector<Test> tests = {
      {"stored_draws_fail_with_greedy_alone", stored_draws_fail_with_greedy_alone},
      {"unfit_inner_methods_are_refused", unfit_inner_methods_are_refused},
      {"inverse_has_positive_entries_where_greedy_fails", inverse_has_positive_entries_where_greedy_fails},
      {"inverse_has_none_where_greedy_is_exact", inverse_has_none_where_greedy_is_exact},
      {"a_positive_coupling_makes_a_counterexample", a_positive_coupling_makes_a_counterexample},
      {"example_1_eq9_n25_fails_in_a_sixth", [] { check_share("eq9", 5, 0.148, 0.194); }},
      {"example_1_eq9_n100_fails_in_a_third", [] { check_share("eq9", 10, 0.329, 0.389); }},
      {"example_1_eq9_n400_fails_in_two_thirds", [] { check_share("eq9", 20, 0.601, 0.661); }},
  };
  for (const std::string kernel : {"punch", "galerkin", "love", "disc"})
    tests.push_back({"example_1_" + kernel + "_never_fails", [=] { check_never(kernel, 1); }});
  for (const std::string kernel : {"eq9", "punch", "galerkin", "love", "disc"})
    tests.push_back({"example_1_" + kernel + "_at_two_cells_distance_never_fails", [=] { check_never(kernel, 2); }});
  return tests;
}

}  // namespace

}  // namespace failures

int main(int argc, char** argv) { return pairs::run_group("failures.greedy", failures::all_tests(), argc, argv); }
