#include "pareto.h"

#include <malloc.h>

#include <algorithm>
#include <iostream>

#include "format.h"
#include "measurement.h"
#include "pareto_export.h"
#include "pareto_methods.h"
#include "pareto_truth.h"
#include "process_memory.h"
#include "progress.h"
#include "provenance.h"
#include "result_file.h"
#include "stopwatch.h"

namespace bench {

namespace {

constexpr double truth_tol = 1e-13;

double power_of_ten(int digits) { return std::stod("1e-" + std::to_string(digits)); }

// Four digits: no measurement is better, and the file stays short.
double rounded(double value) { return std::stod(formatted("%.3e", value)); }

struct Against {
  std::string prefix;
  const Truth* truth;
};

// One solve and its errors, in the calling process.
Json solve_and_compare(const ParetoCase& of, std::int64_t n, const Field& gap, const Options& options, double budget,
                       const std::vector<Against>& truths) {
  rc_step step = RC_STEP_INIT;
  step.control = of.scene.control;
  step.target = of.target;
  step.gap = gap.data();
  Field pressure(gap.size());
  const double before = resident_memory();
  const TimedSolve timed = time_solve(of.scene.system(n), step, options, budget, pressure.data());
  const double peak = std::max(peak_memory(), before);
  const rc_result& result = timed.result;
  Json point = {
      {"status", rc_status_name(result.status)},
      {"setup_seconds", rounded(timed.setup_seconds)},
      {"solve_seconds", rounded(result.seconds)},
      {"cpu_seconds", rounded(timed.cpu_seconds)},
      {"memory_bytes", peak - before},
      {"products", result.applications},
      {"residual", rounded(std::max({result.kkt_primal, result.kkt_dual, result.kkt_complementarity, result.kkt_control}))},
      {"chosen", std::string(result.solver) + ", " + result.backend}};
  for (const auto& [prefix, truth] : truths) {
    const RelativeErrors errors = errors_against(*truth, pressure, result.load, result.contact_area);
    point[prefix + "load_error"] = rounded(errors.load);
    point[prefix + "area_error"] = rounded(errors.area);
    point[prefix + "pressure_error"] = rounded(errors.pressure);
  }
  return point;
}

double total_seconds(const Json& point) { return point.value("setup_seconds", 0.0) + point.value("solve_seconds", 0.0); }

class Pareto {
 public:
  explicit Pareto(const ParetoRequest& request)
      : request_(request), file_(request.file, "pareto", request.threads), library_(library_hash()) {}

  void run() {
    std::vector<ParetoScene> scenes;
    for (const std::string& name : request_.scenes) {
      FoundScene found = make_pareto_scene(name, request_.n, request_.surfaces);
      if (found.scene)
        scenes.push_back(std::move(*found.scene));
      else
        std::cerr << "scene " << name << " is left out: " << found.missing << '\n';
    }
    std::vector<std::pair<const ParetoScene*, double>> cases;
    for (const double contact : request_.contacts)
      for (const ParetoScene& scene : scenes) {
        if (scene.full && contact == request_.contacts.front()) cases.emplace_back(&scene, 1.0);
        if (!scene.full && contact <= scene.most_contact) cases.emplace_back(&scene, contact);
      }
    Progress progress(static_cast<double>(cases.size()));
    for (const auto& [scene, contact] : cases) {
      progress.begin(formatted("%s, %g %% in contact", scene->name.c_str(), 100 * contact));
      one_case(*scene, contact);
      progress.done(1);
    }
  }

  void finish() {
    if (!request_.export_folder.empty()) exports_.write_list();
    if (!request_.csv.empty()) write_pareto_csv(file_.document(), request_.csv);
    std::cout << measured_ << " measured, " << failed_ << " of them failed; " << before_ << " measured before"
              << (left_ > 0 ? formatted("; %d not begun, the time is up", left_) : "") << '\n';
  }

 private:
  // In the file at once; nothing where this library has measured it.
  bool measured_before(const char* list, const Json& key) {
    Json now = key;
    now["library"] = library_;
    if (!file_.find(list, now)) return false;
    ++before_;
    return true;
  }
  bool time_is_up() {
    if (request_.time_limit <= 0 || seconds_since(begun_) < request_.time_limit) return false;
    ++left_;
    return true;
  }
  void put(const char* list, const Json& key, const Json& values) {
    Json row = key;
    row["library"] = library_;
    row.update(values);
    file_.put(list, key, row);
  }

  double target_of(const ParetoScene& scene, double contact) {
    if (scene.known) return scene.known(contact).target;
    const Json key = {{"scene", scene.name}, {"contact", contact}, {"n", scene.n}};
    if (const Json* const known = file_.find("approaches", key)) return known->at("approach");
    Json row = key;
    row["approach"] = search_approach(scene, contact, request_.threads);
    file_.put("approaches", key, row);
    return row.at("approach");
  }

  void one_case(const ParetoScene& scene, double contact) {
    const Json key = {{"scene", scene.name},         {"contact", contact},        {"n", scene.n},
                      {"threads", request_.threads}, {"digits", request_.digits}, {"grid_digits", request_.grid_digits}};
    const bool known = measured_before("cases", key);
    const bool exported = !request_.export_folder.empty() && scene.boundary == RC_BOUNDARY_FREE && !scene.full &&
                          contact == request_.contacts.front();
    if ((known && !exported) || (!known && time_is_up())) return;

    const ParetoCase of{scene, contact, target_of(scene, contact)};
    const CertifiedTruth exact = solve_certified(of, scene.n, truth_tol, request_.threads);
    if (exported) exports_.add(of, exact.truth);
    if (known) return;
    const GridTruth truth(of, request_.threads);
    const int left = left_;
    compare_methods(of, exact, truth);
    compare_grids(of, truth);
    if (left_ > left) return;  // to be gone on with
    put("cases", key,
        {{"boundary", scene.boundary == RC_BOUNDARY_PERIODIC ? "periodic" : "free"},
         {"control", scene.control == RC_CONTROL_LOAD ? "load" : "displacement"},
         {"target", of.target},
         {"points", exact.result.points},
         {"candidates", exact.result.candidates},
         {"contacts", exact.result.contacts},
         {"load", exact.truth.load},
         {"truth", truth.source()},
         {"certified_status", rc_status_name(exact.result.status)},
         {"certified_residual", rounded(exact.residual())}});
  }

  void compare_methods(const ParetoCase& of, const CertifiedTruth& exact, const GridTruth& truth) {
    const ParetoScene& scene = of.scene;
    const Field gap = scene.gap(scene.n);
    const Truth on_grid = truth.on(scene.n);
    for (const ParetoMethod& method :
         pareto_methods(scene.system(scene.n), scene.control, exact.result.candidates, request_.most_factored)) {
      const Json key = {{"scene", scene.name},         {"contact", of.contact},     {"n", scene.n},
                        {"solver", method.solver},     {"backend", method.backend}, {"variant", method.variant},
                        {"threads", request_.threads}, {"digits", request_.digits}};
      if (measured_before("methods", key)) continue;
      if (time_is_up()) return;
      const Json points =
          sweep(of, scene.n, gap, request_.digits, method.least_tol, method.settings, {{"", &exact.truth}, {"true_", &on_grid}});
      put("methods", key, {{"points", points}});
    }
  }

  // Every kernel on coarser and finer grids; tolerances with the kernel that the library takes by itself.
  void compare_grids(const ParetoCase& of, const GridTruth& truth) {
    const ParetoScene& scene = of.scene;
    const std::string usual = scene.boundary == RC_BOUNDARY_PERIODIC ? "spectral" : "love";
    for (const std::int64_t points : {scene.n / 2, scene.n, 2 * scene.n}) {
      const Field gap = scene.gap(points);
      const Truth on_grid = truth.on(points);
      for (const std::string& kernel : kernel_names()) {
        if ((kernel == "spectral") != (usual == "spectral")) continue;
        const std::vector<int> digits = kernel == usual ? request_.grid_digits : std::vector<int>{request_.grid_digits.back()};
        const Json key = {{"scene", scene.name}, {"contact", of.contact},       {"n", scene.n},    {"grid", points},
                          {"kernel", kernel},    {"threads", request_.threads}, {"digits", digits}};
        if (measured_before("grids", key)) continue;
        if (time_is_up()) return;
        put("grids", key, {{"points", sweep(of, points, gap, digits, 0, {{RC_OPT_KERNEL, kernel}}, {{"true_", &on_grid}})}});
      }
    }
  }

  // One method from loose tolerances to tight ones, each solve in a process of its own.
  Json sweep(const ParetoCase& of, std::int64_t n, const Field& gap, const std::vector<int>& digits, double least_tol,
             const Settings& settings, const std::vector<Against>& truths) {
    malloc_trim(0);  // so that the memory of a solve counts and is not taken from what an earlier one left
    Json points = Json::array();
    double spent = 0;
    for (const int k : digits) {
      const double tol = power_of_ten(k);
      if (tol < least_tol || spent > request_.method_limit) break;
      Json point = {{"tol", tol}};
      point.update(in_child([&] {
        Options options;
        options.set(settings).set(RC_OPT_TOL, tol).set(RC_OPT_THREADS, static_cast<double>(request_.threads));
        options.set(RC_OPT_TIME_LIMIT, request_.solve_limit);
        return solve_and_compare(of, n, gap, options, request_.budget, truths);
      }));
      points.push_back(point);
      ++measured_;
      if (point.contains("error")) {
        ++failed_;
        break;
      }
      spent += total_seconds(point);
      if (point.at("status") == rc_status_name(RC_STOP_TIME)) break;
    }
    return points;
  }

  const ParetoRequest request_;
  ResultFile file_;
  const std::string library_;
  ParetoExports exports_{request_.export_folder};
  const Clock::time_point begun_ = Clock::now();
  int measured_ = 0, failed_ = 0, before_ = 0, left_ = 0;
};

}  // namespace

void run_pareto(const ParetoRequest& request) {
  Pareto pareto(request);
  pareto.run();
  pareto.finish();
}

}  // namespace bench
