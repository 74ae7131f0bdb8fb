// Option accuracy: what a result from a coarser grid says, and where the whole grid is solved.
#include <roughcontact/history.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "hidden_tests.h"
#include "statistics_tests.h"

namespace accuracy {

namespace {

constexpr double wanted = 0.03;

Problem smooth(std::int32_t boundary = RC_BOUNDARY_FREE) { return waves_problem(256, boundary, 5, 0.4); }

Answer within_goal(const Problem& problem, const Settings& settings) {
  Answer answer = solve(problem, automatic, settings);
  check_status(answer, RC_WITHIN_GOAL);
  return answer;
}

void result_says_what_was_modelled() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const Problem problem = smooth(boundary);
    const Answer found = within_goal(problem, goal(wanted, "load"));
    const rc_result& r = found.result;
    const std::int64_t factor = problem.system.nx / r.model_nx;
    check(factor >= 2 && factor * r.model_nx == problem.system.nx && factor * r.model_ny == problem.system.ny, "model_nx");
    check(r.error_estimate > 0 && r.error_estimate <= wanted, "error_estimate");
    check_near(r.tolerance, wanted / 100, 1e-12, "tolerance");
    check(found.message.find("within accuracy") != std::string::npos, found.message);
    check(std::isnan(r.duality_gap) && r.proven_contacts == -1 && r.undecided == -1, "nothing is proven");
    check_equal(r.points, problem.system.nx * problem.system.ny, "points");
    check_near(r.load, sum(found.p) * problem.cell_area(), 1e-12 * r.load, "load");
    check_equal(r.contacts, std::count_if(found.p.begin(), found.p.end(), [](double p) { return p > 0; }), "contacts");
    check_near(r.contact_area, static_cast<double>(r.contacts) * problem.cell_area(), 1e-9 * r.contact_area, "contact_area");

    check(r.area_estimate > 0, "area_estimate");

    // Everything but the estimates follows from the pressures on the given grid.
    const Answer judged = Contact(problem, automatic, {{RC_OPT_TOL, text(wanted)}}).certify(problem.step(), found.p);
    check_near(found.gap, judged.gap, 1e-5, "gap");
    check_near(r.kkt_dual, judged.result.kkt_dual, 1e-4, "kkt_dual");
    check_near(r.kkt_complementarity, judged.result.kkt_complementarity, 1e-4, "kkt_complementarity");
    check_near(r.energy, judged.result.energy, 1e-4 * std::abs(r.energy), "energy");
    check(r.kkt_primal == 0, "no pressure is negative");

    const Problem coarse = block_means(problem, factor);
    double details = 0;
    for (std::int64_t iy = 0; iy < problem.system.ny; ++iy)
      for (std::int64_t ix = 0; ix < problem.system.nx; ++ix) {
        const auto fine = static_cast<std::size_t>(iy * problem.system.nx + ix);
        const auto block = static_cast<std::size_t>(iy / factor * coarse.system.nx + ix / factor);
        if (found.p[fine] > 0) details += std::pow(problem.gap[fine] - coarse.gap[block], 2);
      }
    check_near(r.left_out, std::sqrt(details / static_cast<double>(r.contacts)), 1e-9 * r.left_out, "left_out");
  }
}

void tight_goals_take_the_whole_grid() {
  Problem problem = smooth();
  std::mt19937 random(3);
  for (double& value : problem.gap) value += 1e-2 * problem.target * (static_cast<double>(random()) / 4294967296.0);
  for (const char* const of : {"load", "area"}) {
    const Answer found = solved(problem, automatic, goal(1e-4, of));
    check_equal(found.result.model_nx, problem.system.nx, "model_nx");
    check(found.result.error_estimate == 0 && found.result.left_out == 0, "nothing is left out");
    const double tol = of == std::string("area") ? 1e-7 : 1e-6;
    check_near(found.result.tolerance, tol, 1e-18, "tolerance");
    check(found.worst_residual() <= tol, "residuals");
  }
}

// All of every coarser grid touches, and none of them differs from the next.
void openings_that_no_coarser_grid_shows_are_seen() {
  Problem problem;
  problem.system.boundary = RC_BOUNDARY_PERIODIC;
  problem.system.nx = problem.system.ny = 128;
  std::mt19937 random(5);
  for (std::size_t i = 0; i < problem.points(); ++i)
    problem.gap.push_back(1 + 1e-2 * static_cast<double>(random()) / 4294967296.0 +
                          1e-4 * std::cos(2 * std::numbers::pi * static_cast<double>(i % 128) / 128));
  problem = at_load(problem, 2e-3 * static_cast<double>(problem.points()));
  const Answer exact = solved(problem, automatic, {{RC_OPT_TOL, "1e-9"}});
  check(exact.result.contacts < 0.9 * static_cast<double>(problem.points()), "the whole grid has openings");
  const Answer found = solve(problem, automatic, goal(0.1, "area"));
  check_near(found.result.contact_area, exact.result.contact_area, 0.1 * exact.result.contact_area, "contact area");
}

void without_a_goal_nothing_changes() {
  const Answer found = solved(smooth(), automatic, {{RC_OPT_TOL, "1e-7"}});
  check(std::isnan(found.result.error_estimate) && found.result.left_out == 0, "no estimate");
  check_equal(found.result.model_nx, 256, "model_nx");
  check(found.result.tolerance == 1e-7, "tolerance");
}

// The last blocks are cut by the grid's end and by the mask.
void load_is_kept_on_cut_blocks() {
  Problem problem = waves_problem(301, RC_BOUNDARY_FREE, 2, 0.4);
  problem.system.ny = 277;
  problem.gap.resize(problem.points());
  problem.mask.assign(problem.points(), 1);
  for (std::size_t i = 0; i < problem.mask.size(); ++i)
    if (i % 301 < 37) problem.mask[i] = 0;
  const double load = solved(problem, automatic, {{RC_OPT_TOL, "1e-8"}}).result.load;
  const Answer found = within_goal(at_load(problem, load), goal(0.1, "load"));
  check_near(found.result.load, load, 1e-3 * load, "load");
  check_near(sum(found.p) * problem.cell_area(), load, 1e-3 * load, "sum of the pressures");
  for (std::size_t i = 0; i < problem.mask.size(); ++i)
    if (problem.mask[i] == 0) check(found.p[i] == 0, "masked points carry nothing");
}

// Coarser grids stand for more than the grid, and for points that the mask leaves out: all by the same, so that their differences
// do not tell.
void cut_blocks_are_seen() {
  Problem cut;
  cut.system.nx = cut.system.ny = 127;
  cut.gap.assign(cut.points(), 0.0);
  cut.target = 1;
  Problem sieve = cut;
  sieve.system.nx = sieve.system.ny = 128;
  sieve.gap.assign(sieve.points(), 0.0);
  sieve.mask.assign(sieve.points(), 0);
  for (std::size_t i = 0; i < sieve.mask.size(); ++i) sieve.mask[i] = i % 2 == 0 && i / 128 % 2 == 0;
  for (const Problem& problem : {cut, sieve})
    for (const double error : {0.05, 0.005}) {
      const Answer found = solve(problem, automatic, goal(error, "load"));
      check(found.status == RC_OK || found.status == RC_WITHIN_GOAL, found.message);
      const double load = solved(problem, automatic, {{RC_OPT_TOL, "1e-8"}}).result.load;
      check_near(found.result.load, load, error * load, "load");
    }
}

void threads_give_the_same_bits() {
  for (const Problem& by_approach : {smooth(), midpoint_problem(8, 0.7, 3, 0.3)}) {
    const double load = solved(by_approach, automatic, {{RC_OPT_TOL, "1e-6"}}).result.load;
    for (const Problem& problem : {by_approach, at_load(by_approach, load)}) {
      Settings one = goal(0.05, "load"), two = one;
      one.emplace_back(RC_OPT_THREADS, "1");
      two.emplace_back(RC_OPT_THREADS, "2");
      const Answer first = solve(problem, automatic, one), second = solve(problem, automatic, two);
      check_equal(second.status, first.status, "status");
      check_same(first.p, second.p, "pressures");
    }
  }
}

// Also where squares of heights are beyond double precision.
void units_and_scales_do_not_matter() {
  const Problem problem = smooth();
  const Answer found = within_goal(problem, goal(wanted, "load"));
  for (const auto& [length, height, modulus] :
       {std::array{1e-9, 1.0, 3e7}, {1e6, 1.0, 3e7}, {1e-90, 1e-80, 1.0}, {1e90, 1e-80, 1.0}}) {
    Problem other = problem;
    other.system.hx *= length;
    other.system.hy *= length;
    other.system.modulus = modulus;
    other.target *= height * length;
    for (double& value : other.gap) value *= height * length;
    const Answer same = within_goal(other, goal(wanted, "load"));
    check_equal(same.result.model_nx, found.result.model_nx, "model_nx");
    check_near(same.result.error_estimate, found.result.error_estimate, 1e-6 * wanted, "error_estimate");
    check_near(same.result.load / modulus / height / length / length, found.result.load, 1e-6 * found.result.load, "load");
    check_near(same.result.left_out / height / length, found.result.left_out, 1e-9 * found.result.left_out, "left_out");
  }
}

void every_solver_may_have_a_goal() {
  const Problem problem = waves_problem(128, RC_BOUNDARY_FREE, 5, 0.4);
  const double load = solved(problem, automatic, {{RC_OPT_TOL, "1e-8"}}).result.load;
  for (const char* const solver : {"haar-cg", "polonsky-keer", "nnls", "gp", "admm", "cmr"})
    for (const char* const backend : {"auto", "fft"}) {
      const Answer found = solve(problem, {solver, backend}, goal(0.1, "load"));
      check_status(found, RC_WITHIN_GOAL, solver);
      check_near(found.result.load, load, 0.1 * load, solver);
      check(std::string(found.result.solver) == solver, found.result.solver);
    }
}

void stored_matrices_have_no_coarser_grid() {
  Problem problem = waves_problem(12, RC_BOUNDARY_FREE, 1, 0.5);
  const std::size_t n = problem.points();
  Field matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] = 1;
  problem.system.op = RC_OPERATOR_DENSE;
  problem.system.dense = matrix.data();
  problem.system.dense_ld = static_cast<std::int64_t>(n);
  const Answer found = solved(problem, automatic, goal(0.1, "load"));
  check_equal(found.result.model_nx, 12, "model_nx");
  check_near(found.result.tolerance, 1e-3, 1e-15, "tolerance");
}

void no_contact_is_certified() {
  Problem problem = smooth();
  problem.target = -1;
  const Answer found = solved(problem, automatic, goal(wanted, "load"));
  check(found.result.contacts == 0 && found.result.load == 0, "nothing touches");
}

void histories_go_on_within_their_goal() {
  const Problem problem = smooth();
  const std::array targets = {0.2 * problem.target, 0.6 * problem.target, problem.target};
  std::array<double, 3> load{};
  const Contact contact(problem, automatic, goal(wanted, "load"));
  rc_history path = RC_HISTORY_INIT;
  path.control = RC_CONTROL_APPROACH;
  path.n = 3;
  path.targets = RC_IN(targets.data());
  path.undeformed_gap = RC_IN(problem.gap.data());
  path.columns.load = RC_OUT(load.data());
  int known = 0;
  path.user = &known;
  path.fn = [](std::int64_t, const rc_result* result, void* user) -> std::int32_t {
    const bool coarser = result->model_nx < 256 && result->error_estimate > 0 && result->error_estimate <= wanted;
    *static_cast<int*>(user) += coarser == (result->status == RC_WITHIN_GOAL);
    return 0;
  };
  check_equal(rc_contact_solve_history(contact.handle(), &path), RC_WITHIN_GOAL, "status of the path");
  check(std::string(rc_last_error()).find("within accuracy") != std::string::npos, rc_last_error());
  check_equal(known, 3, "steps whose accuracy the callback saw");
  check_equal(path.completed, 3, "completed");
  for (std::size_t k = 0; k < targets.size(); ++k) {
    Problem step = problem;
    step.target = targets[k];
    check_near(load[k], solved(step, automatic, {{RC_OPT_TOL, "1e-8"}}).result.load, wanted * load[k], "load");
  }
  std::int64_t points = 0;
  check_equal(rc_contact_points(contact.handle(), 0, {}, {}, &points), RC_OK, "rc_contact_points");
  check_equal(points, within_goal(problem, goal(wanted, "load")).result.contacts, "points in contact");

  // Another surface, then the first again: as new.
  const Answer other = contact.solve(waves_problem(256, RC_BOUNDARY_FREE, 9, 0.4));
  check_status(other, RC_WITHIN_GOAL, "another surface");
  rc_step again = problem.step();
  again.warm_start = 0;
  check_near(contact.solve(again).p, solve(problem, automatic, goal(wanted, "load")).p, 1e-9, "the first surface again");
}

void batches_go_on_within_their_goal() {
  const Problem problem = smooth();
  const Options options = make_options(automatic, "auto", goal(wanted, "load"));
  Field gaps;
  for (int k = 0; k < 3; ++k) gaps.insert(gaps.end(), problem.gap.begin(), problem.gap.end());
  std::array<double, 3> targets = {problem.target, 0.5 * problem.target, -1}, load{};
  std::array<rc_status, 3> status{};
  rc_batch batch = RC_BATCH_INIT;
  batch.control = RC_CONTROL_APPROACH;
  batch.n = 3;
  batch.steps = 1;
  batch.undeformed_gap = RC_IN(gaps.data());
  batch.targets = RC_IN(targets.data());
  batch.columns.load = RC_OUT(load.data());
  batch.columns.status = RC_OUT(status.data());
  check_equal(rc_batch_solve(&problem.system, options.get(), &batch), RC_WITHIN_GOAL, "status of the batch");
  check_equal(status[0], RC_WITHIN_GOAL, "status of a contact");
  check_equal(status[2], RC_OK, "status of the contact that does not touch");
  check_equal(batch.certified, 1, "certified");
  check(load[0] == within_goal(problem, goal(wanted, "load")).result.load, "the load of the contact alone");
}

void goal_is_fixed() {
  const Problem problem = smooth();
  const Contact contact(problem, automatic, goal(wanted, "load"));
  const Options other = make_options(automatic, "auto", goal(0.2, "load"));
  check_equal(rc_contact_set_options(contact.handle(), other.get()), RC_ERR_OPTION, "another goal");
  const Options looser = make_options(automatic, "auto", goal(wanted, "load", "1e-3"));
  check_equal(rc_contact_set_options(contact.handle(), looser.get()), RC_OK, "another tolerance");
  check_near(contact.solve(problem).result.tolerance, 1e-3, 1e-15, "tolerance");
}

void cancelled_is_cancelled() {
  const Problem problem = smooth();
  const Contact contact(problem, automatic, goal(wanted, "load"));
  rc_contact_cancel(contact.handle());
  check_status(contact.solve(problem), RC_STOP_CANCELLED);
  check_status(contact.solve(problem), RC_WITHIN_GOAL, "the next");
}

void progress_is_reported_and_may_stop() {
  struct Watch {
    int calls = 0;
    int last = 0;  // the call that stops; 0: none
    static std::int32_t see(const rc_progress*, void* user) {
      Watch& watch = *static_cast<Watch*>(user);
      return ++watch.calls == watch.last;
    }
  } watch;
  const Problem problem = smooth();
  const Contact contact(problem, automatic, goal(wanted, "load"));
  check_equal(rc_contact_on_progress(contact.handle(), Watch::see, &watch, 1), RC_OK, "rc_contact_on_progress");
  rc_step step = problem.step();
  step.warm_start = 0;
  check_status(contact.solve(step), RC_WITHIN_GOAL);
  check(watch.calls > 3, "calls of the callback");
  for (const int last : {1, watch.calls - 1}) {
    watch = {0, last};
    const Answer stopped = contact.solve(step);
    check_status(stopped, RC_STOP_CANCELLED, "stopped");
    check(std::isfinite(stopped.result.load) && stopped.result.model_nx > 0, "what was found is written");
    check(last == 1 || (stopped.result.model_nx < 256 && std::isnan(stopped.result.error_estimate)),
          "the last grid that was solved");
  }
  check_equal(watch.calls, watch.last, "no call after the stop");
}

void work_on_coarser_grids_is_counted() {
  Problem problem = smooth();
  std::mt19937 random(3);
  for (double& value : problem.gap) value += 1e-2 * problem.target * (static_cast<double>(random()) / 4294967296.0);
  const Answer with = solved(problem, automatic, goal(1e-4, "load")),
               without = solved(problem, automatic, {{RC_OPT_TOL, "1e-6"}});
  check(with.result.products > without.result.products, "products");
}

}  // namespace

}  // namespace accuracy

int main(int argc, char** argv) {
  using namespace accuracy;
  std::vector<Test> tests =
      RC_TESTS(result_says_what_was_modelled, tight_goals_take_the_whole_grid, openings_that_no_coarser_grid_shows_are_seen,
               without_a_goal_nothing_changes, load_is_kept_on_cut_blocks, cut_blocks_are_seen, progress_is_reported_and_may_stop,
               work_on_coarser_grids_is_counted, threads_give_the_same_bits, units_and_scales_do_not_matter,
               every_solver_may_have_a_goal, stored_matrices_have_no_coarser_grid, no_contact_is_certified,
               histories_go_on_within_their_goal, batches_go_on_within_their_goal, goal_is_fixed, cancelled_is_cancelled);
  for (const auto& group : {hidden_tests(), statistics_tests()}) tests.insert(tests.end(), group.begin(), group.end());
  return run_group("accuracy", tests, argc, argv);
}
