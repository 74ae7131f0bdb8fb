#include "failure_run.h"

#include <algorithm>
#include <cmath>

#include "child.h"

namespace bench {

double Solved::residual() const {
  return std::max({result.kkt_primal, result.kkt_dual, result.kkt_complementarity, result.kkt_control});
}

Solved solve(const Scene& scene, const Settings& settings, const Field* start) {
  Options options;
  options.set(RC_OPT_KERNEL, scene.kernel);
  options.set(settings);
  rc_step step = scene.step();
  if (start) step.p0 = start->data();
  Solved solved;
  solved.p.assign(scene.gap.size(), 0.0);
  rc_result_init(&solved.result);
  solved.result.p = solved.p.data();
  const double before = cpu_seconds();
  solved.status = rc_solve(&scene.system, &step, options.get(), &solved.result);
  solved.cpu_seconds = cpu_seconds() - before;
  solved.message = rc_last_error();
  solved.result.p = nullptr;
  return solved;
}

Solved truth_of(const Scene& scene) {
  Solved solved = solve(scene, {{"solver", "nnls"}, {"backend", "dense"}, {"tol", "1e-12"}});
  if (solved.status != RC_OK) throw Failure(scene.name + ": " + solved.message);
  return solved;
}

bool runs(const std::string& solver, const std::string& backend, const Scene& scene) {
  return rc_pair_supported(nullptr, solver.c_str(), backend.c_str(), &scene.system, RC_CONTROL_DISPLACEMENT, nullptr) == RC_OK;
}

double difference(const Field& a, const Field& b) {
  double largest = 0, worst = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    worst = std::max(worst, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return largest > 0 ? worst / largest : worst;
}

Field scaled(Field values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

}  // namespace bench
