#include "accuracy.h"

#include <cmath>
#include <iostream>

#include "accuracy_scene.h"
#include "library.h"
#include "measurement.h"
#include "table.h"

namespace bench {

namespace {

bool supported(const std::string& solver, const std::string& backend, const rc_system& system) {
  return rc_pair_supported(nullptr, solver.c_str(), backend.c_str(), &system, RC_CONTROL_DISPLACEMENT, nullptr) == RC_OK;
}

// Backends whose cost grows with a power of the candidates instead of the grid model the candidates only.
bool affordable(const AccuracyRequest& request, const std::string& backend, const AccuracyScene& scene) {
  return backend == "fft" || scene.candidates() <= request.most_factored;
}

Json measure(const AccuracyRequest& request, const AccuracyScene& scene, const std::string& solver, const std::string& backend,
             double tol) {
  const rc_system system = unit_square(scene.n);
  Options options;
  options.set(RC_OPT_SOLVER, solver).set(RC_OPT_BACKEND, backend).set(RC_OPT_TOL, tol);
  options.set(RC_OPT_THREADS, static_cast<double>(request.threads)).set(RC_OPT_TIME_LIMIT, request.time_limit);
  rc_step step = RC_STEP_INIT;
  step.gap = scene.gap.data();
  step.target = scene.approach;
  Field pressure(scene.gap.size());
  const TimedSolve timed = time_solve(system, step, options, request.budget, pressure.data());
  Json row = {{"scene", scene.name}, {"n", scene.n}, {"tol", tol}};
  row.update(record_of(timed.result));
  row["setup_seconds"] = timed.setup_seconds;
  row["cpu_seconds"] = timed.cpu_seconds;
  row["repeats"] = timed.repeats;
  row.update(scene.errors(pressure, timed.result));
  return row;
}

void measure_pair(const AccuracyRequest& request, const AccuracyScene& scene, const std::string& solver,
                  const std::string& backend, Json& rows) {
  std::cerr << scene.name << ": " << solver << " on " << backend << "\n";
  for (const int digits : request.digits) {
    rows.push_back(measure(request, scene, solver, backend, std::pow(10.0, -digits)));
    if (rows.back().at("status") == rc_status_name(RC_STOP_TIME)) return;
  }
}

const std::vector<Column> columns = {{"scene", "scene"},
                                     {"solver", "solver"},
                                     {"backend", "backend"},
                                     {"tol", "tol", "%.0e"},
                                     {"set-up s", "setup_seconds", "%.4f"},
                                     {"solve s", "solve_seconds", "%.4f"},
                                     {"products", "products"},
                                     {"load error", "load_error", "%.1e"},
                                     {"area error", "area_error", "%.1e"},
                                     {"pressure error", "pressure_error", "%.1e"},
                                     {"primal", "kkt_primal", "%.0e"},
                                     {"dual", "kkt_dual", "%.0e"},
                                     {"compl.", "kkt_complementarity", "%.0e"},
                                     {"status", "status"}};
const std::vector<Column> grid_columns = {{"scene", "scene"},
                                          {"n", "n"},
                                          {"against", "against"},
                                          {"load error", "load_error", "%.1e"},
                                          {"area error", "area_error", "%.1e"},
                                          {"pressure error", "pressure_error", "%.1e"},
                                          {"status", "status"}};

}  // namespace

Json run_accuracy(const AccuracyRequest& request) {
  Json rows = Json::array(), grids = Json::array();
  for (const std::string& name : request.scenes) {
    std::cerr << name << ": truth and discretisation error\n";
    const AccuracyScene scene = make_accuracy_scene(name, request.threads);
    for (const Json& grid : scene.discretisation) grids.push_back(grid);
    const rc_system system = unit_square(scene.n);
    for (const std::string& backend : backend_names())
      for (const std::string& solver : request.solvers)
        if (supported(solver, backend, system) && affordable(request, backend, scene))
          measure_pair(request, scene, solver, backend, rows);
  }
  std::cout << "Cold solves against the truth of each scene (relative errors)\n" << table(columns, rows);
  std::cout << "\nDiscretisation error: what the grid itself costs\n" << table(grid_columns, grids);
  return {{"rows", rows}, {"discretisation", grids}};
}

}  // namespace bench
