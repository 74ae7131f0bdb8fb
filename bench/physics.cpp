#include "physics.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "format.h"
#include "library.h"
#include "measurement.h"
#include "physics_summary.h"
#include "provenance.h"
#include "result_file.h"
#include "rough_surface.h"
#include "table.h"

namespace bench {

namespace {

constexpr double rms_slope = 0.1;
constexpr std::int64_t bins = 50;
constexpr double highest_pressure = 2;  // end of the histograms, over E* rms slope

// One surface on one grid, pressed by growing loads. E*, the side and with it the nominal area are 1.
class Pressed {
 public:
  Pressed(const PhysicsRequest& request, std::int64_t n, std::uint64_t seed, bool stiffness)
      : system_(periodic_square(n)),
        gap_(self_affine_gap(n, {seed, request.hurst, request.roll_off, request.cut_off, rms_slope})),
        p_(gap_.size()),
        contact_(system_, options_of(request, stiffness)),
        stiffness_(stiffness) {
    double squares = 0;
    for (const double value : gap_) squares += value * value;
    mean_ = mean_of(gap_);
    rms_height_ = std::sqrt(squares / static_cast<double>(gap_.size()) - mean_ * mean_);
  }

  Json at(double pressure, bool distributions) {
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_LOAD;
    step.target = pressure * rms_slope;
    step.borrow = 1;
    step.gap = gap_.data();
    const rc_result result = contact_.solve(step, p_.data());
    Json row = record_of(result);
    rc_area area;
    rc_area_init(&area);
    check(rc_area_measure(&system_, p_.data(), nullptr, &area));
    row.update({{"area", area.area},
                {"corrected_area", area.corrected_area},
                {"perimeter", area.perimeter},
                {"mean_gap", (mean_ - result.displacement) / rms_height_}});
    // Over E* times slope and nominal area, as the pressure is.
    if (stiffness_ && std::isfinite(result.stiffness)) row["stiffness"] = result.stiffness * rms_height_ / rms_slope;
    add_patches(row, distributions);
    if (distributions) add_histogram(row, area.area);
    return row;
  }

 private:
  static rc_system periodic_square(std::int64_t n) {
    rc_system system = unit_square(n);
    system.boundary = RC_BOUNDARY_PERIODIC;
    return system;
  }
  static Options options_of(const PhysicsRequest& request, bool stiffness) {
    Options options;
    options.set(RC_OPT_TOL, request.tol).set(RC_OPT_THREADS, static_cast<double>(request.threads));
    options.set(RC_OPT_STIFFNESS, stiffness ? "1" : "0");
    return options;
  }

  void add_patches(Json& row, bool distribution) const {
    rc_patches patches = RC_PATCHES_INIT;
    check(rc_patches_find(&system_, p_.data(), nullptr, &patches));
    std::vector<std::int64_t> cells(static_cast<std::size_t>(patches.count));
    patches.room = patches.count;
    patches.cells = cells.data();
    check(rc_patches_find(&system_, p_.data(), nullptr, &patches));
    std::int64_t all = 0, largest = 0;
    std::vector<std::int64_t> octaves;  // patches of 2^k .. 2^(k+1) - 1 cells
    for (const std::int64_t each : cells) {
      all += each;
      largest = std::max(largest, each);
      const auto k = static_cast<std::size_t>(std::ilogb(static_cast<double>(each)));
      if (octaves.size() <= k) octaves.resize(k + 1, 0);
      ++octaves[k];
    }
    row["patches"] = patches.count;
    row["largest_patch"] = all > 0 ? static_cast<double>(largest) / static_cast<double>(all) : 0;
    if (distribution) row["patch_octaves"] = octaves;
  }

  // Density over all points, per pressure over E* rms slope.
  void add_histogram(Json& row, double area) const {
    Field density(bins);
    rc_histogram histogram = RC_HISTOGRAM_INIT;
    histogram.bins = bins;
    histogram.upper = highest_pressure * rms_slope;
    histogram.density = density.data();
    check(rc_histogram_fill(&system_, p_.data(), nullptr, &histogram));
    for (double& value : density) value *= area * rms_slope;
    row["histogram"] = {{"width", histogram.width / rms_slope}, {"above", histogram.above}, {"density", density}};
  }

  const rc_system system_;
  const Field gap_;
  Field p_;
  Contact contact_;
  const bool stiffness_;
  double mean_ = 0, rms_height_ = 0;
};

class Physics {
 public:
  explicit Physics(const PhysicsRequest& request)
      : request_(request), file_(request.file, "physics", request.threads), library_(library_hash()) {}

  void run() {
    for (const std::uint64_t seed : request_.seeds) solve(request_.points, seed, request_.pressures);
    for (const std::int64_t n : request_.sizes)
      for (std::size_t k = 0; k < request_.seeds.size() && static_cast<std::int64_t>(k) < request_.mesh_seeds; ++k)
        solve(n, request_.seeds[k], request_.mesh_pressures);
  }

  PhysicsSummary summary() {
    Json rows = Json::array();
    const Json wanted = settings();
    for (const Json& row : file_.document()["rows"])
      if (std::all_of(wanted.items().begin(), wanted.items().end(),
                      [&](const auto& item) { return row.contains(item.key()) && row.at(item.key()) == item.value(); }))
        rows.push_back(row);
    PhysicsSummary found = summary_of(rows, request_);
    Json& document = file_.document();
    document["surface"] = settings();
    document["surface"]["points"] = request_.points;
    document["curve"] = found.curve;
    document["fits"] = found.fits;
    document["meshes"] = found.meshes;
    file_.save();
    return found;
  }

 private:
  Json settings() const {
    return {{"hurst", request_.hurst}, {"roll_off", request_.roll_off}, {"cut_off", request_.cut_off}, {"tol", request_.tol}};
  }

  void solve(std::int64_t n, std::uint64_t seed, const std::vector<double>& pressures) {
    std::unique_ptr<Pressed> pressed;
    for (const double pressure : pressures) {
      Json values = {{"n", n}, {"seed", seed}, {"pressure", pressure}};
      values.update(settings());
      Json row = values;
      row["library"] = library_;
      const bool of_curve = n == request_.points;
      const bool distributions =
          of_curve && std::find(request_.shown.begin(), request_.shown.end(), pressure) != request_.shown.end();
      const std::string name = formatted("%lld^2, surface %llu, p/(E* slope) = %g", static_cast<long long>(n),
                                         static_cast<unsigned long long>(seed), pressure);
      if (file_.find("rows", row)) {
        std::cerr << name << ": measured before\n";
        continue;
      }
      if (!pressed) pressed = std::make_unique<Pressed>(request_, n, seed, of_curve);
      row.update(pressed->at(pressure, distributions));
      file_.put("rows", values, row);
      std::cerr << name
                << formatted(": %.4f in contact, %.3g s\n", row.at("area").get<double>(), row.at("solve_seconds").get<double>());
    }
  }

  const PhysicsRequest request_;
  ResultFile file_;
  const std::string library_;
};

const std::vector<Column> curve_columns = {{"p/(E* slope)", "pressure", "%g"},      {"A/A0", "area", "%.5f"},
                                           {"corrected", "corrected_area", "%.5f"}, {"Persson", "persson", "%.5f"},
                                           {"mean gap/rms", "mean_gap", "%.3f"},    {"K rms/(E* slope)", "stiffness", "%.4g"},
                                           {"p/(K rms)", "decay", "%.3f"},          {"patches", "patches"},
                                           {"largest", "largest_patch", "%.3f"},    {"surfaces", "surfaces"}};
const std::vector<Column> mesh_columns = {{"p/(E* slope)", "pressure", "%g"},       {"n", "n"},
                                          {"cells a wave", "cells_a_wave", "%g"},   {"A/A0", "area", "%.5f"},
                                          {"corrected", "corrected_area", "%.5f"},  {"error", "raw_error", "%+.2e"},
                                          {"corrected", "corrected_error", "%+.2e"}};

std::string fit_line(const char* what, const Json& fit) {
  return formatted("%s: %.3f (%.3f to %.3f)\n", what, fit.at("mean").get<double>(), fit.at("lowest").get<double>(),
                   fit.at("highest").get<double>());
}

}  // namespace

void run_physics(const PhysicsRequest& request) {
  std::vector<std::int64_t> grids = request.sizes;
  grids.push_back(request.points);
  for (const std::int64_t n : grids)
    if (2 * request.cut_off >= static_cast<double>(n))
      throw Failure(formatted("a wave of 1/%g of the side needs more than two cells, a grid of %lld^2 has fewer", request.cut_off,
                              static_cast<long long>(n)));
  Physics physics(request);
  physics.run();
  const PhysicsSummary summary = physics.summary();
  std::cout << "Periodic self-affine surfaces on " << request.points << "^2 points, mean of the surfaces\n"
            << table(curve_columns, summary.curve);
  if (!summary.fits.empty())
    std::cout << fit_line("kappa, raw", summary.fits.at("kappa"))
              << fit_line("kappa, corrected", summary.fits.at("corrected_kappa"))
              << fit_line("u0/rms height by the gap", summary.fits.at("decay"))
              << fit_line("u0/rms height by the stiffness", summary.fits.at("stiffness_decay"));
  std::cout << "The same surfaces on several grids; errors against the raw areas of the two finest, extrapolated\n"
            << table(mesh_columns, summary.meshes);
}

}  // namespace bench
