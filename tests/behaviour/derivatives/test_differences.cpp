// Derivatives where H is singular or nothing touches, their bits, and what is stopped. That derivatives are those of the exact
// answer, and their errors within what is promised, is a property of scenes.
#include <cmath>
#include <random>

#include "calls.h"
#include "support/naive.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

Field normals(std::size_t n, std::mt19937& generator) {
  std::normal_distribution<double> normal;
  Field values(n);
  for (double& value : values) value = normal(generator);
  return values;
}

// The same change of the pressures by approach and by load: the latter is scaled by a sum of pressures, whose error adds.
void a_load_adds_to_the_error() {
  const Problem problem = rough_problem(24, 20, RC_BOUNDARY_FREE, 0.5, 0.75);
  const Settings loose{{RC_OPT_TOL, "1e-5"}};
  const Contact by_approach(problem, {"haar-cg", "fft"}, loose), by_load(problem, {"haar-cg", "fft"}, loose);
  const Answer answer = by_approach.solve(problem);
  check_status(answer, RC_OK);
  check_status(by_load.solve(at_load(problem, answer.result.load)), RC_OK);
  const Tangent moved = tangent(by_approach, problem.points(), {{}, 1, 0}),
                loaded = tangent(by_load, problem.points(), {{}, moved.result.dload, 0});
  check_near(loaded.p, moved.p, 1e-3 * norm(moved.p), "dp");
  check(loaded.result.error > 1.1 * moved.result.error && loaded.result.error < 2.1 * moved.result.error,
        "errors " + text(loaded.result.error) + " and " + text(moved.result.error));
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

// H of a chain whose ends are held. Conjugate gradients carry what the ends hold inwards by a point a step, and their residual
// does not fall before.
constexpr double chain_diagonal = 2 + 1e-7;

int chain(const double* x, double* y, std::int64_t n, void*) {
  for (std::int64_t i = 0; i < n; ++i) y[i] = chain_diagonal * x[i] - (i > 0 ? x[i - 1] : 0) - (i + 1 < n ? x[i + 1] : 0);
  return 0;
}

// p = 1 everywhere at approach 0.
Problem pressed_chain(std::int64_t nx, std::int64_t ny) {
  Problem problem;
  problem.system = RC_SYSTEM_INIT;
  problem.system.op = RC_OPERATOR_CALLBACK;
  problem.system.apply = chain;
  problem.system.nx = nx, problem.system.ny = ny, problem.system.hx = problem.system.hy = 1;
  problem.gap.resize(problem.points());
  chain(Field(problem.points(), -1).data(), problem.gap.data(), nx * ny, nullptr);
  return at_load(problem, static_cast<double>(nx * ny));
}

void a_product_whose_residuals_fall_late() {
  const Problem multiplied = pressed_chain(12, 9);
  const std::size_t n = multiplied.points();
  Field matrix(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    matrix[i * n + i] = chain_diagonal;
    if (i > 0) matrix[i * n + i - 1] = matrix[(i - 1) * n + i] = -1;
  }
  Problem factored = multiplied;
  factored.system.op = RC_OPERATOR_DENSE;
  factored.system.apply = nullptr;
  factored.system.dense = matrix.data();
  factored.system.dense_ld = factored.system.nx * factored.system.ny;
  std::mt19937 generator(4);
  const Change change{normals(n, generator), 0.3, 0};
  const Cotangents by{normals(n, generator), normals(n, generator), 0.3, -0.2};
  const Settings settings{{RC_OPT_STIFFNESS, "1"}};
  const Contact with_factors(factored, automatic, settings), without(multiplied, automatic, settings);
  const Answer exact = with_factors.solve(factored), answer = without.solve(multiplied);
  check_status(exact, RC_OK);
  check_status(answer, RC_OK);
  check_near(answer.result.stiffness, exact.result.stiffness, 1e-8 * exact.result.stiffness, "stiffness");
  const Tangent known = tangent(with_factors, n, change), forward = tangent(without, n, change);
  check_equal(forward.status, RC_OK, forward.message);
  check_near(forward.p, known.p, 1e-8 * norm(known.p), "dp");
  const Gradient right = gradient(with_factors, n, by), reverse = gradient(without, n, by);
  check_equal(reverse.status, RC_OK, reverse.message);
  check_near(reverse.by_gap, right.by_gap, 1e-8 * norm(right.by_gap), "dJ/dh");
}

// More points than conjugate gradients wait for: what they would give is 0.
void a_product_whose_residuals_fall_too_late() {
  const Problem problem = pressed_chain(60, 50);
  const Contact contact(problem, automatic, {{RC_OPT_STIFFNESS, "2"}});
  const Answer answer = contact.solve(problem);
  check_status(answer, RC_OK);
  check(std::isnan(answer.result.stiffness), "stiffness " + text(answer.result.stiffness));
  const Tangent forward = tangent(contact, problem.points(), {{}, 1, 0});
  check_equal(forward.status, RC_ERR_NUMERIC, "status");
  check(forward.message.find("3000 points in contact ended where it began") != std::string::npos, forward.message);
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
  Problem problem = rough_problem(12, 9);
  const Contact with(problem, automatic), without(problem, automatic);
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
                   RC_TESTS(a_load_adds_to_the_error, full_periodic_contact, a_product_whose_residuals_fall_late,
                            a_product_whose_residuals_fall_too_late, no_contact, the_same_bits_for_any_number_of_threads,
                            a_stopped_gradient_writes_nothing, a_gradient_leaves_the_contact_as_it_is),
                   argc, argv);
}
