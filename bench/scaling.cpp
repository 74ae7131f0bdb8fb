#include "scaling.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "format.h"
#include "library.h"
#include "measurement.h"
#include "process_memory.h"
#include "product_timer.h"
#include "provenance.h"
#include "result_file.h"
#include "scene.h"
#include "stopwatch.h"
#include "table.h"

namespace bench {

namespace {

constexpr std::int64_t largest_search = 2048;   // points a side up to which the load for a contact area is searched
constexpr std::int64_t largest_profile = 4096;  // and up to which products are timed by themselves
constexpr std::int64_t first_of_growth = 512;
constexpr double gigabyte = 1e9;

SelfAffine surface_of(const ScalingRequest& request) {
  SelfAffine surface;
  surface.seed = request.seed;
  return surface;
}

Options options_of(const ScalingRequest& request, double tol) {
  Options options;
  options.set(RC_OPT_SOLVER, request.solver).set(RC_OPT_BACKEND, request.backend);
  options.set(RC_OPT_THREADS, static_cast<double>(request.threads)).set(RC_OPT_TOL, tol);
  if (request.precision != "mixed") options.set("fft.precision", request.precision);
  return options;
}

// Load that brings a share `area` of the surface into contact, from load ~ area at first, and the approach under it. Solves
// loosely, in load control, at most `most_solves` times.
Json find_load(const ScalingRequest& request, std::int64_t n, const Field& gap, double area, double guess, int most_solves) {
  constexpr double near_enough = 0.03, loose = 1e-3;
  Contact contact(unit_square(n), options_of(request, loose));
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_LOAD;
  step.target = guess;
  double slope = 1, last_area = 0, last_load = 0;  // slope: d log load / d log area
  rc_result result{};
  for (int solves = 0; solves < most_solves; ++solves) {
    step.gap = solves == 0 ? gap.data() : nullptr;
    result = contact.solve(step);
    const double found = static_cast<double>(result.contacts) / static_cast<double>(result.points);
    if (found == 0) {
      step.target *= 2;
      continue;
    }
    if (std::abs(found / area - 1) <= near_enough) break;
    if (last_area > 0 && found != last_area)
      slope = std::clamp(std::log(step.target / last_load) / std::log(found / last_area), 0.5, 3.0);
    last_area = found;
    last_load = step.target;
    step.target *= std::pow(area / found, slope);
  }
  return {{"load", result.load}, {"displacement", result.displacement}};
}

// Contact below which no array of pressures over all points is asked for: rc_contact_points has them.
constexpr double sparse_area = 0.01;

// One row: a cold solve, its peak memory, then the product on the same trial set. The gap came with the process.
Json measure_solve(const ScalingRequest& request, std::int64_t n, double area, const Field& gap, rc_step step) {
  step.gap = gap.data();
  const rc_system system = unit_square(n);
  Field pressure(area < sparse_area ? 0 : gap.size());
  const double before = resident_memory();
  const TimedSolve timed =
      time_solve(system, step, options_of(request, request.tol), request.budget, pressure.empty() ? nullptr : pressure.data());
  const double peak = std::max(peak_memory(), before);

  const double points = static_cast<double>(timed.result.points);
  Json row = record_of(timed.result);
  row["area_found"] = static_cast<double>(timed.result.contacts) / points;
  row["setup_seconds"] = timed.setup_seconds;
  row["cpu_seconds"] = timed.cpu_seconds;
  row["repeats"] = timed.repeats;
  row["peak_bytes"] = peak;
  row["bytes_per_point"] = (peak - before) / points;
  row["bytes_per_point_in_all"] = peak / points;
  if (n > largest_profile || timed.result.status != RC_OK) return row;

  step.control = RC_CONTROL_DISPLACEMENT;
  step.target = timed.result.displacement;
  ProductSetup setup;
  setup.backend = timed.result.backend;
  setup.threads = request.threads;
  setup.budget = request.budget / 4;
  const CallTimes product = time_products(system, step, setup);
  row["product_seconds_best"] = product.best;
  row["product_seconds_median"] = product.median;
  row["product_count"] = product.count;
  return row;
}

class Scaling {
 public:
  explicit Scaling(const ScalingRequest& request)
      : request_(request), file_(request.file, "scaling", request.threads), library_(library_hash()) {}

  void run() {
    for (const std::int64_t n : request_.sizes) {
      gap_.clear();
      for (const double area : request_.areas)
        for (const std::string& control : request_.controls)
          if (!row(n, area, control)) return;
    }
  }

  Json rows() {
    Json chosen = Json::array();
    for (const Json& row : file_.document()["solves"])
      if (wanted(row)) chosen.push_back(row);
    std::stable_sort(chosen.begin(), chosen.end(), [](const Json& a, const Json& b) { return a.at("n") < b.at("n"); });
    return chosen;
  }

  // Least squares of log products over log n, for every area and control with two sizes or more.
  Json growth() {
    Json found = Json::array();
    for (const double area : request_.areas)
      for (const std::string& control : request_.controls) {
        double n = 0, x = 0, y = 0, xx = 0, xy = 0;
        for (const Json& row : rows())
          if (row.at("area_wanted") == area && row.at("control") == control && row.at("n") >= first_of_growth &&
              row.value("status", "") == "RC_OK") {
            const double a = std::log(row.at("n").get<double>()), b = std::log(row.at("products").get<double>());
            n += 1;
            x += a;
            y += b;
            xx += a * a;
            xy += a * b;
          }
        const double spread = n * xx - x * x;
        if (n < 2 || spread <= 0) continue;
        Json entry = settings();
        entry.update(
            {{"area_wanted", area}, {"control", control}, {"from", first_of_growth}, {"exponent", (n * xy - x * y) / spread}});
        found.push_back(entry);
      }
    file_.document()["growth"] = found;
    file_.save();
    return found;
  }

 private:
  Json settings() const {
    return {{"tol", request_.tol},   {"precision", request_.precision},  {"threads", request_.threads},
            {"seed", request_.seed}, {"solver_option", request_.solver}, {"backend_option", request_.backend}};
  }
  Json key(std::int64_t n, double area, const std::string& control) const {
    Json values = {{"n", n}, {"area_wanted", area}, {"control", control}};
    values.update(settings());
    return values;
  }
  bool wanted(const Json& row) const {
    const Json values = settings();
    return std::all_of(values.items().begin(), values.items().end(),
                       [&](const auto& item) { return row.contains(item.key()) && row.at(item.key()) == item.value(); });
  }

  const Field& gap(std::int64_t n) {
    if (gap_.size() != static_cast<std::size_t>(n * n)) gap_ = self_affine_gap(n, surface_of(request_));
    return gap_;
  }

  // The load for an area, and for displacement control the approach under it. Found once, on a grid that is not too fine, and
  // kept with the results: no measurement.
  Json load_for(std::int64_t n, double area, bool approach) {
    if (n > largest_search && !approach) return load_for(largest_search, area, false);
    const Json values = {{"n", n}, {"area_wanted", area}, {"seed", request_.seed}};
    if (const Json* const known = file_.find("loads", values)) return *known;
    // Bush, Gibson & Thomas (1975): area = sqrt(2 pi) p / (E* rms slope) at light loads; a coarser grid's answer is better.
    double guess = area / std::sqrt(2 * std::numbers::pi) * surface_of(request_).rms_slope;
    if (n > largest_search) {
      guess = load_for(largest_search, area, false).at("load");
    } else {
      std::int64_t finest = 0;
      for (const Json& other : file_.document()["loads"])
        if (other.at("area_wanted") == area && other.at("seed") == request_.seed && other.at("n") < n && other.at("n") > finest) {
          guess = other.at("load");
          finest = other.at("n");
        }
    }
    Json found = values;
    const int most = n > largest_search ? 1 : 6;
    found.update(in_child([&, &field = gap(n)] { return find_load(request_, n, field, area, guess, most); }));
    if (found.contains("error")) throw Failure(found.at("error").get<std::string>());
    file_.put("loads", values, found);
    return found;
  }

  // What a solve of a finer grid needs if it takes as much a point as the finest grid so far, its gap included; 0 where unknown.
  double needed(std::int64_t n, double area, const std::string& control) {
    double bytes = 0;
    std::int64_t finest = 0;
    for (const Json& row : rows())
      if (row.at("area_wanted") == area && row.at("control") == control && row.contains("peak_bytes") && row.at("n") > finest) {
        finest = row.at("n");
        bytes = row.at("bytes_per_point_in_all").get<double>() * static_cast<double>(n * n);
      }
    return bytes;
  }

  // False where the time is up.
  bool row(std::int64_t n, double area, const std::string& control) {
    const Json values = key(n, area, control);
    Json of_this_library = values;
    of_this_library["library"] = library_;
    const std::string name = formatted("%lld^2, %g %%, %s control", static_cast<long long>(n), 100 * area, control.c_str());
    if (const Json* const old = file_.find("solves", of_this_library); old && !old->contains("error")) {
      std::cerr << name << ": measured before\n";
      return true;
    }
    if (request_.time_limit > 0 && seconds_since(begun_) > request_.time_limit) {
      std::cerr << name << ": not begun, the time is up\n";
      return false;
    }
    const double present = 8 * static_cast<double>(gap_.size()), available = available_memory() + present;
    const double points = static_cast<double>(n * n);
    // The gap and an in-place transform of it at least.
    const double least = std::max(needed(n, area, control), 16 * points);
    if (least > available) {
      std::cerr << name
                << formatted(": left out: it needs about %.1f GB, %.1f GB are there\n", least / gigabyte, available / gigabyte);
      return true;
    }
    rc_step step = RC_STEP_INIT;
    const bool by_load = control == "load";
    const Json found = load_for(n, area, !by_load);
    step.control = by_load ? RC_CONTROL_LOAD : RC_CONTROL_DISPLACEMENT;
    step.target = found.at(by_load ? "load" : "displacement");
    Json measured = of_this_library;
    measured.update(in_child([&, &field = gap(n)] {
      if (100 * points > available) limit_growth(available_memory());
      return measure_solve(request_, n, area, field, step);
    }));
    if (measured.contains("error"))
      std::cerr << name << ": " << measured.at("error").get<std::string>() << '\n';
    else
      std::cerr << name
                << formatted(": %.3g s, %d products, %.0f bytes/point\n",
                             measured.at("setup_seconds").get<double>() + measured.at("solve_seconds").get<double>(),
                             measured.at("products").get<int>(), measured.at("bytes_per_point").get<double>());
    file_.put("solves", values, measured);
    return true;
  }

  const ScalingRequest request_;
  ResultFile file_;
  const std::string library_;
  const Clock::time_point begun_ = Clock::now();
  Field gap_;  // of one size at a time
};

const std::vector<Column> columns = {{"n", "n"},
                                     {"area", "area_found", "%.4f"},
                                     {"control", "control"},
                                     {"solver", "solver"},
                                     {"backend", "backend"},
                                     {"set-up s", "setup_seconds", "%.4f"},
                                     {"solve s", "solve_seconds", "%.4f"},
                                     {"CPU s", "cpu_seconds", "%.4f"},
                                     {"iterations", "iterations"},
                                     {"products", "products"},
                                     {"product s", "product_seconds_best", "%.5f"},
                                     {"B/point", "bytes_per_point"},
                                     {"in all", "bytes_per_point_in_all"},
                                     {"candidates", "candidates"},
                                     {"modelled", "modelled"},
                                     {"contacts", "contacts"},
                                     {"primal", "kkt_primal", "%.0e"},
                                     {"dual", "kkt_dual", "%.0e"},
                                     {"compl.", "kkt_complementarity", "%.0e"},
                                     {"load", "kkt_control", "%.0e"},
                                     {"status", "status"}};

}  // namespace

void run_scaling(const ScalingRequest& request) {
  options_of(request, request.tol);  // what the library refuses, it refuses before anything is measured
  Scaling scaling(request);
  scaling.run();
  std::cout << "Cold solves to a certified tolerance of " << request.tol << ", precision " << request.precision << ", "
            << request.threads << " threads\n"
            << table(columns, scaling.rows());
  for (const Json& entry : scaling.growth())
    std::cout << formatted("products at %g %%, %s control, from %lld^2 on: N^%.2f, N points a side\n",
                           100 * entry.at("area_wanted").get<double>(), entry.at("control").get<std::string>().c_str(),
                           static_cast<long long>(first_of_growth), entry.at("exponent").get<double>());
}

}  // namespace bench
