// The core's services around a solver: warm-ups, hand-overs and refusals.
#include <cstring>
#include <limits>

#include "support/contact.h"
#include "support/plugins.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

bool mentions(const rc_result& result, const char* words) { return std::strstr(result.note, words) != nullptr; }

void warm_up_that_cannot_run_is_refused() {
  const double one = 1;
  Problem of_matrix;  // of one point
  of_matrix.system.op = RC_OPERATOR_DENSE;
  of_matrix.system.dense = &one;
  of_matrix.system.dense_ld = 1;
  of_matrix.gap = {0};
  of_matrix.target = 0.5;
  for (const char* first : {"cmr", "haar-cg"}) {
    const Answer answer = solve(of_matrix, {"nnls", "dense"}, {{RC_OPT_WARMUP, first}});
    check_status(answer, RC_ERR_INCOMPATIBLE);
    check(answer.message.find("warmup") != std::string::npos, answer.message);
  }
  for (const char* first : {"nnls", "admm"})
    check_status(solve(rough_problem(20, 20), {"polonsky-keer", "fft"}, {{RC_OPT_WARMUP, first}, {RC_OPT_ALLOW_FALLBACK, "0"}}),
                 RC_ERR_INCOMPATIBLE);
}

void every_solver_warms_up_every_other() {
  const Problem problem = rough_problem(24, 20);
  const Answer plain = solved(problem, {"nnls", "dense"});
  for (const std::string& first : solver_names())
    for (const char* solver : {"nnls", "polonsky-keer", "haar-cg"})
      check_near(solved(problem, {solver, "dense"}, {{RC_OPT_WARMUP, first}, {RC_OPT_WARMUP_ITERATIONS, "7"}}).p, plain.p, 1e-9,
                 first + " before " + solver);
}

void a_warm_up_counts_among_the_iterations() {
  for (const std::string& first : solver_names())
    for (const std::string& solver : solver_names()) {
      const Answer answer = solve(rough_problem(24, 20), {solver, "dense"}, {{RC_OPT_WARMUP, first}, {RC_OPT_MAX_ITER, "2"}});
      check(answer.status >= 0 && answer.result.iterations <= 2, first + " before " + solver + ": " +
                                                                     std::to_string(answer.result.iterations) +
                                                                     " iterations, status " + std::to_string(answer.status));
    }
}

void warm_up_without_load_control_is_named() {
  const Problem problem = at_load(rough_problem(24, 20), 20);
  const Answer answer = solved(problem, {"polonsky-keer", "fft"}, {{RC_OPT_WARMUP, "cmr"}});
  check(mentions(answer.result, "warmup"), answer.result.note);
}

// From a few contacts to loads far beyond full contact.
void periodic_load_control_needs_no_hand_over() {
  Problem problem;
  problem.system.nx = problem.system.ny = 48;
  problem.system.boundary = RC_BOUNDARY_PERIODIC;
  problem.gap = rough_heights(48, 48, 5);
  const double top = largest(problem.gap);
  for (double& gap : problem.gap) gap = top - gap;
  for (const double load : {1e-2, 1.0, 1e2, 1e4, 1e6}) {
    const Answer answer = solved(at_load(problem, load), {"haar-cg", "fft"}, {{"tol", "1e-8"}});
    check(!mentions(answer.result, "stalled"), text(load) + ": " + answer.result.note);
    check(answer.result.iterations < 200, text(load) + ": " + std::to_string(answer.result.iterations) + " iterations");
  }
}

// The penetration of the flattest contact is 0 under any load.
void flat_on_flat_is_certified() {
  for (const char* solver : {"haar-cg", "polonsky-keer", "nnls", "gp"})
    for (const double bump : {0.0, 1e-9, 1e-3}) {
      Problem problem;
      problem.system.nx = 16;
      problem.system.ny = 12;
      problem.system.boundary = RC_BOUNDARY_PERIODIC;
      problem.gap.assign(problem.points(), 0.1);
      for (std::size_t i = 0; i < problem.points(); i += 5) problem.gap[i] += bump;
      const double load = 3.7;
      const Answer answer = solved(at_load(problem, load), {solver, "fft"}, {{"tol", "1e-9"}});
      check_equal(answer.result.contacts, static_cast<std::int64_t>(problem.points()), "contacts");
    }
}

void refused_certificate_changes_nothing() {
  const Problem problem = rough_problem(16, 16);
  const Contact contact(problem, {"nnls", "dense"});
  const Answer before = contact.solve(problem);
  Problem other = problem;
  for (double& gap : other.gap) gap *= 3;
  Field p = before.p;
  p[7] = std::numeric_limits<double>::quiet_NaN();
  check_status(contact.certify(other.step(), p), RC_ERR_ARGUMENT);
  rc_step same = problem.step();
  same.undeformed_gap.data = nullptr;
  check_near(contact.solve(same).p, before.p, 1e-12, "p after a refused certificate");
}

// Remarks are whole, the solver's own first.
void note_is_never_cut() {
  const Answer answer =
      solve(at_load(rough_problem(32, 32), 30), {"cmr", "fft"}, {{"cmr.inner", "nnls"}, {"cmr.filter", "subsample"}});
  const std::string note = answer.result.note;
  check(note.rfind("cmr: trial set", 0) == 0, note);
  check(note.size() < sizeof answer.result.note - 1, note);
}

void area_wider_than_the_grid_keeps_everything() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const Problem problem = rough_problem(37, 64, boundary);
    const Answer answer = solved(problem, {"cmr", "fft"}, {{"cmr.radius", "1000"}, {"cmr.levels", "2"}});
    const std::string all = std::to_string(answer.result.candidates);
    check(mentions(answer.result, ("trial set " + all + " of " + all + " after 1 rounds").c_str()), answer.result.note);
  }
}

// A solver that sees doubles although the gap has floats, also if another solver warms up for it.
Field seen;
rc_status look(const rc_host*, const rc_problem* problem, const rc_options*, double*, double*) {
  const rc_grid& grid = *problem->grid;
  if (grid.undeformed_gap.type != RC_NATIVE || !grid.undeformed_gap.data) return RC_STOP_STALLED;
  const auto* const gap = static_cast<const double*>(grid.undeformed_gap.data);
  seen.assign(gap, gap + grid.nx * grid.ny);
  return RC_STOP_STALLED;
}

void solvers_that_ask_for_nothing_new_see_doubles() {
  rc_solver solver = support::solver("looks", look);
  solver.needs = RC_NEEDS_GRID;
  Problem problem = rough_problem(33, 26);
  const std::vector<float> gap(problem.gap.begin(), problem.gap.end());
  problem.gap.assign(gap.begin(), gap.end());
  rc_step step = problem.step();
  step.undeformed_gap = {gap.data(), RC_SINGLE, 0, nullptr};
  step.borrow = 1;
  for (const char* first : {"none", "haar-cg"}) {
    rc_context* made = nullptr;
    check(rc_context_create(0, nullptr, nullptr, nullptr, &made) == RC_OK, rc_last_error());
    const Context context(made);
    check(support::add(made, solver) == RC_OK, rc_last_error());
    const Contact contact(problem, {"looks", "dense"}, {{"warmup", first}}, context.get());
    seen.clear();
    const rc_status expected = std::string(first) == "none" ? RC_STOP_STALLED : RC_OK;
    check_status(contact.solve(step), expected);
    check_same(seen, problem.gap, "what the solver saw");
  }
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group(
      "pairs.services",
      RC_TESTS(warm_up_that_cannot_run_is_refused, every_solver_warms_up_every_other, a_warm_up_counts_among_the_iterations,
               warm_up_without_load_control_is_named, periodic_load_control_needs_no_hand_over, flat_on_flat_is_certified,
               refused_certificate_changes_nothing, note_is_never_cut, area_wider_than_the_grid_keeps_everything,
               solvers_that_ask_for_nothing_new_see_doubles),
      argc, argv);
}
