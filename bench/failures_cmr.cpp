// The family cmr of the atlas: cascade multi-resolution as published and certified, by class of surface.
#include <algorithm>
#include <cmath>

#include "cascade.h"
#include "failure_run.h"
#include "failures.h"
#include "format.h"
#include "library.h"
#include "measured_surface.h"
#include "rough_surface.h"

namespace bench {

namespace {

constexpr std::int32_t halvings = 2;       // of the cascade, as for the measured surfaces of the paper
constexpr std::int32_t deep_halvings = 5;  // of larger measured surfaces
constexpr const char* filters[] = {"subsample", "mean", "max"};

struct Pressed {
  Scene scene;
  std::string name, seed;  // seed: empty for a measured surface
};

Pressed press(const SurfaceClass& surface, std::int64_t n, std::uint64_t seed) {
  Pressed pressed{{}, surface.name, std::to_string(seed)};
  pressed.scene.system.nx = pressed.scene.system.ny = n;
  pressed.scene.gap = gap_below_highest(surface.heights(n, seed));
  pressed.scene.approach = mean_of(pressed.scene.gap) / 2;
  return pressed;
}

Cascade cascade(const char* filter, std::int32_t levels) { return {.filter = filter, .radius = 1.5, .levels = levels}; }

// One surface by every filter.
void measure(const Pressed& pressed, std::int32_t halved, Atlas& atlas) {
  const Solved full = solve(pressed.scene, {{"solver", "polonsky-keer"}, {"backend", "fft"}});
  if (full.status != RC_OK) throw Failure(pressed.name + ": " + full.message);
  const CmrVerdict verdict = cmr_verdict(pressed.scene, halved);
  for (const char* filter : filters) {
    const Solved plain = solve(pressed.scene, settings_of(cascade(filter, halved + 1), false)),
                 certified = solve(pressed.scene, settings_of(cascade(filter, halved + 1), true));
    const CascadeNote note = cascade_note(certified.result.note);
    const double plain_error = plain.result.load / full.result.load - 1;
    const double certified_error = certified.result.load / full.result.load - 1;
    const bool wrong = difference(plain.p, full.p) > 1e-4;
    atlas.record("cmr", {{"surface", pressed.name},
                         {"seed", pressed.seed},
                         {"filter", filter},
                         {"plain_error", plain_error},
                         {"plain_status", plain.name()},
                         {"plain_wrong", wrong ? 1 : 0},
                         {"certified_error", certified_error},
                         {"certified_difference", difference(certified.p, full.p)},
                         {"certified_status", certified.name()},
                         {"rounds", note.rounds},
                         {"kept", note.share()},
                         {"full_products", full.products()},
                         {"certified_products", certified.products()},
                         {"contacts", full.result.contacts},
                         {"trustworthy", verdict.trustworthy ? 1 : 0},
                         {"unresolved", verdict.unresolved},
                         {"dishonest", (wrong && plain.status == RC_OK) ? 1 : 0}});
  }
}

double mean_over(const Json& rows, const std::string& surface, const std::string& filter, const char* key) {
  double sum = 0, count = 0;
  for (const Json& row : rows)
    if (row.at("surface") == surface && row.at("filter") == filter) {
      sum += row.at(key).get<double>();
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

double largest_of(const Json& rows, const std::string& surface, const char* key) {
  double largest = 0;
  for (const Json& row : rows)
    if (row.at("surface") == surface) largest = std::max(largest, std::abs(row.at(key).get<double>()));
  return largest;
}

void summarise(const std::string& name, const std::string& words, Atlas& atlas) {
  const Json& rows = atlas.data().at("cmr");
  const auto percent = [&](const char* filter) { return 100 * mean_over(rows, name, filter, "plain_error"); };
  atlas.add("cmr",
            {"as published, " + words,
             formatted("load off by %.2f %% (subsample), %.2f %% (mean), %.2f %% (max)", percent("subsample"), percent("mean"),
                       percent("max")),
             formatted("wrong answers with status RC_OK: %.0f; the surface's spectrum warns: %.2f unresolved, trustworthy %.0f",
                       largest_of(rows, name, "dishonest"), mean_over(rows, name, "max", "unresolved"),
                       mean_over(rows, name, "max", "trustworthy")),
             formatted("certified: load off by %.0e at most, %.0f rounds at most", largest_of(rows, name, "certified_error"),
                       largest_of(rows, name, "rounds"))});
}

}  // namespace

void cmr_failures(const FailuresRequest& request, Atlas& atlas) {
  const std::int64_t n = request.quick ? 64 : 256;
  for (const SurfaceClass& surface : surface_classes()) {
    if (surface.longest > static_cast<double>(n) / 2 || surface.roll_off > static_cast<double>(n) / 4) continue;
    for (std::uint64_t seed = 1; seed <= (request.quick ? 1 : 4); ++seed) measure(press(surface, n, seed), halvings, atlas);
    summarise(surface.name, surface.name, atlas);
  }
  if (!request.surface.empty()) {
    const MeasuredSurface surface = read_measured(request.surface);
    const Pressed pressed{scene_of(surface), surface.name, ""};
    measure(pressed, deep_halvings, atlas);
    summarise(pressed.name, "measured surface " + pressed.name, atlas);
  }
}

}  // namespace bench
