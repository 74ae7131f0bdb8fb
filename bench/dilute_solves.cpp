#include "dilute_solves.h"

#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <string>

#include "library.h"
#include "measurement.h"
#include "rough_surface.h"
#include "scene.h"
#include "table.h"

namespace bench {

namespace {

constexpr double rms_height = 0.02, hurst = 0.8, longest_waves = 12, shortest_wave = 0.33;  // waves a side; waves a cell
constexpr double asperity_area = 0.001;                                                     // share of the grid in contact
constexpr std::int64_t largest_search = 2048;  // points a side up to which the load for a contact area is searched

struct DiluteScene {
  std::string name;
  Field gap;
  double load = 0, approach = 0;
};

// The band of waves that ASPHER's authors press.
DiluteScene rough(std::int64_t n, std::uint64_t seed) {
  SurfaceClass band{.name = "rough", .hurst = hurst};
  band.shortest = longest_waves;
  band.longest = shortest_wave * static_cast<double>(n);
  DiluteScene scene{band.name, band.heights(n, seed)};
  double highest = scene.gap.front();
  for (const double height : scene.gap) highest = std::max(highest, height);
  for (double& value : scene.gap) value = rms_height * (highest - value);
  return scene;
}

DiluteScene asperity(std::int64_t n) {
  Hertz hertz;
  hertz.contact_radius = std::sqrt(asperity_area / std::numbers::pi);
  return {"asperity", hertz.gap(n), hertz.load(), hertz.approach()};
}

// Bush, Gibson & Thomas (1975): area = sqrt(2 pi) p / (E* rms slope).
double expected_load(const Field& gap, std::int64_t n, double area) {
  double square = 0;
  for (std::int64_t y = 0; y < n; ++y)
    for (std::int64_t x = 1; x < n; ++x) {
      const auto i = static_cast<std::size_t>(y * n + x);
      square += (gap[i] - gap[i - 1]) * (gap[i] - gap[i - 1]);
    }
  const double slope = static_cast<double>(n) * std::sqrt(2 * square / static_cast<double>(n * n));
  return area * slope / std::sqrt(2 * std::numbers::pi);
}

bool has_single_precision() {
  try {
    Options().set("fft.precision", "single");
    return true;
  } catch (const Failure&) {
    return false;
  }
}

Options options_of(const DiluteRequest& request, double tol) {
  Options options;
  options.set(RC_OPT_THREADS, static_cast<double>(request.threads)).set(RC_OPT_TOL, tol);
  static const bool single = has_single_precision();
  if (single && tol >= 1e-4) options.set("fft.precision", "single");
  return options;
}

// No pressures are asked for: they alone would be an array over all points. The gap came with the process.
Json run(const DiluteRequest& request, const Field& gap, std::int64_t n, rc_step step, const Options& options) {
  return in_child([&] {
    step.gap = gap.data();
    const TimedSolve timed = time_solve(unit_square(n), step, options, request.budget, nullptr);
    Json record = record_of(timed.result);
    record["contact_percent"] = 100 * static_cast<double>(timed.result.contacts) / static_cast<double>(n * n);
    record["setup_seconds"] = timed.setup_seconds;
    record["seconds"] = timed.setup_seconds + timed.result.seconds;
    record["cpu_seconds"] = timed.cpu_seconds;
    record["worst_kkt"] =
        std::max({timed.result.kkt_primal, timed.result.kkt_dual, timed.result.kkt_complementarity, timed.result.kkt_control});
    record["peak_megabytes"] = peak_memory() / 1e6;
    return record;
  });
}

// A solve by default options, and one over the whole grid where it is small enough.
class Solves {
 public:
  explicit Solves(const DiluteRequest& request) : request_(request) {}

  Json rows() && { return std::move(rows_); }

  void press(DiluteScene& scene, std::int64_t n, double area) {
    for (const std::string& control : request_.controls)
      for (const double tol : request_.tolerances) {
        rc_step step = RC_STEP_INIT;
        step.control = control == "load" ? RC_CONTROL_LOAD : RC_CONTROL_DISPLACEMENT;
        step.target = control == "load" ? scene.load : scene.approach;
        std::cerr << "solving " << scene.name << ", " << n << "^2, " << 100 * area << " %, " << control << ", " << tol << '\n';
        Json row = {{"scene", scene.name}, {"n", n},     {"area_wanted", area},
                    {"control", control},  {"tol", tol}, {"threads", request_.threads}};
        const Json own = run(request_, scene.gap, n, step, options_of(request_, tol));
        row["auto"] = own;
        if (n <= request_.largest_full) {
          row["fft"] = over_the_whole_grid(scene, n, step, tol);
          if (!own.contains("error") && !row["fft"].contains("error"))
            row["ratio"] = row["fft"]["seconds"].get<double>() / own["seconds"].get<double>();
        }
        rows_.push_back(std::move(row));
      }
  }

  // Load and approach that bring about a share `area` of the surface into contact, from loose solves; on large grids with what
  // the last smaller one taught.
  void find_load(DiluteScene& scene, std::int64_t n, double area) {
    constexpr double loose = 1e-2;
    const double expected = expected_load(scene.gap, n, area);
    double& correction = corrections_.try_emplace(area, 1.0).first->second;
    Json found;
    const auto solve = [&] {
      rc_step step = RC_STEP_INIT;
      step.control = RC_CONTROL_LOAD;
      step.target = scene.load = correction * expected;
      found = run(request_, scene.gap, n, step, options_of(request_, loose));
      if (found.contains("error")) throw Failure(found["error"].get<std::string>());
      scene.approach = found["displacement"];
    };
    solve();
    for (int k = 0; k < 3 && n <= largest_search; ++k) {
      const double percent = found["contact_percent"];
      if (std::abs(percent / (100 * area) - 1) < 0.1) break;
      correction *= percent > 0 ? std::clamp(100 * area / percent, 0.2, 5.0) : 5.0;
      solve();
    }
  }

 private:
  // backend fft works on the box of the points that may touch. A point in each corner that is a candidate by a millionth of the
  // approach, and stays apart under the deflection there, makes this box the grid.
  Json over_the_whole_grid(DiluteScene& scene, std::int64_t n, const rc_step& step, double tol) const {
    Options options = options_of(request_, tol);
    options.set(RC_OPT_BACKEND, "fft").set(RC_OPT_SOLVER, "haar-cg");
    const auto last = static_cast<std::size_t>(n * n - 1), right = static_cast<std::size_t>(n - 1);
    const std::size_t corners[] = {0, right, last - right, last};
    double kept[4];
    for (int k = 0; k < 4; ++k) {
      kept[k] = scene.gap[corners[k]];
      scene.gap[corners[k]] = std::min(kept[k], scene.approach * (1 - 1e-6));
    }
    Json answer = run(request_, scene.gap, n, step, options);
    for (int k = 0; k < 4; ++k) scene.gap[corners[k]] = kept[k];
    return answer;
  }

  const DiluteRequest& request_;
  std::map<double, double> corrections_;  // of the expected load, by contact area
  Json rows_ = Json::array();
};

const std::vector<Column> columns = {{"scene", "scene"},
                                     {"n", "n"},
                                     {"control", "control"},
                                     {"tol", "tol", "%.0e"},
                                     {"contact %", "contact_percent", "%.4f"},
                                     {"run", "run"},
                                     {"solver", "solver"},
                                     {"backend", "backend"},
                                     {"set-up s", "setup_seconds", "%.3f"},
                                     {"solve s", "solve_seconds", "%.3f"},
                                     {"CPU s", "cpu_seconds", "%.3f"},
                                     {"products", "products"},
                                     {"modelled", "modelled"},
                                     {"peak MB", "peak_megabytes"},
                                     {"worst KKT", "worst_kkt", "%.0e"},
                                     {"ratio", "ratio", "%.1f"},
                                     {"status", "status"}};

// One line for each run.
Json lines(const Json& rows) {
  Json all = Json::array();
  for (const Json& row : rows)
    for (const char* name : {"auto", "fft"}) {
      if (!row.contains(name)) continue;
      Json line = row.at(name);
      for (const char* key : {"scene", "n", "control", "tol"}) line[key] = row.at(key);
      line["run"] = name;
      if (std::string(name) == "fft" && row.contains("ratio")) line["ratio"] = row.at("ratio");
      all.push_back(std::move(line));
    }
  return all;
}

}  // namespace

Json dilute_solves(const DiluteRequest& request) {
  Solves solves(request);
  for (const std::int64_t n : request.sizes) {
    {
      DiluteScene scene = rough(n, request.seed);
      for (const double area : request.contacts) {
        solves.find_load(scene, n, area);
        solves.press(scene, n, area);
      }
    }
    DiluteScene scene = asperity(n);
    solves.press(scene, n, asperity_area);
  }
  Json rows = std::move(solves).rows();
  std::cout
      << "Cold solves: auto, all options at their defaults; fft, backend fft and haar-cg over the whole grid (a candidate in\n"
         "each corner keeps it from working on a box around the contact), up to "
      << request.largest_full
      << " points a side. ratio: seconds of fft\n"
         "over those of auto, with set-up. peak: of the process, with the gap\n"
      << table(columns, lines(rows));
  return rows;
}

}  // namespace bench
