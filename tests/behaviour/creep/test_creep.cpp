// Bodies that creep: closed forms, steps against elastic bodies, what leaves nothing. Other properties of their steps, histories,
// batches and restarts are those of scenes.
#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Table {
  Field ratio, time;
  std::int32_t by = RC_CREEP_COMPLIANCES;

  double compliance(double t) const {
    double sum = 1;
    for (std::size_t k = 0; k < ratio.size(); ++k) sum += ratio[k] * (1 - std::exp(-t / time[k]));
    return sum;
  }
};

const Table one{{3}, {1}};
const Table two{{0.7, 2}, {0.3, 5}};

struct Step {
  double time, target;
};

rc_step at(const Problem& problem, const Step& step) {
  rc_step asked = problem.step();
  asked.target = step.target;
  asked.time = step.time;
  return asked;
}

Problem creeping(Problem problem, const Table& table) {
  problem.system.creep_by = table.by;
  problem.system.creep_terms = static_cast<std::int32_t>(table.ratio.size());
  problem.system.creep_ratio = RC_IN(table.ratio.data());
  problem.system.creep_time = RC_IN(table.time.data());
  return problem;
}

// Times of all sizes, pauses and jumps: an approach or load that rises, falls and rests.
std::vector<Step> path(double target) {
  return {{1, 0.6 * target}, {1, target},         {1.001, target}, {1.3, target},       {2, 0.8 * target},
          {2, 0.5 * target}, {2.5, 0.7 * target}, {9, target},     {500, 1.1 * target}, {500, 0.3 * target}};
}

Field creep_of(const Contact& contact, std::size_t values, double* time = nullptr) {
  Field said(values, -7);
  check(rc_contact_creep(contact.handle(), RC_OUT(said.data()), time) == RC_OK, rc_last_error());
  return said;
}

// The elastic problem that a step is, by the memory that the steps before it have left: a softer body, and another gap.
Problem softer(const Problem& elastic, const Table& table, const Contact& contact, const Step& step) {
  Problem now = elastic;
  now.target = step.target;
  const std::size_t n = elastic.points();
  double before = nan, compliance = 1;
  const Field left = creep_of(contact, (table.ratio.size() + 1) * n, &before);
  for (std::size_t k = 0; k < table.ratio.size(); ++k) {
    const double x = std::isnan(before) ? 0 : (step.time - before) / table.time[k], gone = -std::expm1(-x);
    const double share = x == 0 ? 0 : 1 - gone / x;  // of what the step changes
    compliance += table.ratio[k] * share;
    for (std::size_t i = 0; i < n; ++i)
      now.gap[i] += table.ratio[k] * ((1 - gone) * left[(k + 1) * n + i] + (gone - share) * left[i]);
  }
  now.system.modulus /= compliance;
  Field depth(n);
  check(rc_contact_indentation(contact.handle(), RC_OUT(depth.data())) == RC_OK, rc_last_error());
  for (std::size_t i = 0; i < n; ++i) now.gap[i] += depth[i];
  return now;
}

// The memory itself is a property of scenes.
void a_step_is_that_of_a_softer_body(std::int32_t boundary, std::int32_t control, double hardness) {
  Problem problem = rough_problem(18, 14, boundary, 0.5, 0.75);
  if (boundary != RC_BOUNDARY_PERIODIC_X) {
    problem.mask.assign(problem.points(), 1);
    for (const std::size_t i : {0, 31, 200}) problem.mask[i] = 0;
  }
  if (control == RC_CONTROL_LOAD) problem = at_load(problem, solved(problem, automatic).result.load);
  if (hardness > 0) problem.system.hardness = hardness * largest(solved(problem, automatic).p);
  std::int64_t capped = 0;
  for (const Table& table : {one, two}) {
    const Problem asked = creeping(problem, table);
    const Contact contact(asked, {"polonsky-keer", "dense"}, {{RC_OPT_TOL, "1e-11"}, {RC_OPT_STIFFNESS, "1"}});
    for (const Step& step : path(problem.target)) {
      const Problem now = softer(problem, table, contact, step);
      const rc_result r = contact.solve(at(asked, step)).result,
                      elastic = solved(now, {"nnls", "dense"}, {{RC_OPT_STIFFNESS, "1"}}).result;
      const auto near = [](double value, double expected, const char* what) {
        check_near(value, expected, 1e-7 * std::abs(expected), what);
      };
      check_equal(r.status, RC_OK, rc_last_error());
      near(r.load, elastic.load, "load");
      near(r.approach, elastic.approach, "approach");
      near(r.mean_gap, elastic.mean_gap, "mean gap");
      near(r.stiffness, elastic.stiffness, "stiffness");
      check_near(r.plastic_volume, elastic.plastic_volume, 1e-7 * problem.cell_area(), "volume");
      check(r.homogeneous == 0, "a conductance does not follow");
      check(r.load_lower <= elastic.load * (1 + 1e-12) && elastic.load * (1 - 1e-12) <= r.load_upper,
            "the load is in its interval");
      capped += r.capped;
    }
  }
  check((capped > 10) == (hardness > 0), "some points yield");
}

// A ball of radius 8 on cells of width h, and the cube of the contact's radius for a modulus and load of 1.
Problem ball(std::int64_t n) {
  Problem problem;
  problem.system.nx = problem.system.ny = n;
  problem.system.hx = problem.system.hy = 4.0 / static_cast<double>(n);
  const double middle = 0.5 * static_cast<double>(n - 1);
  problem.gap = paraboloid(n, n, problem.system.hx, middle, middle, 8);
  problem.control = RC_CONTROL_LOAD;
  return problem;
}
constexpr double cube = 0.75 * 8, load = 0.02;

double radius(const Answer& answer) { return std::sqrt(answer.result.contact_area / pi); }

// Cells are counted: an elastic contact of the same radius has the grid's error, without that of time.
void check_radius(const Answer& answer, double expected, const std::string& what) {
  check_status(answer, RC_OK);
  Problem elastic = ball(96);
  elastic.target = std::pow(expected, 3) / cube;
  check_near(radius(answer) / radius(solved(elastic, automatic)), 1, 0.004, what);
  check_near(radius(answer) / expected, 1, 0.02, what);
}

void a_step_load_spreads_as_the_compliance() {
  for (const int steps : {3, 12}) {
    const Problem problem = creeping(ball(96), two);
    const Contact contact(problem, automatic, {{RC_OPT_TOL, "1e-8"}});
    for (int i = 0; i <= steps; ++i) {
      const double time = 6.0 * i / steps;
      const double a = std::cbrt(cube * load * two.compliance(time));
      const Answer answer = contact.solve(at(problem, {time, load}));
      check_radius(answer, a, "radius at " + text(time));
      check_near(answer.result.approach / (a * a / 8), 1, 0.01, "approach");
    }
  }
}

// Load c t: the cube of the radius is that of the integral of c J.
void a_ramp_spreads_as_the_integral() {
  const Problem problem = creeping(ball(96), one);
  const Contact contact(problem, automatic, {{RC_OPT_TOL, "1e-8"}});
  const double rate = 0.01;
  for (int i = 0; i <= 24; ++i) {
    const double t = i / 8.0;
    const Answer answer = contact.solve(at(problem, {t, rate * t}));
    check_status(answer, RC_OK);
    if (i % 8 != 0 || i == 0) continue;
    check_radius(answer, std::cbrt(cube * rate * (t + 3 * (t - 1 + std::exp(-t)))), "radius at " + text(t));
  }
}

// Relaxation of a body with this compliance: 1/(1+r) + r/(1+r) exp(-t (1+r)/tau), for r = 3, tau = 1.
double relaxed(double t) { return 0.25 + 0.75 * std::exp(-4 * t); }

// At a constant approach the contact stays and all pressures relax as the modulus does, on any surface.
double relaxation_error(int steps, std::int32_t boundary, const Table& table, const std::function<double(double)>& modulus) {
  const Problem problem = creeping(rough_problem(20, 16, boundary), table);
  const Contact contact(problem, {"nnls", "dense"});
  Field first;
  double worst = 0;
  for (int i = 0; i <= steps; ++i) {
    const double time = 1.0 * i / steps;
    const Answer answer = contact.solve(at(problem, {7 + time, problem.target}));
    check_status(answer, RC_OK);
    if (first.empty()) first = answer.p;
    worst = std::max(worst, std::abs(sum(answer.p) / sum(first) - modulus(time)));
    for (std::size_t k = 0; k < first.size(); ++k) check((first[k] > 0) == (answer.p[k] > 0), "the contact stays");
  }
  return worst;
}

void half_the_time_step_a_quarter_of_the_error() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    double before = relaxation_error(16, boundary, one, relaxed);
    for (const int steps : {32, 64, 128}) {
      const double error = relaxation_error(steps, boundary, one, relaxed);
      report(text(steps) + " steps: load off by " + text(error) + " of that at once");
      check(before / error > 3.6 && before / error < 4.6, "order 2: " + text(before) + " to " + text(error));
      before = error;
    }
    check(before < 1e-4, "128 steps");
  }
}

// The same bodies by their moduli: the load relaxes as they say.
void moduli_are_turned_into_compliances() {
  const auto of = [](const Table& table) {
    return [&table](double t) {
      double sum = 1;
      for (std::size_t k = 0; k < table.ratio.size(); ++k) sum -= table.ratio[k] * (1 - std::exp(-t / table.time[k]));
      return sum;
    };
  };
  const Table single{{0.75}, {0.25}, RC_CREEP_MODULI};
  const Table three{{0.2, 0.3, 0.25}, {2, 0.1, 0.7}, RC_CREEP_MODULI};
  const Table odd{{0.15, 0, 0.05, 0.3, 0.25}, {2, 0.4, 2, 0.1, 0.7}, RC_CREEP_MODULI};
  const Table nearly{{0.999}, {10}, RC_CREEP_MODULI};
  for (const Table* table : {&single, &three, &odd, &nearly}) {
    const double coarse = relaxation_error(64, RC_BOUNDARY_FREE, *table, of(*table));
    const double fine = relaxation_error(128, RC_BOUNDARY_FREE, *table, of(*table));
    check(fine < 1e-3 && fine < 0.3 * coarse, "moduli: off by " + text(fine) + ", with half the steps " + text(coarse));
  }
}

// Ting 1966: after the maximum the radius is that of an earlier time t1, at which the load that has relaxed since then is the
// load now. Here a load rests for a time T and then falls at once.
void unloading_is_tings() {
  const double rest = 0.8;
  const auto load_of = [&](double t1) {  // over the first load: relaxation times the growth of the cube of the radius
    const int parts = 2000;
    double sum = relaxed(rest);
    for (int i = 0; i < parts; ++i) {
      const double s = t1 * (i + 0.5) / parts;
      sum += relaxed(rest - s) * 3 * std::exp(-s) * t1 / parts;
    }
    return sum;
  };
  const Problem problem = creeping(ball(96), one);
  for (const double t1 : {-0.5, 0.1, 0.3, 0.6}) {
    const double share = t1 < 0 ? 0.5 * relaxed(rest) : load_of(t1);
    const double a = std::cbrt(cube * load * (t1 < 0 ? 0.5 : one.compliance(t1)));
    const Contact contact(problem, automatic, {{RC_OPT_TOL, "1e-8"}});
    for (int i = 0; i <= 24; ++i) check_status(contact.solve(at(problem, {rest * (i / 24.0), load})), RC_OK);
    check_radius(contact.solve(at(problem, {rest, share * load})), a, "radius of the earlier time " + text(t1));
  }
}

// A virgin history leaves what was before it; a step that is only certified too, and a failed one.
void what_leaves_nothing() {
  const Problem problem = creeping(rough_problem(18, 14), two);
  const std::size_t values = 3 * problem.points();
  const Contact contact(problem, automatic);
  double time = 0;
  check_same(creep_of(contact, values, &time), Field(values, 0.0), "before the first step");
  check(std::isnan(time), "no time before the first step");
  check_status(contact.solve(at(problem, {1, problem.target})), RC_OK);
  const Answer last = contact.solve(at(problem, {2, problem.target}));
  const Field left = creep_of(contact, values);
  const auto unchanged = [&](const char* after) {
    check_same(creep_of(contact, values, &time), left, after);
    check(time == 2, after);
  };

  const Field targets(3, problem.target), times{2, 3, 5};
  Field loads(3);
  rc_history history = RC_HISTORY_INIT;
  history.control = problem.control;
  history.n = 3;
  history.targets = RC_IN(targets.data());
  history.times = RC_IN(times.data());
  history.undeformed_gap = RC_IN(problem.gap.data());
  history.columns.load = RC_OUT(loads.data());
  history.virgin = 1;
  check(rc_contact_solve_history(contact.handle(), &history) == RC_OK, rc_last_error());
  unchanged("after a virgin history");
  check(loads[2] < 0.9 * loads[0], "it relaxes");
  check_status(contact.certify(at(problem, {2, problem.target}), last.p), RC_OK, "pressures at the same time");
  unchanged("after certifying");
  check_status(contact.certify(at(problem, {3, problem.target}), last.p), RC_UNCERTIFIED, "pressures later");
  check_status(contact.solve(at(problem, {1.9, problem.target})), RC_ERR_ARGUMENT);
  check_status(contact.solve(at(problem, {nan, problem.target})), RC_ERR_ARGUMENT);
  check_status(contact.solve(at(problem, {3, nan})), RC_ERR_ARGUMENT);
  unchanged("after refused steps");
  check(rc_contact_reset(contact.handle()) == RC_OK, rc_last_error());
  check_same(creep_of(contact, values, &time), Field(values, 0.0), "after a reset");
  check_same(contact.solve(at(problem, {0, problem.target})).p, solve(problem, automatic).p, "at once, after a reset");
}

// Solutions on coarser grids have the step's lengths.
void levels_have_the_approach_of_the_step() {
  Problem problem = rough_problem(64, 64, RC_BOUNDARY_FREE);
  const Problem asked = creeping(problem, two);
  const Contact contact(asked, {"cmr", "auto"}, {{RC_OPT_TOL, "1e-6"}, {"cmr.levels", "3"}});
  for (const double time : {0.0, 1.0}) {
    const Answer answer = contact.solve(at(asked, {time, problem.target}));
    check_status(answer, RC_OK);
    check(answer.result.levels > 0, "coarse solutions");
    rc_level level = RC_LEVEL_INIT;
    check(rc_contact_level(contact.handle(), 0, &level) == RC_OK, rc_last_error());
    check_near(level.approach, problem.target, 1e-12 * problem.target, "approach of a coarse solution");
  }
}

std::vector<Test> tests() {
  std::vector<Test> all =
      RC_TESTS(a_step_load_spreads_as_the_compliance, a_ramp_spreads_as_the_integral, half_the_time_step_a_quarter_of_the_error,
               moduli_are_turned_into_compliances, unloading_is_tings, what_leaves_nothing, levels_have_the_approach_of_the_step);
  for (const auto& [boundary, edges] : std::vector<std::pair<std::int32_t, std::string>>{
           {RC_BOUNDARY_FREE, "free"}, {RC_BOUNDARY_PERIODIC, "periodic"}, {RC_BOUNDARY_PERIODIC_X, "periodic-x"}})
    for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD})
      for (const double hardness : {0.0, 0.5})
        all.push_back({"a_step_is_that_of_a_softer_body:" + edges + (control == RC_CONTROL_LOAD ? ":load" : ":approach") +
                           (hardness > 0 ? ":hardness" : ""),
                       [=, at = boundary] { a_step_is_that_of_a_softer_body(at, control, hardness); }});
  return all;
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) { return pairs::run_group("creep", pairs::tests(), argc, argv); }
