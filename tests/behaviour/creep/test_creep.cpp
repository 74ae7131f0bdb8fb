// Bodies that creep. Each step is certified by matrices and a recursion of this test's own.
#include <functional>
#include <string>
#include <utility>

#include "creep.h"

namespace pairs {

namespace {

void steps_are_certified(std::int32_t boundary, std::int32_t control, const Pair& pair, bool masked) {
  Problem problem = rough_problem(18, 14, boundary, 0.5, 0.75);
  if (masked) {
    problem.mask.assign(problem.points(), 1);
    for (const std::size_t i : {0, 31, 200}) {
      problem.mask[i] = 0;
      problem.gap[i] = 3;  // the recursion reads it
    }
  }
  if (control == RC_CONTROL_LOAD) problem = at_load(problem, solved(problem, automatic).result.load);
  for (const Table& table : {one, two}) {
    Recursion own(problem, table);
    const Problem asked = creeping(problem, table);
    Settings settings = sharp;
    settings.emplace_back(RC_OPT_STIFFNESS, "1");
    const Contact contact(asked, pair, settings);
    for (const Step& step : path(problem.target)) {
      const Answer answer = contact.solve(at(asked, step));
      check_status(answer, RC_OK);
      check_against_naive(own.problem(step), answer);
      const Answer elastic = solve(own.problem(step), {"nnls", "dense"}, {{RC_OPT_STIFFNESS, "1"}});
      check_near(answer.p, elastic.p, 1e-8, "p");
      check_near(answer.result.approach, elastic.result.approach, 1e-8 * std::abs(elastic.result.approach), "approach");
      check_near(answer.result.mean_gap, elastic.result.mean_gap, 1e-8 * std::abs(elastic.result.mean_gap), "mean gap");
      check_near(answer.result.stiffness, elastic.result.stiffness, 1e-6 * elastic.result.stiffness, "stiffness");
      check(answer.result.homogeneous == 0, "a conductance does not follow");
      check(answer.result.load_lower <= elastic.result.load * (1 + 1e-12) &&
                elastic.result.load * (1 - 1e-12) <= answer.result.load_upper,
            "the load is in its interval");
      own.end(step, answer.p);
      double time = 0;
      const Field said = creep_of(contact, 3 * problem.points(), &time);
      check(time == step.time, "the time of the memory");
      const auto n = static_cast<std::ptrdiff_t>(problem.points());
      check_near(Field(said.begin(), said.begin() + n), own.elastic_deflection(), 1e-10, "H p");
      for (std::size_t k = 0; k < table.ratio.size(); ++k) {
        const auto first = said.begin() + static_cast<std::ptrdiff_t>(k + 1) * n;
        check_near(Field(first, first + n), own.delayed()[k], 1e-10, "a delayed deflection");
      }
    }
  }
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

void a_restart_gives_the_same_bits(std::int32_t control, double hardness) {
  Problem problem = rough_problem(40, 36, RC_BOUNDARY_FREE);
  if (control == RC_CONTROL_LOAD) problem = at_load(problem, solved(problem, automatic).result.load);
  if (hardness > 0) problem.system.hardness = hardness * largest(solved(problem, automatic).p);
  const Settings resumable = {{RC_OPT_TOL, "1e-9"}, {RC_OPT_RESUMABLE, "1"}};
  const Problem asked = creeping(problem, two);
  for (const Pair& pair : {automatic, Pair{"haar-cg", "fft"}}) {
    const Contact whole(asked, pair, resumable), again(asked, pair, resumable);
    const std::vector<Step> steps = path(problem.target);
    Answer last;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      rc_step step = at(asked, steps[i]);
      if (i > 0) step.undeformed_gap = {};
      const Answer answer = whole.solve(step);
      check_status(answer, RC_OK);
      if (i >= 4) {
        const Answer second = again.solve(step);
        check_status(second, RC_OK);
        check_same(second.p, answer.p, "p");
        check_same(second.gap, answer.gap, "gap");
        check(second.result.approach == answer.result.approach && second.result.energy == answer.result.energy, "numbers");
      }
      if (i == 3) {
        double time = 0;
        const Field creep = creep_of(whole, 3 * problem.points(), &time);
        Field indentation(problem.points());
        check(rc_contact_indentation(whole.handle(), RC_OUT(indentation.data())) == RC_OK, rc_last_error());
        check((largest(indentation) > 0) == (hardness > 0), "a hardness leaves an indentation");
        rc_state state = state_of(problem, answer, creep, time);
        if (hardness > 0) state.indentation = RC_IN(indentation.data());
        state.p_before = RC_IN(last.p.data());
        state.approach_before = last.result.approach;
        state.load_before = last.result.load;
        check(rc_contact_restore(again.handle(), &state) == RC_OK, rc_last_error());
        check_same(creep_of(again, 3 * problem.points()), creep, "the memory");
      }
      last = answer;
    }
  }
}

// The overlap at the hardness is plastic, in lengths of the step, and the step after it sees it beside the creep.
void hardness_and_creep_add_up() {
  Problem problem = rough_problem(18, 14, RC_BOUNDARY_FREE, 0.5, 0.75);
  problem.target *= 1.4;
  problem.system.hardness = 0.3 * largest(solved(problem, automatic).p);
  Recursion own(problem, two);
  const Problem asked = creeping(problem, two);
  const Contact contact(asked, {"polonsky-keer", "dense"}, sharp);
  Field indentation(problem.points(), 0.0);
  std::int64_t capped = 0;
  for (const Step& step : path(problem.target)) {
    const Answer answer = contact.solve(at(asked, step));
    check_status(answer, RC_OK);
    Problem elastic = own.problem(step);
    for (std::size_t i = 0; i < indentation.size(); ++i) elastic.gap[i] += indentation[i];
    const Answer expected = solve(elastic, {"polonsky-keer", "dense"}, sharp);
    check_near(answer.p, expected.p, 1e-7, "p");
    check_near(answer.gap, expected.gap, 1e-7, "gap");
    check_near(answer.result.plastic_volume, expected.result.plastic_volume, 1e-7 * problem.cell_area(), "volume");
    for (std::size_t i = 0; i < indentation.size(); ++i)
      if (answer.p[i] == problem.system.hardness) indentation[i] += std::max(0.0, -answer.gap[i]);
    Field said(problem.points());
    check(rc_contact_indentation(contact.handle(), RC_OUT(said.data())) == RC_OK, rc_last_error());
    check_near(said, indentation, 1e-13, "indentation");
    capped += answer.result.capped;
    own.end(step, answer.p);
  }
  check(capped > 10, "some points yield");
}

// Histories and batches are the same steps, whatever the control.
void histories_and_batches_are_the_same_steps(std::int32_t control) {
  const Problem elastic = rough_problem(24, 20, RC_BOUNDARY_PERIODIC);
  Problem problem = creeping(elastic, two);
  const Answer first = solved(elastic, automatic);
  problem.control = control;
  problem.target = control == RC_CONTROL_APPROACH ? elastic.target
                   : control == RC_CONTROL_LOAD   ? first.result.load
                   : control == RC_CONTROL_AREA   ? 0.5 * first.result.contact_area
                                                  : first.result.mean_pressure;
  Field targets, times;
  for (const Step& step : path(problem.target)) {
    targets.push_back(step.target);
    times.push_back(step.time);
  }
  const Contact alone(problem, automatic), together(problem, automatic);
  Field loads(targets.size()), expected;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Answer answer = alone.solve(at(problem, {times[i], targets[i]}));
    check_status(answer, RC_OK);
    expected.push_back(answer.result.load);
    if (control == RC_CONTROL_AREA)
      check_near(answer.result.contact_area, targets[i], 2e-3 * targets[i] + problem.cell_area(), "area");
  }
  rc_history history = history_of(problem, targets, times, loads);
  check(rc_contact_solve_history(together.handle(), &history) == RC_OK, rc_last_error());
  check_same(loads, expected, "loads of the history");
  const std::size_t values = 3 * problem.points();
  check_same(creep_of(together, values), creep_of(alone, values), "memory of the history");

  const std::size_t contacts = 3;
  Field gaps, batched(contacts * targets.size());
  for (std::size_t i = 0; i < contacts; ++i) gaps.insert(gaps.end(), problem.gap.begin(), problem.gap.end());
  rc_batch batch = RC_BATCH_INIT;
  batch.control = control;
  batch.n = contacts;
  batch.steps = history.n;
  batch.targets = RC_IN(targets.data());
  batch.times = RC_IN(times.data());
  batch.target_stride = RC_BATCH_SHARED;
  batch.undeformed_gap = RC_IN(gaps.data());
  batch.columns.load = RC_OUT(batched.data());
  const Options options = make_options(automatic, "auto");
  check(rc_batch_solve(&problem.system, options.get(), &batch) == RC_OK, rc_last_error());
  for (std::size_t i = 0; i < contacts; ++i)
    check_same(Field(batched.begin() + static_cast<std::ptrdiff_t>(i * targets.size()),
                     batched.begin() + static_cast<std::ptrdiff_t>((i + 1) * targets.size())),
               loads, "loads of a batch");
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
  rc_history history = history_of(problem, targets, times, loads);
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

// Ratios of 0, and steps at one time, are the elastic contact bit by bit; gaps of floats and masked points are taken.
void no_creep_changes_nothing() {
  Problem problem = rough_problem(40, 30, RC_BOUNDARY_PERIODIC);
  problem.mask.assign(problem.points(), 1);
  problem.mask[5] = 0;
  problem.gap[5] = nan;
  std::vector<float> floats(problem.gap.begin(), problem.gap.end());
  const Table idle{{0, 0}, {1, 2}};
  for (const bool zeros : {false, true})
    for (const bool single : {false, true}) {
      const Problem asked = creeping(problem, zeros ? idle : two);
      const Contact creeps(asked, automatic), elastic(problem, automatic);
      for (const double share : {0.7, 1.0, 0.4}) {
        rc_step step = at(asked, {zeros ? 5 * share : 3, share * problem.target});
        if (zeros && share == 0.4) step.time = 6;
        if (single) step.undeformed_gap = {floats.data(), RC_SINGLE, 0, nullptr};
        step.warm_start = 0;
        const Answer a = creeps.solve(step), b = elastic.solve(step);
        check_status(a, RC_OK);
        check_same(a.p, b.p, "p");
        check(a.result.load == b.result.load && a.result.approach == b.result.approach && a.result.energy == b.result.energy,
              "numbers");
      }
    }
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
  std::vector<Test> all{{"a_step_load_spreads_as_the_compliance", a_step_load_spreads_as_the_compliance},
                        {"a_ramp_spreads_as_the_integral", a_ramp_spreads_as_the_integral},
                        {"half_the_time_step_a_quarter_of_the_error", half_the_time_step_a_quarter_of_the_error},
                        {"moduli_are_turned_into_compliances", moduli_are_turned_into_compliances},
                        {"unloading_is_tings", unloading_is_tings},
                        {"hardness_and_creep_add_up", hardness_and_creep_add_up},
                        {"what_leaves_nothing", what_leaves_nothing},
                        {"no_creep_changes_nothing", no_creep_changes_nothing},
                        {"levels_have_the_approach_of_the_step", levels_have_the_approach_of_the_step},
                        {"bad_tables_are_refused", bad_tables_are_refused},
                        {"bad_calls_are_refused", bad_calls_are_refused}};
  const std::vector<std::pair<std::int32_t, std::string>> controls = {
      {RC_CONTROL_APPROACH, "approach"}, {RC_CONTROL_LOAD, "load"}, {RC_CONTROL_AREA, "area"}, {RC_CONTROL_PRESSURE, "pressure"}};
  for (const auto& [control, name] : controls) {
    const std::int32_t asked = control;
    all.push_back({"histories_and_batches_are_the_same_steps:" + name, [=] { histories_and_batches_are_the_same_steps(asked); }});
    if (asked == RC_CONTROL_AREA || asked == RC_CONTROL_PRESSURE) continue;
    for (const double hardness : {0.0, 0.5})
      all.push_back({"a_restart_gives_the_same_bits:" + name + (hardness > 0 ? ":hardness" : ""),
                     [=] { a_restart_gives_the_same_bits(asked, hardness); }});
    for (const auto& [boundary, edges] : std::vector<std::pair<std::int32_t, std::string>>{
             {RC_BOUNDARY_FREE, "free"}, {RC_BOUNDARY_PERIODIC, "periodic"}, {RC_BOUNDARY_PERIODIC_X, "periodic-x"}})
      for (const Pair& pair : {Pair{"nnls", "dense"}, Pair{"haar-cg", "fft"}, Pair{"polonsky-keer", "fft"}, automatic})
        all.push_back({"steps_are_certified:" + edges + ":" + name + ":" + pair.name(),
                       [=, at = boundary] { steps_are_certified(at, asked, pair, at != RC_BOUNDARY_PERIODIC_X); }});
  }
  return all;
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) { return pairs::run_group("creep", pairs::tests(), argc, argv); }
