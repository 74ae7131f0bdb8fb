// Cascade multi-resolution: what it leaves out and what it gives back. That its answers are right is a property of tests/scenes.
#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>

#include "support/contact.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr std::int64_t side = 96;

Problem scene() { return rough_problem(side, side); }

// A shallow dome, and between the points of any coarser grid a single peak that a sub-sampled cascade does not see.
Problem hidden_peak() {
  Problem problem;
  problem.system.nx = problem.system.ny = 64;
  problem.gap = paraboloid(64, 64, 1, 12, 12, 400);
  problem.gap[45 * 64 + 51] = 0;
  problem.target = 0.3;
  return problem;
}

const Settings published = {{"cmr.certified", "0"}, {"cmr.filter", "subsample"}, {"cmr.area", "side"}};

Settings with(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

std::vector<rc_level> levels_of(const Contact& contact, const Answer& answer, std::vector<Field>& pressures) {
  std::vector<rc_level> levels;
  for (std::int64_t i = 0; i < answer.result.levels; ++i) {
    rc_level level = RC_LEVEL_INIT;
    check(rc_contact_level(contact.handle(), i, &level) == RC_OK, rc_last_error());
    pressures.emplace_back(static_cast<std::size_t>(level.nx * level.ny));
    level.p = RC_OUT(pressures.back().data());
    check(rc_contact_level(contact.handle(), i, &level) == RC_OK, rc_last_error());
    levels.push_back(level);
  }
  return levels;
}

void every_inner_solver_serves() {
  const Problem problem = scene();
  const Answer full = solved(problem, {"nnls", "dense"});
  for (const std::string& inner : solver_names()) {
    if (inner == "cmr") continue;
    const Answer answer = solved(problem, {"cmr", "dense"}, {{"tol", "1e-8"}, {"cmr.inner", inner}, {"max_iter", "100000"}});
    check_near(answer.p, full.p, 1e-5, inner);
  }
}

void a_cascade_inside_a_cascade_is_refused() {
  const Answer answer = solve(scene(), {"cmr", "dense"}, {{"cmr.inner", "cmr"}});
  check_status(answer, RC_ERR_INCOMPATIBLE);
  check(answer.message.find("cmr.inner") != std::string::npos, answer.message);
}

// As published, the peak is lost and the library says so; certified, it is found.
void a_hidden_peak_is_detected_and_found() {
  const Problem problem = hidden_peak();
  const Settings coarse = {{"cmr.filter", "subsample"}, {"cmr.levels", "3"}};
  const Answer full = solved(problem, {"nnls", "dense"});
  const Answer plain = solve(problem, {"cmr", "dense"}, with(published, coarse));
  check_status(plain, RC_UNCERTIFIED);
  check(plain.result.kkt_dual > 0.1, "the peak overlaps by " + text(plain.result.kkt_dual));
  check(plain.p[45 * 64 + 51] == 0, "the peak carries pressure");
  const Answer certified = solved(problem, {"cmr", "dense"}, coarse);
  check_near(certified.p, full.p, 1e-9, "p");
  const Answer by_gap = solved(problem, {"cmr", "dense"}, with(coarse, {{"cmr.select", "gap"}}));
  check_near(by_gap.p, full.p, 1e-9, "p, selected by gaps");
  check(std::string(by_gap.result.note).find("points added") == std::string::npos, by_gap.result.note);
  check(std::string(certified.result.note).find("points added") != std::string::npos, certified.result.note);
}

void coarse_solutions_are_given_back() {
  const Problem problem = scene();
  const Contact contact(problem, {"cmr", "fft"}, {{"cmr.levels", "3"}});
  const Answer answer = contact.solve(problem);
  check_status(answer, RC_OK);
  check_equal(answer.result.levels, 2, "levels");
  std::vector<Field> pressures;
  const std::vector<rc_level> levels = levels_of(contact, answer, pressures);
  check_equal(levels[0].nx, side / 4, "coarsest nx");
  check_equal(levels[1].nx, side / 2, "finer nx");
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const rc_level& level = levels[k];
    const double factor = static_cast<double>(side / level.nx);
    check_near(level.hx, factor * problem.system.hx, 0, "hx");
    check_near(level.load, sum(pressures[k]) * level.hx * level.hy, 1e-12 * level.load, "load");
    check(level.contacts > 0 && level.candidates >= level.contacts, "contacts of a level");
    check_equal(level.status, RC_OK, "status of a level");
  }
  // The coarsest is a problem of its own: the smallest gap of every block of 4 x 4 cells.
  Problem coarse = problem;
  coarse.system.nx = coarse.system.ny = side / 4;
  coarse.system.hx *= 4;
  coarse.system.hy *= 4;
  coarse.gap.assign(static_cast<std::size_t>(side / 4 * (side / 4)), 1e300);
  for (std::int64_t i = 0; i < side * side; ++i) {
    double& low = coarse.gap[static_cast<std::size_t>(i / side / 4 * (side / 4) + i % side / 4)];
    low = std::min(low, problem.gap[static_cast<std::size_t>(i)]);
  }
  const Answer alone = solved(coarse, {"nnls", "dense"});
  check_near(pressures[0], alone.p, 1e-8, "coarsest pressures");
  check_near(levels[0].approach, coarse.target, 1e-12, "coarsest approach");
  rc_level none = RC_LEVEL_INIT;
  check(rc_contact_level(contact.handle(), 2, &none) == RC_ERR_ARGUMENT, "a level that is not there");
}

void other_solvers_leave_no_levels() {
  const Problem problem = scene();
  const Contact contact(problem, {"cmr", "fft"});
  check(contact.solve(problem).result.levels > 0, "no levels");
  Options options = make_options({"polonsky-keer", "fft"}, "auto");
  check(rc_contact_set_options(contact.handle(), options.get()) == RC_OK, rc_last_error());
  check_equal(contact.solve(problem).result.levels, 0, "levels of the step before");
}

// A periodic approach beyond the coarse grid's mean plane has no coarse solution: nothing is left out.
void without_a_coarse_contact_everything_is_kept() {
  Problem problem;
  problem.system.nx = problem.system.ny = 64;
  problem.system.boundary = RC_BOUNDARY_PERIODIC;
  problem.gap.assign(64 * 64, 0);
  for (std::size_t i = 0; i < problem.gap.size(); ++i) problem.gap[i] = (i % 64 + i / 64) % 2 == 0 ? 0.0 : 1.0;
  problem.target = 0.4;  // of a checkerboard whose coarser grids are flat
  const Answer answer = solved(problem, {"cmr", "fft"});
  check(std::string(answer.result.note).find("every candidate was kept") != std::string::npos, answer.result.note);
  const Answer full = solved(problem, {"nnls", "dense"});
  check_near(answer.p, full.p, 1e-9, "p");
}

void the_wider_reading_keeps_more_points() {
  const Problem problem = scene();
  double loads[2];
  int k = 0;
  for (const char* area : {"side", "diagonal"})
    loads[k++] =
        solve(problem, {"cmr", "fft"}, {{"cmr.certified", "0"}, {"cmr.filter", "subsample"}, {"cmr.area", area}}).result.load;
  const double exact = solved(problem, {"polonsky-keer", "fft"}).result.load;
  report("load error with h*side " + text(loads[0] / exact - 1) + ", with h*diagonal " + text(loads[1] / exact - 1));
  check(loads[0] <= loads[1] * (1 + 1e-9) && loads[1] <= exact * (1 + 1e-9), "restricting the trial set raised the load");
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  const std::vector<Test> tests =
      RC_TESTS(every_inner_solver_serves, a_cascade_inside_a_cascade_is_refused, a_hidden_peak_is_detected_and_found,
               coarse_solutions_are_given_back, other_solvers_leave_no_levels, without_a_coarse_contact_everything_is_kept,
               the_wider_reading_keeps_more_points);
  return run_group("pairs.cmr", tests, argc, argv);
}
