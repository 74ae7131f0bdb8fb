// Solvers that answer for many contacts at once, and lie: no lie is taken, and the log has the reason.
#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <random>

#include "scratch.h"

namespace plugins {

namespace {

constexpr std::int64_t nx = 6, ny = 4, points = nx * ny;
constexpr double tol = 1e-6;

using Lie = std::function<void(rc_many&)>;

// Rough contacts, and their true answers.
struct Scene {
  pairs::Problem problem;  // of each, but for gap and target
  std::int64_t n, steps;
  pairs::Field gaps, targets, p;
  std::vector<rc_many_answer> answers;

  Scene(std::int32_t control, std::int64_t contacts = 5, std::int64_t of_each = 2, double hardness = 0)
      : n(contacts), steps(of_each) {
    problem.system.nx = nx;
    problem.system.ny = ny;
    problem.system.hardness = hardness;
    problem.control = control;
    problem.mask.assign(points, 1);
    problem.mask[7] = 0;
    std::mt19937 random(3);
    for (std::int64_t i = 0; i < n; ++i) {
      problem.gap.clear();
      for (std::int64_t m = 0; m < points; ++m) problem.gap.push_back(static_cast<double>(random() % 1000) * 1e-3);
      gaps.insert(gaps.end(), problem.gap.begin(), problem.gap.end());
      const pairs::Contact contact(problem, pairs::automatic, {{RC_OPT_TOL, "1e-10"}});
      for (std::int64_t k = 0; k < steps; ++k) {
        problem.target = control == RC_CONTROL_LOAD ? 1 + 0.5 * static_cast<double>(k) : 0.6 + 0.1 * static_cast<double>(k);
        targets.push_back(problem.target);
        const pairs::Answer solved = contact.solve(problem);
        pairs::check_status(solved, RC_OK);
        rc_many_answer answer{};
        answer.solved = 1;
        answer.contacts = solved.result.contacts;
        answer.iterations = 4242;
        answer.lowest = problem.lowest_gap();
        answer.compression = solved.result.approach - answer.lowest;
        for (const double each : solved.p) answer.sum += each;
        answer.primal = solved.result.kkt_primal;
        answer.dual = solved.result.kkt_dual;
        answer.complementarity = solved.result.kkt_complementarity;
        answers.push_back(answer);
        p.insert(p.end(), solved.p.begin(), solved.p.end());
      }
    }
  }
};

const Scene* scene = nullptr;
Lie lie;

rc_status solve_many(const rc_host*, rc_many* many, const rc_options*) {
  if (many->n == 0) return RC_OK;
  const std::int64_t first = (many->undeformed_gap - scene->gaps.data()) / points * many->steps, count = many->n * many->steps;
  std::copy_n(scene->answers.begin() + first, count, many->answers);
  std::copy_n(scene->p.begin() + first * points, count * points, many->p);
  many->done = many->n;
  if (lie) lie(*many);
  return RC_OK;
}

rc_status one_at_a_time(const rc_host*, const rc_problem* problem, const rc_options*, double* p, double*) {
  return support::inner_solve(problem, "polonsky-keer", p);
}

rc_status cheapest(const rc_facts*, rc_estimate* estimate) {
  estimate->seconds = 1e-15;
  return RC_OK;
}

const rc_solver liar = [] {
  rc_solver each = support::solver("liar", one_at_a_time);
  each.needs = RC_TAKES_CAP;
  each.score = cheapest;
  each.solve_many = solve_many;
  return each;
}();

struct Found {
  rc_status status = RC_OK;
  std::string log;
  std::vector<double> load, approach, area, certificate, p;
  std::vector<std::int64_t> iterations;

  bool refused() const { return log.find("are solved one at a time: ") != std::string::npos; }
  bool taken() const {
    return std::all_of(iterations.begin(), iterations.end(), [](std::int64_t each) { return each == 4242; });
  }
};

Found solved(
    const Scene& of, const Lie& how, const char* solver = "liar",
    const std::function<void(rc_batch&)>& change = [](rc_batch&) {}) {
  scene = &of;
  lie = how;
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(registry.add(liar), RC_OK);
  const pairs::Options options = pairs::make_options({solver, "auto"}, "auto", {{RC_OPT_TOL, "1e-6"}}, registry.get());
  Found f;
  const auto slots = static_cast<std::size_t>(of.n * of.steps);
  for (std::vector<double>* const each : {&f.load, &f.approach, &f.area, &f.certificate}) each->assign(slots, -7);
  f.iterations.assign(slots, -7);
  f.p.assign(static_cast<std::size_t>(of.n * points), -7);
  rc_batch b = RC_BATCH_INIT;
  b.control = of.problem.control;
  b.n = of.n;
  b.steps = of.steps;
  b.targets = RC_IN(of.targets.data());
  b.undeformed_gap = RC_IN(of.gaps.data());
  b.mask = RC_IN(of.problem.mask.data());
  b.mask_stride = RC_BATCH_SHARED;
  b.p = RC_OUT(f.p.data());
  b.columns.load = RC_OUT(f.load.data());
  b.columns.approach = RC_OUT(f.approach.data());
  b.columns.contact_area = RC_OUT(f.area.data());
  b.columns.certificate = RC_OUT(f.certificate.data());
  b.columns.iterations = RC_OUT(f.iterations.data());
  change(b);
  f.status = rc_batch_solve(&of.problem.system, options.get(), &b);
  f.log = registry.log();
  lie = nullptr;
  return f;
}

void expect_true(const Scene& of, const Found& found, const char* name) {
  if (found.status != RC_OK) fail_msg("%s: %d, %s", name, static_cast<int>(found.status), rc_last_error());
  for (std::size_t at = 0; at < found.load.size(); ++at) {
    const rc_many_answer& wanted = of.answers[at];
    if (!(std::abs(found.load[at] - wanted.sum) <= 1e-4 * wanted.sum) ||
        !(std::abs(found.approach[at] - wanted.lowest - wanted.compression) <= 1e-4 * wanted.compression) ||
        !(found.certificate[at] <= tol))
      fail_msg("%s: load %g for %g, approach %g for %g, certificate %g", name, found.load[at], wanted.sum, found.approach[at],
               wanted.lowest + wanted.compression, found.certificate[at]);
  }
  for (const double each : found.p) assert_true(each >= 0);
}

// A point of contact i at step k that carries pressure.
double& pressed(rc_many& many, std::int64_t i, std::int64_t k) {
  double* const p = many.p + (i * many.steps + k) * points;
  return *std::max_element(p, p + points);
}

double& first_pressed(double* p) {
  return *std::find_if(p, p + points, [](double each) { return each > 0; });
}
double& last_pressed(double* p) {
  return *std::find_if(std::make_reverse_iterator(p + points), std::make_reverse_iterator(p),
                       [](double each) { return each > 0; });
}

struct Case {
  const char* name;
  const char* reason;
  Lie lie;
};

void for_each_answer(rc_many& many, const std::function<void(rc_many_answer&, double*)>& change) {
  for (std::int64_t at = 0; at < many.n * many.steps; ++at) change(many.answers[at], many.p + at * points);
}

// Lies that any answer of the call shows, and those about all answers.
const Case lies[] = {
    {"an invented answer", "kkt_primal is 1",
     [](rc_many& m) {
       for_each_answer(m, [](rc_many_answer& answer, double* p) {
         for (std::int64_t k = 0; k < points; ++k) p[k] = scene->problem.mask[static_cast<std::size_t>(k)] ? -7 : 0;
         answer.sum = 123;
         answer.primal = answer.dual = answer.complementarity = 0;
       });
     }},
    {"one pressure is negative", "contact 3, step 0: kkt_primal is ", [](rc_many& m) { pressed(m, 3, 0) *= -1; }},
    {"one pressure is not finite", "contact 1, step 1: pressures or target are not finite",
     [](rc_many& m) { pressed(m, 1, 1) = std::nan(""); }},
    {"one masked point carries pressure", "contact 4, step 1: a masked point carries pressure",
     [](rc_many& m) { m.p[9 * points + 7] = 1e-9; }},
    {"one sum is wrong in its last digits", "contact 2, step 1: the sum of the pressures is ",
     [](rc_many& m) { m.answers[5].sum *= 1 + 1e-13; }},
    {"one count is wrong", " points carry pressure, reported as ", [](rc_many& m) { ++m.answers[0].contacts; }},
    {"one lowest gap is wrong", "contact 2, step 0: the lowest gap is ", [](rc_many& m) { m.answers[4].lowest += 1e-9; }},
    {"one approach is not finite", "contact 2, step 0: the approach is not finite",
     [](rc_many& m) { m.answers[4].compression = std::nan(""); }},
    {"pressures were not written", "points carry pressure, reported as ",
     [](rc_many& m) { std::fill_n(m.p, m.n * m.steps * points, 0.0); }},
    {"pressures change places", ", reported as ",
     [](rc_many& m) { for_each_answer(m, [](rc_many_answer&, double* p) { std::swap(first_pressed(p), last_pressed(p)); }); }},
    {"first steps are those of other contacts", "step 0: ",
     [](rc_many& m) {
       const std::vector<double> p(m.p, m.p + m.n * m.steps * points);
       const std::vector<rc_many_answer> answers(m.answers, m.answers + m.n * m.steps);
       for (std::int64_t i = 0; i < m.n; ++i) {
         const std::int64_t other = (i + 1) % m.n * m.steps, own = i * m.steps;
         std::copy_n(p.begin() + other * points, points, m.p + own * points);
         m.answers[own] = answers[static_cast<std::size_t>(other)];
         m.answers[own].lowest = answers[static_cast<std::size_t>(own)].lowest;
       }
     }},
    {"residuals are too good", "reported as ",
     [](rc_many& m) {
       for_each_answer(m, [](rc_many_answer& answer, double* p) {
         const double change = 1e-5 * last_pressed(p);
         last_pressed(p) -= change;
         first_pressed(p) += change;
         answer.sum = 0;
         for (std::int64_t k = 0; k < points; ++k) answer.sum += p[k];
       });
     }},
    {"one residual is above tol", "contact 1, step 0: a residual is reported as 2e-06, above tol = 1e-06",
     [](rc_many& m) { m.answers[2].dual = 2e-6; }},
    {"residuals are too bad", ", reported as 4e-07",
     [](rc_many& m) { for_each_answer(m, [](rc_many_answer& answer, double*) { answer.complementarity = 4e-7; }); }},
    {"approaches are off", "",
     [](rc_many& m) { for_each_answer(m, [](rc_many_answer& answer, double*) { answer.compression *= 1.01; }); }},
};

void no_lie_is_taken() {
  for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD}) {
    const Scene of(control);
    for (const char* solver : {"liar", "auto"}) {
      const Found honest = solved(of, {}, solver);
      expect_true(of, honest, "honest");
      assert_true(honest.taken() && !honest.refused());
      for (const Case& each : lies) {
        if (control == RC_CONTROL_APPROACH && each.name == std::string("approaches are off")) continue;  // it is given
        const Found found = solved(of, each.lie, solver);
        expect_true(of, found, each.name);
        const bool right = found.refused() && found.log.find("warning: solver \"liar\": contacts 0 .. 4 ") != std::string::npos;
        if (!right || (control == RC_CONTROL_LOAD && found.log.find(each.reason) == std::string::npos))
          fail_msg("%s: the log has \"%s\"", each.name, found.log.c_str());
        for (const std::int64_t iterations : found.iterations) assert_true(iterations != 4242);
      }
    }
  }
}

void no_pressure_above_the_hardness_is_taken() {
  const Scene of(RC_CONTROL_LOAD, 3, 1, 0.2);
  const Found honest = solved(of, {});
  assert_true(honest.taken());
  const Found found = solved(of, [](rc_many& m) { pressed(m, 1, 0) = 0.3; });
  expect_true(of, found, "hardness");
  assert_has(found.log, "contact 1, step 0: kkt_primal is 0.5");
}

// The rest of a call is solved alone as well if a contact that is said to be solved is not.
void what_is_not_solved_hides_no_lie() {
  const Scene of(RC_CONTROL_LOAD);
  const Found some = solved(of, [](rc_many& m) { m.answers[2].solved = 0; });
  expect_true(of, some, "one is not solved");
  assert_true(!some.refused() && some.iterations[0] == 4242 && some.iterations[2] != 4242 && some.iterations[3] != 4242);
  const Found found = solved(of, [](rc_many& m) {
    m.answers[2].solved = 0;
    pressed(m, 4, 1) *= -1;
  });
  expect_true(of, found, "one is not solved, one is false");
  assert_true(found.refused());
  const Found parts = solved(of, [](rc_many& m) {
    m.done = 1;
    pressed(m, 0, 0) *= -1;
  });
  expect_true(of, parts, "one contact at a time");
  assert_has(parts.log, "contacts 0 .. 0 are solved one at a time");
  assert_has(parts.log, "contacts 4 .. 4 are solved one at a time");
}

// A pressure is a little too large, and the sum reported with it.
void falsify(rc_many& many, std::int64_t i) {
  double* const p = many.p + i * points;
  *std::max_element(p, p + points) *= 1 + 1e-4;
  many.answers[i].sum = 0;
  for (std::int64_t k = 0; k < points; ++k) many.answers[i].sum += p[k];
}

// The library recomputes 8 of 64 contacts, chosen at random: it finds a single false answer in one call of 8, wherever it is. A
// solver cannot know which: also a lie that stays at one place is found in one call of 8, not in all or none.
void one_lie_among_many_is_found_by_chance() {
  constexpr std::int64_t n = 64, calls = 500;
  const Scene of(RC_CONTROL_APPROACH, n, 1);
  const auto check_found = [&](const char* where, const std::function<std::int64_t(std::int64_t)>& place) {
    std::int64_t found = 0;
    for (std::int64_t call = 0; call < calls; ++call) {
      const Found each = solved(of, [&](rc_many& m) { falsify(m, place(call)); });
      assert_int_equal(each.status, RC_OK);
      found += each.refused();
    }
    print_message("1 false answer among %d, %s: found in %d of %d calls\n", static_cast<int>(n), where, static_cast<int>(found),
                  static_cast<int>(calls));
    assert_true(found >= 20 && found <= 110);  // 62 are expected, give or take 7
  };
  check_found("at each place in turn", [](std::int64_t call) { return call % n; });
  check_found("at the first place of a part", [](std::int64_t) { return 8; });
  check_found("at the last place", [](std::int64_t) { return n - 1; });
  check_found("inside a part", [](std::int64_t) { return 29; });
}

// Residuals that are reported as more than half of tol are computed anew, of whichever contact: a false one is found in each
// call.
void residuals_near_tol_are_always_computed_anew() {
  constexpr std::int64_t n = 64;
  const Scene of(RC_CONTROL_APPROACH, n, 1);
  for (double rc_many_answer::*const residual : {&rc_many_answer::dual, &rc_many_answer::complementarity})
    for (std::int64_t call = 0; call < 16; ++call)
      assert_true(solved(of, [&](rc_many& m) { m.answers[(5 + 7 * call) % n].*residual = 0.9 * tol; }).refused());
}

// A solver whose answers are often wrong is found in its first call. Of up to 8 contacts all are checked; one is false here. Of
// more every second one is false: a call passes with a probability of 1/256, more than 8 of 100 calls with one below 1e-8.
void many_lies_among_few_are_found_at_once() {
  constexpr std::int64_t calls = 100;
  for (const std::int64_t n : {2, 5, 8, 9, 24, 64}) {
    const Scene of(RC_CONTROL_APPROACH, n, 1);
    std::int64_t found = 0;
    for (std::int64_t call = 0; call < calls; ++call) {
      const Lie often = [&](rc_many& m) {
        for (std::int64_t i = call % 2; i < n; i += 2) falsify(m, i);
      };
      const Lie once = [&](rc_many& m) { falsify(m, call % n); };
      found += solved(of, n <= 8 ? once : often).refused();
    }
    assert_true(found >= (n <= 8 ? calls : calls - 8));
  }
}

void an_honest_call_of_many_is_taken() {
  const Scene of(RC_CONTROL_LOAD, 200, 3);
  const Found found = solved(of, {});
  expect_true(of, found, "honest");
  assert_true(found.taken() && !found.refused());
}

// Answers of many have no place for these numbers, so that each contact computes its own.
void outputs_that_no_solver_of_many_gives_are_computed() {
  const Scene of(RC_CONTROL_LOAD);
  for (rc_array rc_columns::*const output :
       {&rc_columns::mean_gap, &rc_columns::energy, &rc_columns::stiffness, &rc_columns::load_lower, &rc_columns::load_upper,
        &rc_columns::area_lower, &rc_columns::area_upper, &rc_columns::stiffness_lower, &rc_columns::stiffness_upper}) {
    std::vector<double> values(of.targets.size(), HUGE_VAL);
    const Found found = solved(of, {}, "liar", [&](rc_batch& b) { b.columns.*output = RC_OUT(values.data()); });
    expect_true(of, found, "more outputs");
    assert_true(!found.refused() && std::find(found.iterations.begin(), found.iterations.end(), 4242) == found.iterations.end());
    for (const double each : values) assert_true(std::isfinite(each));
  }
}

}  // namespace

std::vector<pairs::Test> many_liar_tests() {
  return {
      TEST(no_lie_is_taken),
      TEST(no_pressure_above_the_hardness_is_taken),
      TEST(what_is_not_solved_hides_no_lie),
      TEST(one_lie_among_many_is_found_by_chance),
      TEST(residuals_near_tol_are_always_computed_anew),
      TEST(many_lies_among_few_are_found_at_once),
      TEST(an_honest_call_of_many_is_taken),
      TEST(outputs_that_no_solver_of_many_gives_are_computed),
  };
}

}  // namespace plugins
