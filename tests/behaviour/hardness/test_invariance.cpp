// With a hardness: units, symmetries and translations change nothing else; a hardness that is never reached changes nothing at
// all.
#include <algorithm>
#include <array>
#include <cmath>

#include "capped_cases.h"
#include "support/naive.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

Problem yielding(std::int32_t boundary) {
  Problem problem = rough_problem(18, 14, boundary, 0.5, 0.75);
  problem.target *= 1.4;
  problem.system.hardness = 0.3 * largest(solved(problem, {"nnls", "dense"}).p);
  return problem;
}

// In both controls.
template <class Check> void in_both_controls(std::int32_t boundary, const Pair& pair, const Check& compare) {
  const Problem problem = yielding(boundary);
  const Answer answer = solved(problem, pair);
  check(answer.result.capped > 10, "the surface should yield");
  compare(problem, answer);
  const Problem loaded = at_load(problem, answer.result.load);
  compare(loaded, solved(loaded, pair));
}

void units_scale_the_answer(std::int32_t boundary, const Pair& pair) {
  in_both_controls(boundary, pair, [&](const Problem& problem, const Answer& answer) {
    for (const auto& [cell, height, modulus] :
         {std::array{1e-9, 1e-9, 1.0}, {1.0, 1e-9, 1.0}, {1.0, 1.0, 1e11}, {1.0, 1.0, 1e-11}, {1e-6, 1e-9, 1e11}}) {
      Problem other = problem;
      const double pressure = modulus * height / cell, force = pressure * cell * cell;
      other.system.hx *= cell;
      other.system.hy *= cell;
      other.system.modulus *= modulus;
      other.system.hardness *= pressure;
      for (double& value : other.gap) value *= height;
      other.target *= problem.control == RC_CONTROL_LOAD ? force : height;
      const Answer scaled = solved(other, pair);
      Field expected = answer.p;
      for (double& value : expected) value *= pressure;
      check_near(scaled.p, expected, 1e-10, "p");
      check_near(scaled.result.load, answer.result.load * force, 1e-11 * answer.result.load * force, "load");
      check_near(scaled.result.plastic_volume, answer.result.plastic_volume * height * cell * cell,
                 1e-9 * answer.result.plastic_volume * height * cell * cell, "plastic volume");
      check_equal(scaled.result.capped, answer.result.capped, "points at the hardness");
    }
  });
}

void datum_does_not_matter(std::int32_t boundary, const Pair& pair) {
  in_both_controls(boundary, pair, [&](const Problem& problem, const Answer& answer) {
    for (const double datum : {8.0, -8.0, 1000.0}) {
      Problem shifted = problem;
      for (double& value : shifted.gap) value += datum;
      if (problem.control == RC_CONTROL_APPROACH) shifted.target += datum;
      check_near(solved(shifted, pair, {{RC_OPT_TOL, "1e-11"}}).p, answer.p, 1e-9, "p");
    }
  });
}

void transposition_transposes(std::int32_t boundary, const Pair& pair) {
  in_both_controls(boundary, pair, [&](const Problem& problem, const Answer& answer) {
    const auto transposed = [&](const Field& field) {
      Field result;
      for (std::int64_t x = 0; x < problem.system.nx; ++x)
        for (std::int64_t y = 0; y < problem.system.ny; ++y)
          result.push_back(field[static_cast<std::size_t>(y * problem.system.nx + x)]);
      return result;
    };
    Problem other = problem;
    std::swap(other.system.nx, other.system.ny);
    std::swap(other.system.hx, other.system.hy);
    other.gap = transposed(problem.gap);
    check_near(solved(other, pair).p, transposed(answer.p), 1e-9, "p");
  });
}

void translation_translates(const Pair& pair) {
  in_both_controls(RC_BOUNDARY_PERIODIC, pair, [&](const Problem& problem, const Answer& answer) {
    const auto moved = [&](const Field& field) {
      Field result(field.size());
      const std::int64_t nx = problem.system.nx, ny = problem.system.ny;
      for (std::int64_t y = 0; y < ny; ++y)
        for (std::int64_t x = 0; x < nx; ++x)
          result[static_cast<std::size_t>((y + 5) % ny * nx + (x + 11) % nx)] = field[static_cast<std::size_t>(y * nx + x)];
      return result;
    };
    Problem other = problem;
    other.gap = moved(problem.gap);
    check_near(solved(other, pair).p, moved(answer.p), 1e-9, "p");
  });
}

void masked_points_carry_nothing(std::int32_t boundary, const Pair& pair) {
  Problem problem = yielding(boundary);
  problem.mask.assign(problem.points(), 1);
  for (std::size_t i = 0; i < problem.points(); i += 7) problem.mask[i] = 0;
  const Answer answer = solved(problem, pair);
  check(answer.result.capped > 0, "the surface should yield");
  for (std::size_t i = 0; i < problem.points(); ++i)
    check(problem.included(i) || answer.p[i] == 0, "a masked point carries pressure");
  check_against_naive(problem, answer);
}

// The elastic answer's bits, with as many products.
void a_hardness_never_reached_changes_nothing(std::int32_t boundary, const Pair& pair) {
  Problem elastic = rough_problem(40, 30, boundary, 0.5, 0.75);
  elastic.target *= 1.4;
  rc_system capped = elastic.system;
  capped.hardness = 1;
  for (const std::string& solver : solver_names())
    if (pair.solver == "auto" && solver != "greedy" && !obstacle({solver, pair.backend}, capped, elastic.control).empty() &&
        obstacle({solver, pair.backend}, elastic.system, elastic.control).empty())
      throw Skipped("auto may take " + solver + ", which keeps no hardness");
  for (int by_load = 0; by_load < 2; ++by_load) {
    const Settings settings = {{RC_OPT_TOL, "1e-9"}, {RC_OPT_STIFFNESS, "1"}, {"cmr.inner", "polonsky-keer"}};
    const Answer expected = solve(elastic, pair, settings);
    check_status(expected, RC_OK);
    for (const double hardness : {100 * largest(expected.p), HUGE_VAL}) {
      Problem hard = elastic;
      hard.system.hardness = hardness;
      const Answer answer = solve(hard, pair, settings);
      check_status(answer, RC_OK);
      check_same(answer.p, expected.p, "p");
      check_same(answer.gap, expected.gap, "gap");
      const rc_result &a = answer.result, &b = expected.result;
      check_same({a.load, a.approach, a.energy, a.stiffness, a.kkt_primal, a.kkt_dual, a.kkt_complementarity},
                 {b.load, b.approach, b.energy, b.stiffness, b.kkt_primal, b.kkt_dual, b.kkt_complementarity}, "results");
      check_same({a.duality_gap, a.load_lower, a.load_upper, a.area_lower, a.area_upper},
                 {b.duality_gap, b.load_lower, b.load_upper, b.area_lower, b.area_upper}, "bounds");
      check_equal(a.products, b.products, "products");
      check_equal(a.capped, 0, "points at the hardness");
      check(a.plastic_volume == 0 && a.proven_capped == 0, "nothing yields");
    }
    elastic = at_load(elastic, expected.result.load);
  }
}

// Any number of threads, a repetition and a reset give the same bits.
void repetition_repeats(std::int32_t boundary, const Pair& pair) {
  const Problem problem = yielding(boundary);
  const Answer once = solved(problem, pair);
  check_same(solved(problem, pair).p, once.p, "p");
  check_same(solved(problem, pair, {{RC_OPT_THREADS, "3"}}).p, once.p, "p by three threads");
}

// A start far beyond the hardness, and one of an unrelated pattern.
void the_start_does_not_matter(std::int32_t boundary, const Pair& pair) {
  in_both_controls(boundary, pair, [&](const Problem& problem, const Answer& answer) {
    for (const double factor : {0.5, 1.0, 50.0}) {
      Field start(problem.points());
      for (std::size_t i = 0; i < start.size(); ++i) start[i] = i % 3 == 0 ? factor * problem.system.hardness : 0;
      rc_step step = problem.step();
      step.p0.data = start.data();
      const Answer other = Contact(problem, pair).solve(step);
      check_status(other, RC_OK);
      check_near(other.p, answer.p, 1e-9, "p");
    }
  });
}

void greedy_is_refused() {
  const Problem problem = yielding(RC_BOUNDARY_FREE);
  const rc_status status = rc_pair_supported(nullptr, "greedy", "dense", &problem.system, problem.control, nullptr);
  check_equal(status, RC_ERR_INCOMPATIBLE, "greedy");
  check(std::string(rc_last_error()).find("knows no largest pressure") != std::string::npos, rc_last_error());
  check_status(solve(problem, {"nnls", "dense"}, {{RC_OPT_WARMUP, "greedy"}}), RC_ERR_INCOMPATIBLE, "greedy as a warm-up");
  check_status(solve(problem, {"nnls", "dense"}, {{RC_OPT_WARMUP, "gp"}}), RC_OK, "gp as a warm-up");
}

// The whole grid is solved where coarser ones might do for elastic contact.
void an_accuracy_goal_solves_the_whole_grid() {
  Problem problem = rough_problem(128, 128);
  problem.system.hardness = 0.3 * largest(solve(problem, automatic, {{RC_OPT_TOL, "1e-6"}}).p);
  const Answer answer = solve(problem, automatic, {{RC_OPT_ACCURACY, "0.05"}});
  check_status(answer, RC_OK);
  check_equal(answer.result.model_nx, 128, "points of the model");
  check(answer.result.error_estimate == 0, "there is no error of a coarser grid");
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  std::vector<Test> tests = {{"greedy_is_refused", greedy_is_refused},
                             {"an_accuracy_goal_solves_the_whole_grid", an_accuracy_goal_solves_the_whole_grid}};
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    rc_system system = support::unit_system();
    system.boundary = boundary;
    system.hardness = 1;
    for (const char* backend : {"dense", "fft"}) {
      std::vector<std::string> solvers = capped_solvers(backend, system);
      solvers.emplace_back("auto");
      for (const std::string& solver : solvers) {
        const Pair pair = {solver, backend};
        const auto add = [&](const char* name, void (*body)(std::int32_t, const Pair&)) {
          tests.push_back({pair.name() + "/" + kind_of(system) + "/" + name, [=] { body(boundary, pair); }});
        };
        add("units_scale_the_answer", units_scale_the_answer);
        add("datum_does_not_matter", datum_does_not_matter);
        add("transposition_transposes", transposition_transposes);
        add("masked_points_carry_nothing", masked_points_carry_nothing);
        add("repetition_repeats", repetition_repeats);
        add("the_start_does_not_matter", the_start_does_not_matter);
        add("a_hardness_never_reached_changes_nothing", a_hardness_never_reached_changes_nothing);
        if (boundary == RC_BOUNDARY_PERIODIC)
          tests.push_back({pair.name() + "/translation_translates", [=] { translation_translates(pair); }});
      }
    }
  }
  return run_group("hardness invariance", tests, argc, argv);
}
