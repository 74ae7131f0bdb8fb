// Control by contact area, if no load has that area or the load cannot be reached. Scenes test that areas and mean pressures are
// met and leave no trace of other loads; the table of errors has the refused targets.
#include <roughcontact/derivatives.h>
#include <roughcontact/history.h>

#include <cmath>
#include <numbers>

#include "support/surfaces.h"

namespace controls {

namespace {

using namespace pairs;

const Settings settings = {{RC_OPT_TOL, "1e-9"}};
const std::int32_t boundaries[] = {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC, RC_BOUNDARY_PERIODIC_X, RC_BOUNDARY_PERIODIC_Y};

double whole(const Problem& problem) { return static_cast<double>(problem.points()) * problem.cell_area(); }

Problem at_area(Problem problem, double share) {
  problem.control = RC_CONTROL_AREA;
  problem.target = share * whole(problem);
  return problem;
}

Problem rough(std::int32_t boundary) { return rough_problem(32, 28, boundary, 0.5, 0.75); }

// A solver that only knows approaches meets a load within the tolerance; its pressures then still fit the approach, to round-off.
void the_approach_fits_the_pressures() {
  for (const std::int32_t boundary : boundaries) {
    double largest_miss = 0;
    for (const double share : {0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9}) {
      const Problem problem = rough(boundary);
      const Problem by_load = at_load(problem, share * solved(problem, automatic, settings).result.load);
      const Answer found = solved(by_load, {"nnls", "dense"}, {{RC_OPT_TOL, "0.1"}});
      check_near(found.result.kkt_dual, 0, 1e-10, "overlap of the pressures' own approach");
      check_near(found.result.kkt_complementarity, 0, 1e-10, "gap below the pressures");
      largest_miss = std::max(largest_miss, found.result.kkt_control);
    }
    check(largest_miss > 1e-6, "each load is met to round-off: nothing is tested");
  }
}

void the_nearest_area_is_in_the_note() {
  Problem problem = rough_problem(32, 8, RC_BOUNDARY_PERIODIC);
  for (std::size_t i = 0; i < problem.gap.size(); ++i)
    problem.gap[i] = 1e-2 * (1 - std::cos(2 * std::numbers::pi * static_cast<double>(i % 32) / 32));
  const Answer found = solved(at_area(problem, 0.2), automatic, settings);
  check(found.result.area_fraction == 7.0 / 32, "whole columns: " + text(found.result.area_fraction));
  check(std::string(found.result.note).find("area: 20 % asked, 21.9 % of the grid is the nearest") == 0, found.result.note);
  check(solved(at_area(problem, 1), automatic, settings).result.area_fraction == 1, "all touches");
}

// An area that the mask rules out: all points that may touch do.
void an_area_that_no_load_reaches() {
  Problem problem = rough(RC_BOUNDARY_PERIODIC);
  problem.mask.assign(problem.points(), 1);
  for (std::size_t i = 0; i < problem.points(); i += 4) problem.mask[i] = 0;
  const Answer found = solved(at_area(problem, 0.9), automatic, settings);
  check_near(found.result.area_fraction, 0.75, 1e-12, "area");
  check(std::string(found.result.note).find("75 % of the grid is the nearest") != std::string::npos, found.result.note);
  problem.mask.assign(problem.points(), 0);
  check_equal(solved(at_area(problem, 0.9), automatic, settings).result.contacts, 0, "nothing may touch");
  Problem hard = rough(RC_BOUNDARY_FREE);
  hard.system.hardness = 1e-2;
  check_near(solved(at_area(hard, 1), automatic, settings).result.area_fraction, 1, 1e-3, "all at the hardness");
  Problem flat = rough(RC_BOUNDARY_FREE);
  flat.gap.assign(flat.points(), 2);
  check_near(solved(at_area(flat, 1), automatic, settings).result.area_fraction, 1, 1e-12, "a flat touches everywhere");
}

// A step after the search starts from its answer; derivatives are those at the load found.
void the_load_found_is_the_last_step() {
  const Problem problem = rough(RC_BOUNDARY_FREE);
  const Contact contact(problem, automatic, settings), other(problem, automatic, settings);
  const Answer found = contact.solve(at_area(problem, 0.15));
  check_status(other.solve(at_load(problem, found.result.load)), RC_OK);
  const auto gradient = [](const Contact& of) {
    rc_gradient g = RC_GRADIENT_INIT;
    check(rc_contact_gradient(of.handle(), &g) == RC_OK, rc_last_error());
    return g;
  };
  check_near(gradient(contact).dJ_dtarget, gradient(other).dJ_dtarget, 1e-6 * std::abs(gradient(other).dJ_dtarget), "dd/dW");
  std::int64_t n = 0;
  check(rc_contact_points(contact.handle(), 0, {}, {}, &n) == RC_OK && n == found.result.contacts, "points");
  // A search that is stopped keeps the last certified step.
  const Contact few(problem, automatic, {settings[0], {RC_OPT_MAX_ITER, "30"}});
  check_status(few.solve(at_load(problem, 1e-3 * found.result.load)), RC_OK);
  std::int64_t kept = 0, after = 0;
  rc_contact_points(few.handle(), 0, {}, {}, &kept);
  check_status(few.solve(at_area(problem, 0.4)), RC_STOP_MAX_ITER, "iterations of all loads count");
  rc_contact_points(few.handle(), 0, {}, {}, &after);
  check_equal(after, kept, "points of the last certified step");
  Problem hard = problem;
  hard.system.hardness = 1e-2;
  const Contact stopped(hard, automatic, {settings[0], {RC_OPT_MAX_ITER, "3"}});
  check_status(stopped.solve(at_area(hard, 0.3)), RC_STOP_MAX_ITER);
  Field depth(problem.points());
  check(rc_contact_indentation(stopped.handle(), RC_OUT(depth.data())) == RC_OK && largest(depth) == 0,
        "no indentation after a stop");
}

std::vector<Test> tests() {
  return RC_TESTS(the_approach_fits_the_pressures, the_nearest_area_is_in_the_note, an_area_that_no_load_reaches,
                  the_load_found_is_the_last_step);
}

}  // namespace

}  // namespace controls

int main(int argc, char** argv) { return pairs::run_group("controls", controls::tests(), argc, argv); }
