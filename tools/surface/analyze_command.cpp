#include "surface/analyze_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "files/json_text.h"
#include "files/outputs.h"
#include "formats/error.h"
#include "formats/numbers.h"
#include "library.h"
#include "pictures/picture_file.h"
#include "pictures/spectrum.h"
#include "platform/files.h"
#include "request/quantities.h"
#include "request/units.h"
#include "solve/problem.h"
#include "surface/analysis.h"
#include "surface/check.h"
#include "text.h"

namespace cli {

namespace {

constexpr std::int64_t usual_levels = 4;  // from 256 to 16 points a side, as in the paper

std::int64_t halvings(const Pressed& surface, const std::optional<std::string>& text) {
  if (text) {
    const auto levels = to_integer(*text);
    if (!levels || *levels < 1 || *levels > 60) throw Error("--levels: ", in_quotes(*text), " is not a whole number from 1 on");
    return *levels;
  }
  std::int64_t levels = 0;
  for (std::int64_t n = std::max(surface.nx, surface.ny); levels < usual_levels && (n + 1) / 2 >= 4; n = (n + 1) / 2) ++levels;
  return levels;
}

Rings radial_spectrum(const rc_surface_map& map, const std::string& file) {
  std::int64_t count = 0;
  check_surface(rc_surface_psd(&map, nullptr, nullptr, nullptr, &count), file);
  const auto size = static_cast<std::size_t>(count);
  Rings rings{std::vector<double>(size), std::vector<double>(size), std::vector<std::int64_t>(size)};
  check_surface(rc_surface_psd(&map, rings.q.data(), rings.psd.data(), rings.modes.data(), &count), file);
  return rings;
}

// The fit also refuses a flat map, but does not report whether it is level or tilted.
void refuse_flat(const Analysis& a) {
  if (a.statistics.m0 > 0) return;
  const std::span<const double> z = a.input.surface.heights;
  const bool level = std::ranges::all_of(z, [&z](double height) { return height == z.front(); });
  const char* const after = level ? "" : a.periodic ? " after its mean is removed" : " after its plane is removed";
  throw Error(a.input.file, ": the map is flat", after, ": it has no roughness to judge");
}

Analysis make_analysis(const AnalyzeArguments& arguments) {
  Analysis a{};
  const auto& unit = arguments.words["unit"];
  const double metres = length_unit("--unit", unit ? unit->c_str() : nullptr);
  const double approach =
      arguments.approach ? read_positive("--approach", *arguments.approach, Dimension::length, metres).si() : 0;
  a.input = input_of(arguments.words, make_request(arguments.words, RC_CALL_ANALYZE));
  const std::int32_t boundary = problem_of(a.input.request).system.boundary;
  a.periodic = boundary == RC_BOUNDARY_PERIODIC;
  if (boundary > RC_BOUNDARY_PERIODIC)
    throw Error("--boundary: ", name_of_boundary(boundary),
                " is for contacts; spectra repeat along both axes or none, give periodic or free");

  const Pressed& surface = a.input.surface;
  auto map = on_grid(surface.nx, surface.ny, surface.hx, surface.hy, rc_surface_map RC_SURFACE_MAP_INIT);
  map.heights = a.input.surface.heights.data();
  map.periodic = a.periodic ? 1 : 0;
  a.statistics = RC_SURFACE_STATISTICS_INIT;
  check_surface(rc_surface_analyze(&map, &a.statistics), a.input.file);
  refuse_flat(a);
  a.law = RC_SURFACE_POWER_LAW_INIT;
  check_surface(rc_surface_fit(&map, &a.law), a.input.file);
  a.rings = radial_spectrum(map, a.input.file);
  if (const std::int64_t levels = halvings(a.input.surface, arguments.levels); levels > 0) {
    a.cmr = RC_SURFACE_CMR_INIT;
    check_surface(rc_surface_cmr_advice(&map, static_cast<int32_t>(levels), approach, &*a.cmr), a.input.file);
  }
  return a;
}

std::string length_text(double metres) {
  if (!std::isfinite(metres)) return "none";
  return with_prefix(metres, "m", 4);
}

void row(const char* name, const std::string& value) { std::printf("  %-34s %s\n", name, value.c_str()); }
void row(const char* name, double value) { row(name, std::isfinite(value) ? format("%.5g", value) : "none"); }

void print_statistics(const rc_surface_statistics& s) {
  row("rms height Sq", length_text(s.rms_height));
  row("skewness Ssk", s.skewness);
  row("kurtosis Sku", s.kurtosis);
  row("highest, lowest point", length_text(s.highest) + ", " + length_text(s.lowest));
  row("rms slope", s.rms_slope);
  row("  along x, along y", format("%.5g, %.5g", s.rms_slope_x, s.rms_slope_y));
  row("rms mean curvature", s.rms_curvature > 0 ? "1/(" + length_text(1 / s.rms_curvature) + ")" : "0");
  row("spectral moments m0, m2, m4", format("%.5g m^2, %.5g, %.5g /m^2", s.m0, s.m2, s.m4));
  row("Nayak parameter m0 m4/m2^2", s.nayak);
}

// The direction of a wave, 0 .. 180 degrees: opposite directions are the same.
double degrees(double qx, double qy) { return std::fmod(std::atan2(qy, qx) * 180 / 3.14159265358979323846 + 360, 180); }

// Whether the Hurst exponent is in 0 .. 1, within its error.
bool self_affine(const rc_surface_power_law& law) { return law.hurst > -law.hurst_error && law.hurst < 1 + law.hurst_error; }

void print_spectrum(const rc_surface_power_law& law) {
  const bool found = std::isfinite(law.hurst);
  row("Hurst exponent", found ? format("%.3f +- %.3f (95 %%), PSD ~ q^%.3f%s", law.hurst, law.hurst_error, law.slope,
                                       self_affine(law) ? "" : ", not self-affine")
                              : "none: no power law over half a decade");
  if (found) row("  from wavelengths", length_text(wavelength(law.q_max)) + " to " + length_text(wavelength(law.q_min)));
  row("roll-off above wavelength", length_text(wavelength(law.q_rolloff)));
  row("cut-off below wavelength", length_text(wavelength(law.q_cutoff)));
  if (law.peaks == 0) row("periodic texture", std::string("none"));
  for (std::int64_t k = 0; k < law.peaks; ++k) {
    const double qx = law.peak_qx[k], qy = law.peak_qy[k];
    row(k == 0 ? "periodic texture" : "",
        format("%s at %.0f degrees to x, %.0f %% of the variance", length_text(wavelength(std::hypot(qx, qy))).c_str(),
               degrees(qx, qy), 100 * law.peak_share[k]));
  }
}

void print_advice(const Analysis& a) {
  if (!a.cmr) return row("cascade multi-resolution", std::string("no advice: too few points for a coarser grid"));
  row("cascade multi-resolution (cmr)", std::string(a.cmr->trustworthy ? "trustworthy" : "not trustworthy") +
                                            format(" with --levels %d, is with up to %d", a.cmr->levels, a.cmr->safe_levels));
  row("  approach judged", length_text(a.cmr->approach));
  row("  highest point cut off / approach", a.cmr->peak_loss);
  std::printf("  %s (lengths in m)\n", a.cmr->reason);
}

void print(const Analysis& a) {
  const char* const further = a.periodic ? ", periodic, mean removed" : a.input.removed == "plane" ? "" : ", plane removed";
  std::printf("surface %s, %lld x %lld points, pitch %s x %s%s%s\n",
              rc_platform::path_of(a.input.file).filename().string().c_str(), static_cast<long long>(a.input.surface.nx),
              static_cast<long long>(a.input.surface.ny), length_text(a.input.surface.hx).c_str(),
              length_text(a.input.surface.hy).c_str(), a.input.preparation().c_str(), further);
  print_statistics(a.statistics);
  print_spectrum(a.law);
  print_advice(a);
}

std::string document(const Analysis& a) {
  const rc_surface_statistics& s = a.statistics;
  const rc_surface_power_law& law = a.law;
  JsonText document;
  const auto object = [&document](const char* name, std::initializer_list<JsonField> fields) {
    document.begin(name);
    document.add(fields);
    document.end();
  };
  object("input", {{"file", a.input.file},
                   {"format", a.input.format},
                   {"nx", a.input.surface.nx},
                   {"ny", a.input.surface.ny},
                   {"hx", a.input.surface.hx},
                   {"hy", a.input.surface.hy},
                   {"removed", a.input.removed},
                   {"missing", a.input.missing},
                   {"missing_rule", a.input.missing_rule},
                   {"assumed", a.input.assumptions()},
                   {"periodic", a.periodic}});
  object("statistics", {{"rms_height", s.rms_height},
                        {"skewness", s.skewness},
                        {"kurtosis", s.kurtosis},
                        {"highest", s.highest},
                        {"lowest", s.lowest},
                        {"rms_slope", s.rms_slope},
                        {"rms_slope_x", s.rms_slope_x},
                        {"rms_slope_y", s.rms_slope_y},
                        {"rms_curvature", s.rms_curvature},
                        {"m0", s.m0},
                        {"m2", s.m2},
                        {"m4", s.m4},
                        {"nayak", s.nayak}});
  document.begin("spectrum");
  document.add({{"hurst", law.hurst},
                {"hurst_error", law.hurst_error},
                {"slope", law.slope},
                {"prefactor", law.prefactor},
                {"q_min", law.q_min},
                {"q_max", law.q_max},
                {"q_rolloff", law.q_rolloff},
                {"q_cutoff", law.q_cutoff}});
  document.begin("peaks", '[');
  for (std::int64_t k = 0; k < law.peaks; ++k)
    object(nullptr, {{"qx", law.peak_qx[k]}, {"qy", law.peak_qy[k]}, {"share", law.peak_share[k]}});
  document.end();
  document.end();
  document.begin("psd");
  document.add("q", a.rings.q);
  document.add("C", a.rings.psd);
  document.add("modes", a.rings.modes);
  document.end();
  if (a.cmr) {
    object("cmr", {{"trustworthy", a.cmr->trustworthy == 1},
                   {"levels", a.cmr->levels},
                   {"safe_levels", a.cmr->safe_levels},
                   {"unresolved", a.cmr->unresolved},
                   {"limit", a.cmr->limit},
                   {"unresolved_overall", a.cmr->unresolved_overall},
                   {"peak_loss", a.cmr->peak_loss},
                   {"approach", a.cmr->approach},
                   {"coarsest_pitch", a.cmr->coarsest_pitch},
                   {"reason", a.cmr->reason}});
  }
  return document.text();
}

}  // namespace

void analyze(const AnalyzeArguments& arguments) {
  std::vector<std::pair<std::string, std::string>> outputs;
  if (arguments.json) outputs.emplace_back("--json", *arguments.json);
  if (arguments.picture) outputs.emplace_back("--picture", *arguments.picture);
  check_outputs({arguments.words.surface}, outputs);
  const Analysis analysis = make_analysis(arguments);
  if (arguments.json) {
    const std::string text = document(analysis);
    write_output(rc_platform::path_of(*arguments.json), text);
  }
  if (arguments.picture) {
    write_picture(*arguments.picture, [&](std::FILE* file) { return draw_spectrum(analysis, file); });
  }
  for (const std::string& note : analysis.input.notes) report(note);
  print(analysis);
}

}  // namespace cli
