// Figure 4: the algorithms of sections 3 and 4 on one loading history, with dense products as in the paper and with FFT products.
#include <algorithm>
#include <cmath>

#include "loading_history.h"
#include "paper.h"

namespace bench {

namespace {

struct Method {
  const char* name;
  Settings settings;
  bool warm;
  bool dense_only;  // one solve for every point of the contact set
};

const Settings single = {{"solver", "nnls"}, {"nnls.pivoting", "single"}};

Settings with(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

const std::vector<Method>& methods() {
  static const Settings gradient_steps = {
      {"warmup", "gp"}, {"warmup.iterations", "100"}, {"gp.lipschitz", "frobenius"}, {"gp.restart", "0"}};
  static const std::vector<Method> all = {
      {"P&K 1999", {{"solver", "polonsky-keer"}}, false, false},
      {"P&K 1999, warm", {{"solver", "polonsky-keer"}}, true, false},
      {"greedy CG", {{"solver", "greedy"}}, false, false},
      {"ADMM, warm", {{"solver", "admm"}, {"admm.relaxation", "1.5"}}, true, false},
      {"NNLS", single, false, true},
      {"NNLS, warm", single, true, true},
      {"NNLS + 100 GP", with(single, gradient_steps), false, false},
      {"NNLS by blocks, warm", {{"solver", "nnls"}}, true, false},
      {"haar-cg, warm", {{"solver", "haar-cg"}}, true, false},
  };
  return all;
}

// A surface and a way to multiply.
struct Setting {
  const char* name;
  std::int64_t levels;
  const char* backend;
  const char* kernel;
  std::uint64_t seeds;
  std::int64_t most;  // candidates up to which a step is solved
  double cost;        // seconds of one method on one surface
};

Json step_record(const LoadingHistory& history, const HistoryStep& step) {
  const rc_result& result = step.result;
  return {{"approach", result.displacement / history.approaches.back()},
          {"mean_pressure", result.mean_pressure},
          {"candidates", result.candidates},
          {"contacts", result.contacts},
          {"cpu_seconds", step.cpu_seconds},
          {"iterations", result.iterations},
          {"products", result.applications},
          {"status", rc_status_name(result.status)}};
}

double rms_height(const Field& gap) {
  double mean = 0, squares = 0, count = 0;
  for (const double value : gap) {
    const double off = value - mean;
    mean += off / ++count;
    squares += off * (value - mean);
  }
  return std::sqrt(squares / count);
}

Json measure(const Setting& setting, const Method& method, std::uint64_t seed, std::int64_t threads) {
  LoadingHistory history = loading_history(setting.levels, 0.7, seed, 10);
  std::size_t fitting = 0;
  for (const double approach : history.approaches)
    fitting += std::count_if(history.gap.begin(), history.gap.end(), [=](double gap) { return gap < approach; }) <= setting.most;
  history.approaches.resize(fitting);
  const Settings common = {{RC_OPT_BACKEND, setting.backend},
                           {RC_OPT_KERNEL, setting.kernel},
                           {RC_OPT_TOL, "1e-8"},
                           {RC_OPT_MAX_ITER, "100000"},
                           {RC_OPT_BOUNDS, "0"},
                           {RC_OPT_THREADS, std::to_string(threads)},
                           {RC_OPT_TIME_LIMIT, "60"}};
  Json steps = Json::array();
  double cpu = 0;
  std::int64_t products = 0, iterations = 0;
  std::string status = "RC_OK";
  for (const HistoryStep& step : run_history(history, with(common, method.settings), method.warm)) {
    steps.push_back(step_record(history, step));
    cpu += step.cpu_seconds;
    products += step.result.applications;
    iterations += step.result.iterations;
    if (step.result.status != RC_OK) status = rc_status_name(step.result.status);
  }
  return {{"points_a_side", history.n}, {"backend", setting.backend},
          {"kernel", setting.kernel},   {"rms_height", rms_height(history.gap)},
          {"steps_of_ten", fitting},    {"cpu_seconds", cpu},
          {"products", products},       {"iterations", iterations},
          {"status", status},           {"steps", steps}};
}

}  // namespace

void plan_figure_4(const PaperRequest& request, Plan& plan) {
  constexpr std::int64_t all = std::int64_t{1} << 40;
  const std::vector<Setting> full = {{"small", 7, "dense", "eq9", 10, all, 2},
                                     {"small, love", 7, "dense", "love", 10, all, 2},
                                     {"dense", 9, "dense", "eq9", 3, 6000, 20},
                                     {"fft", 9, "fft", "eq9", 5, all, 10}};
  const std::vector<Setting> quick = {{"small", 6, "dense", "eq9", 2, all, 0.1},
                                      {"small, love", 6, "dense", "love", 2, all, 0.1},
                                      {"dense", 7, "dense", "eq9", 1, 600, 0.3},
                                      {"fft", 7, "fft", "eq9", 1, all, 1}};
  for (const Setting& setting : request.quick ? quick : full)
    for (std::uint64_t seed = 1; seed <= setting.seeds; ++seed)
      for (const Method& method : methods()) {
        if (method.dense_only && std::string(setting.backend) != "dense") continue;
        plan.push_back({"figure_4",
                        {{"setting", setting.name}, {"method", method.name}, {"seed", seed}},
                        setting.cost,
                        [setting, &method, seed, threads = request.threads] { return measure(setting, method, seed, threads); }});
      }
}

}  // namespace bench
