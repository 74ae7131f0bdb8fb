// Figure 6: how many gradient projections pay before NNLS.
#include "loading_history.h"
#include "paper.h"

namespace bench {

namespace {

Settings settings_for(const std::string& solver, const std::string& pivoting) {
  return {{RC_OPT_SOLVER, solver}, {"nnls.pivoting", pivoting}, {RC_OPT_BACKEND, "dense"},     {RC_OPT_KERNEL, "eq9"},
          {RC_OPT_TOL, "1e-8"},    {RC_OPT_BOUNDS, "0"},        {"gp.lipschitz", "frobenius"}, {"gp.restart", "0"}};
}

std::int64_t iterations_of(const std::vector<HistoryStep>& steps) {
  std::int64_t sum = 0;
  for (const HistoryStep& step : steps) sum += step.result.iterations;
  return sum;
}

Json measure(std::int64_t levels, const std::string& pivoting, std::int64_t projections, std::uint64_t seed) {
  const LoadingHistory history = loading_history(levels, 0.7, seed, 10);
  Settings settings = settings_for("nnls", pivoting), alone = settings_for("gp", pivoting);
  settings.emplace_back(RC_OPT_MAX_ITER, "1000000");
  alone.emplace_back(RC_OPT_MAX_ITER, std::to_string(projections));
  if (projections > 0) {
    settings.emplace_back(RC_OPT_WARMUP, "gp");
    settings.emplace_back(RC_OPT_WARMUP_ITERATIONS, std::to_string(projections));
  }
  const std::vector<HistoryStep> steps = run_history(history, settings, false);
  // The projections count as iterations, too, and end early where they have solved the problem.
  const std::int64_t solves = iterations_of(steps) - (projections > 0 ? iterations_of(run_history(history, alone, false)) : 0);
  double cpu = 0;
  std::string status = "RC_OK";
  Json rows = Json::array();
  for (const HistoryStep& step : steps) {
    cpu += step.cpu_seconds;
    if (step.result.status != RC_OK) status = rc_status_name(step.result.status);
    rows.push_back({{"mean_pressure", step.result.mean_pressure},
                    {"candidates", step.result.candidates},
                    {"contacts", step.result.contacts},
                    {"cpu_seconds", step.cpu_seconds}});
  }
  return {{"points_a_side", history.n}, {"cpu_seconds", cpu}, {"solves", solves}, {"status", status}, {"steps", rows}};
}

}  // namespace

void plan_figure_6(const PaperRequest& request, Plan& plan) {
  const std::int64_t levels = request.quick ? 6 : 7;
  const std::uint64_t seeds = request.quick ? 2 : 8;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (const std::string pivoting : {"single", "block"})
      for (const std::int64_t projections : {0, 10, 50, 100, 200}) {
        const double cost = (request.quick ? 0.02 : 1) * (pivoting == "block" ? 0.5 : projections == 10 ? 8 : 2);
        plan.push_back({"figure_6", {{"pivoting", pivoting}, {"projections", projections}, {"seed", seed}}, cost, [=] {
                          return measure(levels, pivoting, projections, seed);
                        }});
      }
}

}  // namespace bench
