// Gradients and tangents against differences of answers, against each other, and against a dense system.
#include <algorithm>
#include <cmath>

#include "calls.h"
#include "random_problems.h"
#include "support/naive.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr unsigned scenes = 200;
constexpr double tolerance = 1e-6;

// The problem moved along a direction. A matrix has no modulus.
Problem moved(const Problem& problem, const Change& change, double step) {
  Problem result = problem;
  for (std::size_t i = 0; i < result.points(); ++i) result.gap[i] += step * change.gap[i];
  result.target += step * change.target;
  if (result.system.op == RC_OPERATOR_HALFSPACE) result.system.modulus += step * change.modulus;
  return result;
}

// The same points open, between the bounds, and at the hardness.
bool same_contact(const Problem& problem, const Answer& a, const Answer& b) {
  const double hardness = problem.system.hardness > 0 ? problem.system.hardness : HUGE_VAL;
  for (std::size_t i = 0; i < a.p.size(); ++i)
    if ((a.p[i] > 0) != (b.p[i] > 0) || (a.p[i] < hardness) != (b.p[i] < hardness)) return false;
  return true;
}

// Both ends of a step that leaves the contact set as it is; the answer is then linear in gap and target.
struct Ends {
  double step = 0;
  Answer low, high;
};
bool find_ends(const RandomProblem& random, const Answer& middle, const Change& change, Ends& out) {
  const Pair exact{"nnls", random.problem.system.op == RC_OPERATOR_CALLBACK ? "callback" : "dense"};
  for (const double step : {1e-5, 1e-6, 1e-7}) {
    out = {step, solved(moved(random.problem, change, -step), exact, {{RC_OPT_TOL, "1e-13"}}),
           solved(moved(random.problem, change, step), exact, {{RC_OPT_TOL, "1e-13"}})};
    if (same_contact(random.problem, out.low, middle) && same_contact(random.problem, out.high, middle)) return true;
  }
  return false;
}

void agrees_with_differences(unsigned seed, int& compared) {
  RandomProblem random;
  make_random(seed, 14, false, random);
  const Problem& problem = random.problem;
  const std::size_t n = problem.points();
  const Contact contact(problem, random.pair);
  const Answer answer = contact.solve(problem);
  check_status(answer, RC_OK, random.name);
  std::mt19937 generator(seed);
  const bool half_space = problem.system.op == RC_OPERATOR_HALFSPACE;
  Change change{normals(n, generator), normal(generator), half_space ? normal(generator) : 0};
  Cotangents by{normals(n, generator), normals(n, generator), normal(generator), normal(generator)};
  for (std::size_t i = 0; i < n; ++i)
    if (!problem.included(i)) change.gap[i] = by.p[i] = by.gap[i] = NAN;  // ignored

  const Tangent forward = tangent(contact, n, change);
  check_equal(forward.status, RC_OK, random.name + ": " + forward.message);
  const Gradient reverse = gradient(contact, n, by);
  check_equal(reverse.status, RC_OK, random.name + ": " + reverse.message);
  check(half_space != std::isnan(reverse.result.dJ_dmodulus), "a matrix has no modulus, a half-space has one");
  for (std::size_t i = 0; i < n; ++i) {
    if (!problem.included(i)) {
      check(reverse.by_gap[i] == 0 && forward.p[i] == 0 && forward.gap[i] == 0, "a masked point has a derivative");
      change.gap[i] = by.p[i] = by.gap[i] = 0;
    }
    check(answer.p[i] > 0 || forward.p[i] == 0, "an open point gets pressure");
    const bool capped = problem.system.hardness > 0 && answer.p[i] >= problem.system.hardness;
    check(!capped || forward.p[i] == 0, "a pressure at the hardness changes");
    check(answer.p[i] == 0 || capped || forward.gap[i] == 0, "a gap opens in contact");
  }

  // Reverse and forward mode are each other's transpose.
  const double along =
      dot(by.p, forward.p) + dot(by.gap, forward.gap) + by.load * forward.result.dload + by.approach * forward.result.dapproach;
  const double modulus = half_space ? reverse.result.dJ_dmodulus * change.modulus : 0;
  const double size = norm(reverse.by_gap) * norm(change.gap) + std::abs(reverse.result.dJ_dtarget * change.target);
  check_near(dot(reverse.by_gap, change.gap) + reverse.result.dJ_dtarget * change.target + modulus, along, 1e-9 * size,
             random.name + ": transposes");

  Ends ends;
  if (!find_ends(random, answer, change, ends)) return;
  ++compared;
  const auto slope = [&](double high, double low) { return (high - low) / (2 * ends.step); };
  Field by_p(n), by_gap(n);
  for (std::size_t i = 0; i < n; ++i) {
    by_p[i] = slope(ends.high.p[i], ends.low.p[i]);
    by_gap[i] = problem.included(i) ? slope(ends.high.gap[i], ends.low.gap[i]) : 0;
  }
  check_near(forward.p, by_p, tolerance, random.name + ": dp");
  check_near(forward.gap, by_gap, tolerance, random.name + ": dgap");
  const double by_load = slope(ends.high.result.load, ends.low.result.load),
               by_approach = slope(ends.high.result.approach, ends.low.result.approach);
  check_near(forward.result.dload, by_load, tolerance * (std::abs(by_load) + problem.cell_area() * norm(by_p)),
             random.name + ": dload");
  check_near(forward.result.dapproach, by_approach, tolerance * (std::abs(by_approach) + largest(by_gap)),
             random.name + ": dapproach");
}

void derivatives_are_differences_of_answers() {
  int compared = 0;
  for (unsigned seed = 0; seed < scenes; ++seed) agrees_with_differences(seed, compared);
  report(std::to_string(compared) + " of " + std::to_string(scenes) + " scenes compared with differences");
  check(compared * 20 >= static_cast<int>(scenes) * 19, "too many contact sets change within the smallest step");
}

// The bounds of the errors that solves leave hold against solves to round-off, and are not far above the residual.
void errors_are_bounded() {
  int compared = 0;
  double widest = 0;
  for (unsigned seed = 300; seed < 420; ++seed) {
    RandomProblem random;
    make_random(seed, 14, false, random);
    const Problem& problem = random.problem;
    const bool half_space = problem.system.op == RC_OPERATOR_HALFSPACE;
    const std::size_t n = problem.points();
    const Contact loose(problem, half_space ? Pair{"haar-cg", "fft"} : automatic, {{RC_OPT_TOL, "1e-5"}});
    const Contact exact(problem, half_space ? Pair{"nnls", "dense"} : automatic);
    const Answer a = loose.solve(problem), b = exact.solve(problem);
    check_status(a, RC_OK, random.name);
    if (!same_contact(problem, a, b)) continue;
    std::mt19937 generator(seed);
    Cotangents by{normals(n, generator), normals(n, generator), 0.3, -0.2};
    if (seed % 4 == 0) by = {};
    const Gradient found = gradient(loose, n, by), right = gradient(exact, n, by);
    const Tangent forward = tangent(loose, n, {by.gap, 0.7, 0}), known = tangent(exact, n, {by.gap, 0.7, 0});
    if (problem.system.op == RC_OPERATOR_CALLBACK) {
      check(std::isnan(found.result.error) && std::isnan(forward.result.error), "a product's eigenvalues are not known");
      continue;
    }
    const auto off = [](const Field& x, const Field& y) {
      double square = 0;
      for (std::size_t i = 0; i < x.size(); ++i) square += (x[i] - y[i]) * (x[i] - y[i]);
      return std::sqrt(square);
    };
    const double reverse_off = off(found.by_gap, right.by_gap), forward_off = off(forward.p, known.p);
    check(reverse_off <= found.result.error + right.result.error + 1e-11 * norm(right.by_gap),
          random.name + ": gradient off by " + text(reverse_off) + ", bound " + text(found.result.error));
    check(forward_off <= forward.result.error + known.result.error + 1e-11 * norm(known.p),
          random.name + ": tangent off by " + text(forward_off) + ", bound " + text(forward.result.error));
    if (half_space) widest = std::max(widest, found.result.error / norm(right.by_gap));
    compared += half_space;
  }
  report(std::to_string(compared) + " gradients of half-spaces, the largest bound is " + text(widest) + " of its gradient");
  check(compared >= 60 && widest > 1e-6 && widest < 0.1, "bounds of errors");
}

// The gradients of load and approach are those that their cotangents give, and take one solve.
void load_and_approach_by_default() {
  for (unsigned seed = 0; seed < 20; ++seed) {
    RandomProblem random;
    make_random(seed, 14, true, random);
    const Problem& problem = random.problem;
    const Contact contact(problem, random.pair);
    check_status(contact.solve(problem), RC_OK, random.name);
    Cotangents by;
    (problem.control == RC_CONTROL_LOAD ? by.approach : by.load) = 1;
    const Gradient direct = gradient(contact, problem.points()), asked = gradient(contact, problem.points(), by);
    check_same(direct.by_gap, asked.by_gap, random.name);
    // The same number from p or the gap, by a second solve.
    Cotangents fields;
    fields.p.assign(problem.points(), problem.control == RC_CONTROL_LOAD ? 0 : problem.cell_area());
    fields.approach = by.approach;
    const Gradient again = gradient(contact, problem.points(), fields);
    check_near(again.by_gap, direct.by_gap, 1e-8, random.name);
    check_near(again.result.dJ_dtarget, direct.result.dJ_dtarget, 1e-8 * std::abs(direct.result.dJ_dtarget), random.name);
    check_near(again.result.dJ_dmodulus, direct.result.dJ_dmodulus, 1e-8 * std::abs(direct.result.dJ_dmodulus), random.name);
  }
}

// Full periodic contact in load control: H is singular on the contact set.
void full_periodic_contact() {
  for (const char* backend : {"fft", "dense"}) {
    Problem problem;
    problem.system.boundary = RC_BOUNDARY_PERIODIC;
    problem.system.nx = 8;
    problem.system.ny = 6;
    std::mt19937 generator(3);
    problem.gap = normals(problem.points(), generator);
    for (double& gap : problem.gap) gap *= 1e-3;
    problem = at_load(problem, 48);
    const Contact contact(problem, {"auto", backend});
    check_equal(contact.solve(problem).result.contacts, 48, "contacts");
    Change change{normals(problem.points(), generator), 0.3, 0};
    const Tangent forward = tangent(contact, problem.points(), change);
    check_equal(forward.status, RC_OK, forward.message);
    check_near(forward.result.dapproach, sum(change.gap) / 48, 1e-9, "the mean plane moves with the mean of the gap");
    check_near(sum(forward.p), 0.3, 1e-9, "change of the load");
    Cotangents by{normals(problem.points(), generator), normals(problem.points(), generator), 0, 0.5};
    const Gradient reverse = gradient(contact, problem.points(), by);
    check_equal(reverse.status, RC_OK, reverse.message);
    check_near(dot(reverse.by_gap, change.gap) + reverse.result.dJ_dtarget * 0.3,
               dot(by.p, forward.p) + dot(by.gap, forward.gap) + 0.5 * forward.result.dapproach, 1e-8, "transposes");
  }
}

// Without contact the gap alone moves.
void no_contact() {
  Problem problem;
  problem.system.nx = problem.system.ny = 3;
  problem.gap = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  problem.target = 0.5;
  const Contact contact(problem, automatic);
  check_status(contact.solve(problem), RC_OK);
  const Field ones(9, 1.0);
  const Gradient reverse = gradient(contact, 9, {{}, ones, 0, 0});
  check_equal(reverse.status, RC_OK, reverse.message);
  check_same(reverse.by_gap, ones, "dJ/dh");
  check_near(reverse.result.dJ_dtarget, -9, 0, "dJ/dd");
  check_near(gradient(contact, 9).result.dJ_dtarget, 0, 0, "dload/dd");
  const Tangent forward = tangent(contact, 9, {{}, 1, 0});
  check_same(forward.gap, Field(9, -1.0), "dgap");
  check_same(forward.p, Field(9, 0.0), "dp");
}

// A change of p by rounding alone: the step after a gradient is that without one.
void a_gradient_leaves_the_contact_as_it_is() {
  RandomProblem random;
  make_random(4, 14, true, random);
  Problem problem = random.problem;
  const Contact with(problem, random.pair), without(problem, random.pair);
  std::mt19937 generator(1);
  for (int step = 0; step < 3; ++step) {
    const Answer a = with.solve(problem), b = without.solve(problem);
    check_near(a.p, b.p, 1e-10, "pressures");
    check_equal(gradient(with, problem.points(), {{}, normals(problem.points(), generator), 0, 0}).status, RC_OK, "gradient");
    problem.target *= 1.01;
  }
}

void the_same_bits_for_any_number_of_threads() {
  const Problem problem = at_load(rough_problem(96, 80), 900);
  std::mt19937 generator(6);
  const Cotangents by{normals(problem.points(), generator), normals(problem.points(), generator), 0, 0};
  std::vector<Gradient> found;
  for (const char* threads : {"1", "2", "3"}) {
    const Contact contact(problem, {"haar-cg", "fft"}, {{RC_OPT_THREADS, threads}});
    check_status(contact.solve(problem), RC_OK);
    found.push_back(gradient(contact, problem.points(), by));
    check_same(found.back().by_gap, found.front().by_gap, "gradients");
    check_near(found.back().result.dJ_dtarget, found.front().result.dJ_dtarget, 0, "dJ/dF");
  }
}

void a_stopped_gradient_writes_nothing() {
  const Problem problem = rough_problem(24, 20);
  const Contact contact(problem, {"haar-cg", "fft"});
  check_status(contact.solve(problem), RC_OK);
  const Field untouched(problem.points(), -7.0);
  rc_contact_cancel(contact.handle());
  const Gradient cancelled = gradient(contact, problem.points());
  check_equal(cancelled.status, RC_STOP_CANCELLED, "status");
  check_same(cancelled.by_gap, untouched, "gradient");
  check_equal(gradient(contact, problem.points()).status, RC_OK, "the next one");
  const Options hasty = make_options({"haar-cg", "fft"}, "auto", {{RC_OPT_TIME_LIMIT, "1e-9"}});
  check_equal(rc_contact_set_options(contact.handle(), hasty.get()), RC_OK, "options");
  const Tangent late = tangent(contact, problem.points(), {{}, 1, 0});
  check_equal(late.status, RC_STOP_TIME, "status");
  check_same(late.p, untouched, "tangent");
  check(late.message.find("rc_contact_tangent: ") == 0, late.message);
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("derivatives.differences",
                   {{"derivatives_are_differences_of_answers", derivatives_are_differences_of_answers},
                    {"errors_are_bounded", errors_are_bounded},
                    {"load_and_approach_by_default", load_and_approach_by_default},
                    {"full_periodic_contact", full_periodic_contact},
                    {"no_contact", no_contact},
                    {"the_same_bits_for_any_number_of_threads", the_same_bits_for_any_number_of_threads},
                    {"a_stopped_gradient_writes_nothing", a_stopped_gradient_writes_nothing},
                    {"a_gradient_leaves_the_contact_as_it_is", a_gradient_leaves_the_contact_as_it_is}},
                   argc, argv);
}
