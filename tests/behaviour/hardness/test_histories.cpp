// The plastic indentation that steps leave: what commits it, what does not, and what forgets it.
#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "capped_cases.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

Field indentation_of(const Contact& contact, std::size_t points) {
  Field said(points, -7);
  check(rc_contact_indentation(contact.handle(), RC_OUT(said.data())) == RC_OK, rc_last_error());
  return said;
}

// A rough surface of which a good part yields at its target.
Problem yielding(std::int32_t boundary = RC_BOUNDARY_FREE) {
  Problem problem = rough_problem(18, 14, boundary, 0.5, 0.75);
  problem.target *= 1.4;
  const Answer elastic = solved(problem, {"nnls", "dense"});
  problem.system.hardness = 0.3 * largest(elastic.p);
  return problem;
}

Problem at(Problem problem, double share) {
  problem.target *= share;
  return problem;
}

const Pair pair = {"polonsky-keer", "dense"};

// Independent springs, whose exact load is a sum. The gap with its indentation is rounded, the more the higher its datum.
void intervals_count_the_rounded_gap() {
  constexpr std::size_t n = 6;
  std::mt19937 generator(3);
  const auto random = [&] { return static_cast<double>(generator()) / 4294967296.0; };
  Field matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] = 1;
  int off = 0;
  for (int draw = 0; draw < 300; ++draw) {
    Problem problem;
    problem.system.nx = n;
    problem.system.ny = 1;
    problem.system.op = RC_OPERATOR_DENSE;
    problem.system.dense = matrix.data();
    problem.system.dense_ld = n;
    problem.system.hardness = 0.1;
    const double datum = std::pow(10.0, 8 * random());
    for (std::size_t i = 0; i < n; ++i) problem.gap.push_back(datum + random());
    problem.target = datum + 1.5;
    const Contact contact(problem, automatic);
    check_status(contact.solve(problem), RC_OK);
    const Field left = indentation_of(contact, n);
    problem.target -= 0.2 * random();
    const Answer answer = contact.solve(problem);
    check_status(answer, RC_OK);
    long double load = 0, rounded = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const long double target = problem.target, cap = problem.system.hardness, gap = problem.gap[i];
      load += std::clamp(target - gap - left[i], 0.0L, cap);
      rounded += std::clamp(target - static_cast<long double>(problem.gap[i] + left[i]), 0.0L, cap);
    }
    check(answer.result.load_lower <= load && load <= answer.result.load_upper,
          "the load " + text(static_cast<double>(load)) + " is not in " + text(answer.result.load_lower) + " .. " +
              text(answer.result.load_upper));
    off += load != rounded;
  }
  check(off > 100, "few sums were rounded");
}

// Refused steps leave none either, which scenes ask for, as they do for the overlap that a step adds.
void stops_and_certificates_leave_nothing() {
  const Problem problem = yielding();
  const Contact stopped(problem, pair, {{RC_OPT_MAX_ITER, "3"}}), contact(problem, pair);
  check_status(stopped.solve(problem), RC_STOP_MAX_ITER);
  check_same(indentation_of(stopped, problem.points()), Field(problem.points(), 0.0), "after a stop");
  const Answer first = contact.solve(problem), said = Contact(problem, pair).certify(problem.step(), first.p);
  check_status(said, RC_OK);
  check_equal(said.result.capped, first.result.capped, "points at the hardness");
  check_near(said.result.plastic_volume, first.result.plastic_volume, 1e-12 * first.result.plastic_volume, "plastic volume");
  const Field left = indentation_of(contact, problem.points());
  check_status(contact.certify(problem.step(), first.p), RC_OK, "the same pressures on the indented surface");
  check_same(indentation_of(contact, problem.points()), left, "after certifying");
}

const double shares[] = {0.6, 1.0, 0.3, 1.1, 0.8};

// With `virgin` each step is that of a contact of its own, and the history leaves no indentation.
void a_virgin_history_presses_the_first_surface() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const Problem problem = yielding(boundary);
    Field targets, loads(std::size(shares));
    for (const double share : shares) targets.push_back(share * problem.target);
    rc_history path = RC_HISTORY_INIT;
    path.control = problem.control;
    path.n = static_cast<std::int64_t>(targets.size());
    path.targets = RC_IN(targets.data());
    path.undeformed_gap = RC_IN(problem.gap.data());
    path.columns.load = RC_OUT(loads.data());
    path.virgin = 1;
    const auto expected = [&](double target, const Field& left) {
      Problem alone = problem;
      alone.target = target;
      for (std::size_t i = 0; i < left.size(); ++i) alone.gap[i] += left[i];
      return solved(alone, pair).result.load;
    };
    for (const std::int32_t warm : {1, 0}) {
      const Contact contact(problem, pair);
      path.warm_start = warm;
      path.undeformed_gap = RC_IN(problem.gap.data());
      check(rc_contact_solve_history(contact.handle(), &path) == RC_OK, rc_last_error());
      for (std::size_t i = 0; i < targets.size(); ++i)
        check_near(loads[i], expected(targets[i], {}), 1e-10 * loads[i], "load of a virgin surface");
      check_same(indentation_of(contact, problem.points()), Field(problem.points(), 0.0), "indentation");

      // A step before it leaves what all of its steps see; steps after it leave theirs again.
      check_status(contact.solve(at(problem, 0.9)), RC_OK);
      const Field left = indentation_of(contact, problem.points());
      check(largest(left) > 0, "the surface should yield");
      path.undeformed_gap = {};
      check(rc_contact_solve_history(contact.handle(), &path) == RC_OK, rc_last_error());
      for (std::size_t i = 0; i < targets.size(); ++i)
        check_near(loads[i], expected(targets[i], left), 1e-10 * loads[i], "load of an indented surface");
      check_same(indentation_of(contact, problem.points()), left, "indentation that was there");
      check_status(contact.solve(at(problem, 1.1)), RC_OK);
      check(sum(indentation_of(contact, problem.points())) > sum(left), "a later step leaves an indentation");
    }
  }
}

// With a hardness option accuracy solves the whole grid, whose contact yields there: its indentation is the whole grid's.
void an_accuracy_goal_indents_the_whole_grid() {
  const Settings goal = {{RC_OPT_ACCURACY, "0.1"}};
  const Pair fast = {"haar-cg", "fft"};
  Problem problem;
  problem.system.nx = problem.system.ny = 256;
  problem.gap = paraboloid(256, 256, 1, 127.5, 127.5, 3000);
  problem.target = 1;
  const Answer elastic = solve(problem, fast, goal);
  check_status(elastic, RC_WITHIN_GOAL, "without a hardness a coarser grid will do");
  problem.system.hardness = 0.8 * largest(elastic.p);
  const Contact contact(problem, fast, goal);
  const Answer most = contact.solve(problem);
  check_status(most, RC_OK);
  check(most.result.capped > 100, "the sphere should yield");
  check(most.result.model_nx == 256 && most.result.error_estimate == 0 && most.result.left_out == 0, "the whole grid is solved");
  const Field left = indentation_of(contact, problem.points());
  for (std::size_t i = 0; i < left.size(); ++i)
    check(left[i] == (most.p[i] == problem.system.hardness ? std::max(0.0, -most.gap[i]) : 0.0), "the overlap at the hardness");

  // Unloading is elastic contact on the indented surface.
  Problem half = at(problem, 0.5);
  const Answer answer = contact.solve(half);
  check_status(answer, RC_OK);
  check_same(indentation_of(contact, problem.points()), left, "indentation");
  for (std::size_t i = 0; i < left.size(); ++i) half.gap[i] += left[i];
  half.system.hardness = 0;
  const double expected = solved(half, fast).result.load;
  check_near(answer.result.load, expected, 1e-2 * expected, "load");
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  std::vector<Test> tests = RC_TESTS(intervals_count_the_rounded_gap, stops_and_certificates_leave_nothing,
                                     a_virgin_history_presses_the_first_surface, an_accuracy_goal_indents_the_whole_grid);
  return run_group("hardness histories", tests, argc, argv);
}
