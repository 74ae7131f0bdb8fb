// Analysis of pressures: each row of the first kind is tried on all four functions.
#include <roughcontact/analysis.h>

#include <cstring>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

// Valid calls, to be spoiled in one place.
struct Call {
  rc_system system = Scene().system;
  std::vector<double> p = std::vector<double>(points, 1.0);
  std::vector<std::uint8_t> mask = std::vector<std::uint8_t>(points, 1);
  const rc_system* system_given = &system;
  const double* p_given = p.data();

  std::vector<std::int64_t> label = std::vector<std::int64_t>(points, -7), counts = std::vector<std::int64_t>(4, -7);
  std::vector<double> load = std::vector<double>(4, untouched), density = std::vector<double>(4, untouched);
  rc_area area{};
  rc_patches patches = RC_PATCHES_INIT;
  rc_histogram histogram = RC_HISTOGRAM_INIT;
  rc_area* area_given = &area;
  rc_patches* patches_given = &patches;
  std::int32_t contact_crosses = 99, gap_crosses = 99;
  rc_histogram* histogram_given = &histogram;
  std::int32_t *contact_given = &contact_crosses, *gap_given = &gap_crosses;

  Call() {
    area = RC_AREA_INIT;
    area.contacts = patches.count = histogram.contacts = 99;
    patches.room = histogram.bins = 4;
    patches.label = RC_OUT(label.data());
    patches.load = RC_OUT(load.data());
    histogram.counts = RC_OUT(counts.data());
    histogram.density = RC_OUT(density.data());
  }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  void check_untouched() const {
    for (const auto* numbers : {&label, &counts})
      for (const std::int64_t value : *numbers) assert_true(value == -7);
    for (const auto* values : {&load, &density})
      for (const double value : *values) assert_true(value == untouched);
    assert_true(area.contacts == 99 && patches.count == 99 && histogram.contacts == 99 && contact_crosses == 99 &&
                gap_crosses == 99);
  }
};

Outcome measured(const Call& c) { return rc_area_measure(c.system_given, RC_IN(c.p_given), RC_IN(c.mask.data()), c.area_given); }
Outcome found(const Call& c) { return rc_patches_find(c.system_given, RC_IN(c.p_given), RC_IN(c.mask.data()), c.patches_given); }
Outcome filled(const Call& c) {
  return rc_histogram_fill(c.system_given, RC_IN(c.p_given), RC_IN(c.mask.data()), c.histogram_given);
}

Outcome crossed(const Call& c) {
  return rc_crossing_find(c.system_given, RC_IN(c.p_given), RC_IN(c.mask.data()), c.contact_given, c.gap_given);
}

Outcome punched(const Scene& scene, double* stiffness) {
  return rc_punch_stiffness(&scene.system, {}, nullptr, stiffness, nullptr, nullptr);
}

template <class Spoil> auto one_with(Outcome (*function)(const Call&), const Spoil& spoil) {
  return [=] {
    Call call;
    spoil(call);
    const Outcome outcome = function(call);
    if (outcome.status < 0) call.check_untouched();
    return outcome;
  };
}

template <class Spoil> auto all_with(const Spoil& spoil) {
  return [=] {
    const Outcome outcomes[] = {one_with(measured, spoil)(), one_with(found, spoil)(), one_with(filled, spoil)(),
                                one_with(crossed, spoil)()};
    const char* const names[] = {"rc_area_measure: ", "rc_patches_find: ", "rc_histogram_fill: ", "rc_crossing_find: "};
    for (int k = 0; k < 4; ++k) {
      assert_int_equal(outcomes[k].status, outcomes[0].status);
      if (outcomes[k].status < 0) assert_int_equal(outcomes[k].message.rfind(names[k], 0), 0);
    }
    return outcomes[2];
  };
}

}  // namespace

Section analyses() {
  const rc_status refused = RC_ERR_ARGUMENT, shape = RC_ERR_SHAPE;
  return {
      "Analysis",
      {
          {"analysis: system is null", refused, {"rc_histogram_fill: rc_system is null"}, all_with([](Call& c) {
             c.system_given = nullptr;
           })},
          {"analysis: p is null", refused, {"rc_histogram_fill: p is null"}, all_with([](Call& c) { c.p_given = nullptr; })},
          {"analysis: out is null", refused, {"rc_histogram_fill: rc_histogram is null"}, all_with([](Call& c) {
             c.area_given = nullptr;
             c.patches_given = nullptr;
             c.histogram_given = nullptr;
             c.gap_given = nullptr;
           })},
          {"crossing: contact is null",
           refused,
           {"rc_crossing_find: contact is null"},
           one_with(crossed, [](Call& c) { c.contact_given = nullptr; })},
          {"analysis: struct_size = 0",
           refused,
           {"rc_histogram_fill: rc_histogram.struct_size = " + too_small<rc_histogram>(0) + "; set it to sizeof(rc_histogram)"},
           all_with([](Call& c) {
             c.area.struct_size = c.patches.struct_size = c.histogram.struct_size = 0;
             c.gap_given = nullptr;  // it has no struct
           })},
          {"analysis: nx = 0", shape, {"rc_histogram_fill: nx = 0, ny = 4 must both be >= 1"}, all_with([](Call& c) {
             c.system.nx = 0;
           })},
          {"analysis: nx*ny overflows", shape, {"rc_histogram_fill: nx*ny = ", "is more than"}, all_with([](Call& c) {
             c.system.nx = c.system.ny = std::int64_t{1} << 40;
           })},
          {"analysis: hx = -1",
           refused,
           {"rc_histogram_fill: rc_system.hx = -1 must be a positive finite length"},
           all_with([](Call& c) { c.system.hx = -1; })},
          {"analysis: hy = NaN",
           refused,
           {"rc_histogram_fill: rc_system.hy = nan must be a positive finite length"},
           all_with([](Call& c) { c.system.hy = nan; })},
          {"analysis: hx*hy overflows",
           refused,
           {"rc_histogram_fill: the cell area hx*hy = 1e+200 * 1e+200 is beyond double precision"},
           all_with([](Call& c) { c.system.hx = c.system.hy = 1e200; })},
          {"analysis: boundary = 7",
           refused,
           {"rc_histogram_fill: rc_system.boundary = 7 is none of RC_BOUNDARY_FREE (1)"},
           all_with([](Call& c) { c.system.boundary = 7; })},
          {"analysis: op = 0",
           refused,
           {"rc_histogram_fill: rc_system.op = 0 is none of RC_OPERATOR_HALFSPACE"},
           all_with([](Call& c) { c.system.op = 0; })},
          {"analysis: p with NaN", refused, {"rc_histogram_fill: p[5] = nan is not finite (ix=1, iy=1)"}, all_with([](Call& c) {
             c.p[5] = nan;
           })},
          {"analysis: p with infinity", refused, {"rc_histogram_fill: p[15] = inf is not finite"}, all_with([](Call& c) {
             c.p[15] = infinity;
           })},
          {"analysis: p with a negative value", refused, {"rc_histogram_fill: p[3] = -0.5 must be >= 0"}, all_with([](Call& c) {
             c.p[3] = -0.5;
           })},
          {"analysis: NaN where the mask is 0", RC_OK, {}, all_with([](Call& c) {
             c.p[5] = nan;
             c.mask[5] = 0;
           })},
          {"`rc_patches_find`: neighbours = 6",
           refused,
           {"rc_patches_find: rc_patches.neighbours = 6 is neither 4 nor 8"},
           one_with(found, [](Call& c) { c.patches.neighbours = 6; })},
          {"`rc_patches_find`: reserved = 1",
           refused,
           {"rc_patches_find: rc_patches.reserved = 1 must be 0"},
           one_with(found, [](Call& c) { c.patches.reserved = 1; })},
          {"`rc_patches_find`: room = -1",
           refused,
           {"rc_patches_find: rc_patches.room = -1 must be >= 0"},
           one_with(found, [](Call& c) { c.patches.room = -1; })},
          {"`rc_histogram_fill`: bins = 0",
           refused,
           {"rc_histogram_fill: rc_histogram.bins = 0 must be >= 1"},
           one_with(filled, [](Call& c) { c.histogram.bins = 0; })},
          {"`rc_histogram_fill`: upper = -1",
           refused,
           {"rc_histogram_fill: rc_histogram.upper = -1 must be finite and >= 0"},
           one_with(filled, [](Call& c) { c.histogram.upper = -1; })},
          {"`rc_histogram_fill`: upper = NaN",
           refused,
           {"rc_histogram_fill: rc_histogram.upper = nan must be finite and >= 0"},
           one_with(filled, [](Call& c) { c.histogram.upper = nan; })},
          {"`rc_punch_stiffness`: system is null",
           refused,
           {"rc_punch_stiffness: rc_system is null"},
           [] {
             double stiffness = 0;
             return rc_punch_stiffness(nullptr, {}, nullptr, &stiffness, nullptr, nullptr);
           }},
          {"`rc_punch_stiffness`: stiffness is null",
           refused,
           {"rc_punch_stiffness: stiffness is null"},
           [] { return punched(Scene(), nullptr); }},
          {"`rc_punch_stiffness`: no boundary",
           refused,
           {"rc_punch_stiffness: rc_system.boundary is not set"},
           [] {
             Scene scene;
             scene.system.boundary = 0;
             double stiffness = untouched;
             const Outcome outcome = punched(scene, &stiffness);
             assert_true(stiffness == untouched);
             return outcome;
           }},
          {"`rc_punch_stiffness` without options, on a mask without points",
           RC_OK,
           {},
           [] {
             const Scene scene;
             const std::vector<std::uint8_t> nowhere(points);
             double stiffness = untouched;
             const Outcome outcome =
                 rc_punch_stiffness(&scene.system, RC_IN(nowhere.data()), nullptr, &stiffness, nullptr, nullptr);
             assert_true(stiffness == 0);
             return outcome;
           }},
      }};
}

}  // namespace errors
