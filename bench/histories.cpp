#include "histories.h"

#include <algorithm>
#include <iostream>

#include "format.h"
#include "library.h"
#include "loading_history.h"
#include "table.h"

namespace bench {

namespace {

// "solver+key=value+key=value@backend"
std::string backend_of(const HistoriesRequest& request, const std::string& variant) {
  const auto at = variant.find('@');
  return at == std::string::npos ? request.backend : variant.substr(at + 1);
}

std::vector<std::string> parts_of(const std::string& named) {
  const std::string variant = named.substr(0, named.find('@'));
  std::vector<std::string> parts(1);
  for (const char c : variant) {
    if (c == '+')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::vector<HistoryStep> run(const HistoriesRequest& request, const LoadingHistory& history, const std::string& variant,
                             bool warm) {
  const std::vector<std::string> parts = parts_of(variant);
  const std::string backend = backend_of(request, variant);
  Settings settings = {{RC_OPT_SOLVER, parts.front()},
                       {RC_OPT_BACKEND, backend},
                       {RC_OPT_TOL, formatted("%.17g", request.tol)},
                       {RC_OPT_THREADS, std::to_string(request.threads)},
                       {RC_OPT_TIME_LIMIT, formatted("%.17g", request.time_limit)},
                       {RC_OPT_MAX_ITER, "100000"}};
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const auto equals = parts[k].find('=');
    if (equals == std::string::npos) throw Failure("\"" + parts[k] + "\" is not key=value");
    settings.emplace_back(parts[k].substr(0, equals), parts[k].substr(equals + 1));
  }
  if (backend == "dense") settings.emplace_back("dense.memory_limit", "16384");
  return run_history(history, settings, warm);
}

double products(const HistoryStep& step) { return static_cast<double>(step.result.applications); }
double iterations(const HistoryStep& step) { return static_cast<double>(step.result.iterations); }
double seconds(const HistoryStep& step) { return step.result.seconds; }

template <class Value> double total(const std::vector<HistoryStep>& steps, std::size_t first, const Value& value) {
  double sum = 0;
  for (std::size_t k = first; k < steps.size(); ++k) sum += value(steps[k]);
  return sum;
}

bool certified(const std::vector<HistoryStep>& steps, const LoadingHistory& history) {
  return steps.size() == history.approaches.size() &&
         std::all_of(steps.begin(), steps.end(), [](const HistoryStep& step) { return step.result.status == RC_OK; });
}

Json measure(const HistoriesRequest& request, std::uint64_t seed, const std::string& solver) {
  const LoadingHistory history = loading_history(request.levels, request.hurst, seed, request.steps);
  const std::vector<HistoryStep> cold = run(request, history, solver, false), warm = run(request, history, solver, true);
  Json steps = Json::array();
  double worst = 0;
  for (std::size_t k = 0; k < std::min(cold.size(), warm.size()); ++k) {
    const rc_result &from_zero = cold[k].result, &from_last = warm[k].result;
    worst = std::max(worst, std::abs(from_last.load / from_zero.load - 1));
    steps.push_back({{"solver", solver},
                     {"seed", seed},
                     {"step", k + 1},
                     {"contacts", from_zero.contacts},
                     {"candidates", from_zero.candidates},
                     {"cold_products", from_zero.applications},
                     {"warm_products", from_last.applications},
                     {"cold_seconds", from_zero.seconds},
                     {"warm_seconds", from_last.seconds},
                     {"cold_status", rc_status_name(from_zero.status)},
                     {"warm_status", rc_status_name(from_last.status)}});
  }
  const bool sound = certified(cold, history) && certified(warm, history);
  return {{"solver", solver.substr(0, solver.find('@'))},
          {"backend", backend_of(request, solver)},
          {"n", history.n},
          {"seed", seed},
          {"tol", request.tol},
          {"cold_products", total(cold, 0, products)},
          {"warm_products", total(warm, 0, products)},
          {"cold_iterations", total(cold, 0, iterations)},
          {"warm_iterations", total(warm, 0, iterations)},
          {"ratio", total(warm, 0, products) / total(cold, 0, products)},
          {"ratio_later", total(warm, 1, products) / total(cold, 1, products)},
          {"cold_seconds", total(cold, 0, seconds)},
          {"warm_seconds", total(warm, 0, seconds)},
          {"load_difference", worst},
          {"status", sound ? "RC_OK" : rc_status_name(std::max(cold.back().result.status, warm.back().result.status))},
          {"steps", steps}};
}

const std::vector<Column> columns = {{"solver", "solver"},
                                     {"backend", "backend"},
                                     {"n", "n"},
                                     {"seed", "seed"},
                                     {"cold products", "cold_products"},
                                     {"warm products", "warm_products"},
                                     {"warm/cold", "ratio", "%.2f"},
                                     {"cold iterations", "cold_iterations"},
                                     {"warm iterations", "warm_iterations"},
                                     {"from step 2", "ratio_later", "%.2f"},
                                     {"cold s", "cold_seconds", "%.2f"},
                                     {"warm s", "warm_seconds", "%.2f"},
                                     {"load difference", "load_difference", "%.0e"},
                                     {"status", "status"}};

}  // namespace

Json run_histories(const HistoriesRequest& request) {
  const rc_system system = unit_square(std::int64_t{1} << request.levels);
  Json totals = Json::array(), steps = Json::array();
  std::vector<std::string> solvers = request.solvers;
  if (solvers.empty()) {
    // The paper's method with the paper's matrix first.
    solvers = solver_names();
    if (request.backend != "dense") solvers.insert(solvers.begin(), "nnls@dense");
  }
  for (const std::string& solver : solvers) {
    const std::string backend = backend_of(request, solver);
    if (rc_pair_supported(nullptr, parts_of(solver).front().c_str(), backend.c_str(), &system, RC_CONTROL_DISPLACEMENT,
                          nullptr) != RC_OK)
      continue;
    for (const std::uint64_t seed : request.seeds) {
      std::cerr << parts_of(solver).front() << " on " << backend << ", seed " << seed << "\n";
      Json row = in_child([&] { return measure(request, seed, solver); });
      if (!row.contains("error")) {
        for (const Json& step : row.at("steps")) steps.push_back(step);
        row.erase("steps");
      } else {
        row["solver"] = solver;
      }
      totals.push_back(row);
    }
  }
  std::cout << request.steps << " increasing steps, warm-started and from zero, each certified to " << request.tol << "\n"
            << table(columns, totals);
  return {{"histories", totals}, {"steps", steps}};
}

}  // namespace bench
