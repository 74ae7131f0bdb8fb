#include "histories.h"

#include <algorithm>
#include <iostream>

#include "library.h"
#include "measurement.h"
#include "rough_surface.h"
#include "table.h"

namespace bench {

namespace {

// Ten increasing steps up to half the height of the highest point above the mean plane: Bemporad & Paggi (2015), section 4.
struct History {
  std::int64_t n = 0;
  Field gap;
  std::vector<double> approaches;
};

History history_of(const HistoriesRequest& request, std::uint64_t seed) {
  History history;
  history.n = std::int64_t{1} << request.levels;
  history.gap = gap_below_highest(midpoint_surface(request.levels, request.hurst, seed));
  const double deepest = mean_of(history.gap) / 2;
  for (std::int64_t k = 1; k <= request.steps; ++k)
    history.approaches.push_back(deepest * static_cast<double>(k) / static_cast<double>(request.steps));
  return history;
}

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

std::vector<rc_result> run(const HistoriesRequest& request, const History& history, const std::string& variant, bool warm) {
  Options options;
  const std::vector<std::string> parts = parts_of(variant);
  options.set(RC_OPT_SOLVER, parts.front()).set(RC_OPT_BACKEND, backend_of(request, variant)).set(RC_OPT_TOL, request.tol);
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const auto equals = parts[k].find('=');
    if (equals == std::string::npos) throw Failure("\"" + parts[k] + "\" is not key=value");
    options.set(parts[k].substr(0, equals).c_str(), parts[k].substr(equals + 1));
  }
  options.set(RC_OPT_THREADS, static_cast<double>(request.threads)).set(RC_OPT_TIME_LIMIT, request.time_limit);
  options.set(RC_OPT_MAX_ITER, "100000");
  if (backend_of(request, variant) == "dense") options.set("dense.memory_limit", "16384");
  Contact contact(unit_square(history.n), options);
  std::vector<rc_result> results;
  rc_step step = RC_STEP_INIT;
  step.gap = history.gap.data();
  for (const double approach : history.approaches) {
    step.target = approach;
    step.warm_start = warm;
    results.push_back(contact.solve(step));
    step.gap = warm ? nullptr : history.gap.data();
    if (results.back().status == RC_STOP_TIME) break;  // the later steps are no shorter
    if (!warm) contact.reset();
  }
  return results;
}

double products(const rc_result& result) { return static_cast<double>(result.applications); }
double iterations(const rc_result& result) { return static_cast<double>(result.iterations); }
double seconds(const rc_result& result) { return result.seconds; }

template <class Value> double total(const std::vector<rc_result>& results, std::size_t first, const Value& value) {
  double sum = 0;
  for (std::size_t k = first; k < results.size(); ++k) sum += value(results[k]);
  return sum;
}

bool certified(const std::vector<rc_result>& results, const History& history) {
  return results.size() == history.approaches.size() &&
         std::all_of(results.begin(), results.end(), [](const rc_result& result) { return result.status == RC_OK; });
}

Json measure(const HistoriesRequest& request, std::uint64_t seed, const std::string& solver) {
  const History history = history_of(request, seed);
  const std::vector<rc_result> cold = run(request, history, solver, false), warm = run(request, history, solver, true);
  Json steps = Json::array();
  double worst = 0;
  for (std::size_t k = 0; k < std::min(cold.size(), warm.size()); ++k) {
    worst = std::max(worst, std::abs(warm[k].load / cold[k].load - 1));
    steps.push_back({{"solver", solver},
                     {"seed", seed},
                     {"step", k + 1},
                     {"contacts", cold[k].contacts},
                     {"candidates", cold[k].candidates},
                     {"cold_products", cold[k].applications},
                     {"warm_products", warm[k].applications},
                     {"cold_seconds", cold[k].seconds},
                     {"warm_seconds", warm[k].seconds},
                     {"cold_status", rc_status_name(cold[k].status)},
                     {"warm_status", rc_status_name(warm[k].status)}});
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
          {"status", sound ? "RC_OK" : rc_status_name(std::max(cold.back().status, warm.back().status))},
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
