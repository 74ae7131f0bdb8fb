// Figures 10 and 11: surfaces with and without a power-law spectrum, measured and generated, and what the cascade makes of them.
#include <roughcontact/surface.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "cascade.h"
#include "failure_run.h"
#include "measured_surface.h"
#include "paper.h"
#include "rough_surface.h"

namespace bench {

namespace {

// Below the folder of measured surfaces.
constexpr const char* measured[] = {"measured/afm_selfaffine_10um.gsf", "measured/afm_film_10um.gsf",
                                    "measured-lgpl/fv_rubber_2mm.gsf", "measured-lgpl/fv_skibase_4mm.gsf"};

constexpr double side = 100e-6, generated_rms = 1e-6;  // of generated surfaces [m]
constexpr std::int64_t coarsest_side = 64;             // of the cascade, the paper's

void require(rc_status status) {
  if (status != RC_OK) throw Failure(rc_surface_last_error());
}

MeasuredSurface generated(const SurfaceClass& surface, std::int64_t n) {
  MeasuredSurface result;
  result.name = surface.name;
  result.nx = result.ny = n;
  result.hx = result.hy = side / static_cast<double>(n);
  result.heights = surface.heights(n, 1);
  for (double& height : result.heights) height *= generated_rms;
  return result;
}

// Spectrum, what it is like, and the heights along the middle row less their mean.
Json spectrum_of(const MeasuredSurface& surface, bool periodic) {
  rc_surface_map map = RC_SURFACE_MAP_INIT;
  map.nx = surface.nx;
  map.ny = surface.ny;
  map.hx = surface.hx;
  map.hy = surface.hy;
  map.heights = surface.heights.data();
  map.periodic = periodic;
  std::int64_t rings = 0;
  require(rc_surface_psd(&map, nullptr, nullptr, nullptr, &rings));
  std::vector<double> q(static_cast<std::size_t>(rings)), psd(q.size());
  std::vector<std::int64_t> modes(q.size());
  require(rc_surface_psd(&map, q.data(), psd.data(), modes.data(), &rings));
  rc_surface_power_law law{};
  law.struct_size = sizeof law;
  require(rc_surface_fit(&map, &law));
  rc_surface_statistics statistics{};
  statistics.struct_size = sizeof statistics;
  require(rc_surface_analyze(&map, &statistics));
  const auto row = surface.heights.begin() + surface.ny / 2 * surface.nx;
  Field profile(row, row + surface.nx);
  const double mean = mean_of(profile);
  for (double& height : profile) height -= mean;
  return {{"nx", surface.nx},
          {"ny", surface.ny},
          {"hx", surface.hx},
          {"hy", surface.hy},
          {"rms_height", statistics.rms_height},
          {"rms_slope", statistics.rms_slope},
          {"hurst", law.hurst},
          {"hurst_error", law.hurst_error},
          {"slope", law.slope},
          {"prefactor", law.prefactor},
          {"q_min", law.q_min},
          {"q_max", law.q_max},
          {"q_rolloff", law.q_rolloff},
          {"q_cutoff", law.q_cutoff},
          {"textures", law.peaks},
          {"q", q},
          {"psd", psd},
          {"profile", profile}};
}

std::int32_t halvings_of(const MeasuredSurface& surface) {
  std::int32_t halvings = 0;
  while (std::min(surface.nx, surface.ny) >> (halvings + 1) >= coarsest_side) ++halvings;
  return halvings;
}

// At an approach of the highest point's height over `part`.
Json cascades(const MeasuredSurface& surface, double part, std::int64_t threads) {
  const Settings common = {{RC_OPT_BOUNDS, "0"}, {RC_OPT_THREADS, std::to_string(threads)}};
  const auto run = [&](const Scene& scene, Settings settings) {
    settings.insert(settings.end(), common.begin(), common.end());
    Solved solved = solve(scene, settings);
    if (solved.status < 0) throw Failure(solved.message);
    return solved;
  };
  Scene scene = scene_of(surface);
  scene.approach = mean_of(scene.gap) / part;
  const std::int32_t halvings = halvings_of(surface);
  const CmrVerdict verdict = cmr_verdict(scene, halvings);
  const Solved whole = run(scene, {{"solver", "polonsky-keer"}, {"backend", "fft"}});
  if (whole.status != RC_OK) throw Failure(whole.message);
  Json rows = Json::array();
  for (const char* filter : {"subsample", "mean", "max"}) {
    const Cascade cascade{.filter = filter, .radius = 1.5, .levels = halvings + 1};
    const Solved plain = run(scene, settings_of(cascade, false)), certified = run(scene, settings_of(cascade, true));
    const CascadeNote note = cascade_note(certified.result.note);
    rows.push_back({{"part", part},
                    {"filter", filter},
                    {"halvings", halvings},
                    {"load_error", plain.result.load / whole.result.load - 1},
                    {"status", plain.name()},
                    {"kept", note.share_at_first()},
                    {"certified_error", certified.result.load / whole.result.load - 1},
                    {"certified_status", certified.name()},
                    {"rounds", note.rounds},
                    {"candidates", whole.result.candidates},
                    {"contacts", whole.result.contacts},
                    {"cpu_seconds", plain.cpu_seconds},
                    {"certified_cpu_seconds", certified.cpu_seconds},
                    {"whole_cpu_seconds", whole.cpu_seconds},
                    {"unresolved", verdict.unresolved},
                    {"trustworthy", verdict.trustworthy}});
  }
  return rows;
}

Json measure(const MeasuredSurface& surface, bool periodic, std::int64_t threads) {
  Json row = spectrum_of(surface, periodic), cases = Json::array();
  for (const double part : {5.0, 2.0})  // the paper's, and that of its section 4
    for (const Json& entry : cascades(surface, part, threads)) cases.push_back(entry);
  row["cases"] = cases;
  return row;
}

}  // namespace

void plan_figure_10(const PaperRequest& request, Plan& plan) {
  const std::int64_t n = request.quick ? 128 : 512;
  const std::vector<SurfaceClass> classes = {
      {.name = "generated, power law", .hurst = 0.6},
      {.name = "generated, roll-off", .hurst = 0.6, .roll_off = static_cast<double>(n) / 10}};
  for (const SurfaceClass& surface : classes)
    plan.push_back({"figure_10",
                    {{"surface", surface.name}, {"origin", "generated"}},
                    request.quick ? 1.0 : 10.0,
                    [=, threads = request.threads] { return measure(generated(surface, n), true, threads); }});
  std::size_t found = 0;
  if (!request.surfaces.empty())
    for (const char* file : measured) {
      const std::filesystem::path path = std::filesystem::path(request.surfaces) / file;
      if (!std::filesystem::exists(path)) continue;
      ++found;
      plan.push_back({"figure_10",
                      {{"surface", path.stem().string()}, {"origin", "measured"}},
                      request.quick ? 8.0 : 20.0,
                      [=, threads = request.threads] { return measure(read_measured(path.string()), false, threads); }});
    }
  if (found == 0)
    std::cout << "no measured surfaces in \"" << request.surfaces
              << "\" (--surfaces): figures 10 and 11 show generated ones alone\n";
}

}  // namespace bench
