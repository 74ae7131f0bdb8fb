// A hardness that is never reached changes nothing; what solvers and goals do not keep one is refused or left.
#include <algorithm>
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
        tests.push_back({pair.name() + "/" + kind_of(system) + "/a_hardness_never_reached_changes_nothing",
                         [=] { a_hardness_never_reached_changes_nothing(boundary, pair); }});
      }
    }
  }
  return run_group("hardness invariance", tests, argc, argv);
}
