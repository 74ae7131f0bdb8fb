// Contact laws, and products with the influence matrix.
#include <roughcontact/law.h>
#include <roughcontact/product.h>

#include <cstdio>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

using LawHandle = std::unique_ptr<rc_law, Destroy<rc_law_destroy>>;
using ProductHandle = std::unique_ptr<rc_product, Destroy<rc_product_destroy>>;

constexpr const char* path = "errors.law";

// A law that can be made, to be spoiled in one place.
struct Patch {
  Scene scene;
  std::vector<std::uint8_t> mask = std::vector<std::uint8_t>(points, 1);
  rc_law_spec spec = RC_LAW_SPEC_INIT;

  Patch() {
    spec.undeformed_gap = RC_IN(scene.gap.data());
    spec.mask = RC_IN(mask.data());
    spec.p_lower = 0.01;
    spec.p_upper = 0.1;
    spec.tolerance = 0.05;
  }
  Patch(const Patch&) = delete;
  Patch& operator=(const Patch&) = delete;
};

template <class Spoil> auto patch_with(const Spoil& spoil) {
  return [=] {
    Patch patch;
    spoil(patch);
    rc_law* law = nullptr;
    const Outcome outcome = rc_law_create(&patch.scene.system, nullptr, &patch.spec, &law);
    assert_int_equal(law != nullptr, outcome.status >= 0);
    rc_law_destroy(law);
    return outcome;
  };
}

const rc_law* usual_law() {
  static const LawHandle law = [] {
    const Patch patch;
    rc_law* made = nullptr;
    assert_int_equal(rc_law_create(&patch.scene.system, nullptr, &patch.spec, &made), RC_OK);
    return LawHandle(made);
  }();
  return law.get();
}

void write_file(const char* text) {
  std::FILE* const file = std::fopen(path, "wb");
  assert_non_null(file);
  std::fputs(text, file);
  std::fclose(file);
}

// Loads a file with this text; null: there is no file.
auto loading(const char* text) {
  return [=]() -> Outcome {
    std::remove(path);
    if (text) write_file(text);
    rc_law* law = nullptr;
    const Outcome outcome = rc_law_load(path, &law);
    assert_null(law);
    std::remove(path);
    return outcome;
  };
}

template <class Spoil> auto export_with(const Spoil& spoil) {
  return [=]() -> Outcome {
    std::remove(path);
    rc_law_export_spec spec = RC_LAW_EXPORT_SPEC_INIT;
    spec.format = RC_LAW_CALCULIX;
    spec.error = untouched;
    spoil(spec);
    const Outcome outcome = rc_law_export(usual_law(), path, &spec);
    assert_true(spec.error == untouched && !std::fopen(path, "rb"));
    return outcome;
  };
}

// A step of the usual law from a state of rest with usual friction.
template <class Spoil> auto slip_with(const Spoil& spoil, double x = 0.1, double along = 0) {
  return [=]() -> Outcome {
    rc_law_slip_state before = RC_LAW_SLIP_STATE_INIT, after = RC_LAW_SLIP_STATE_INIT;
    before.mu = before.nu = 0.3;
    after.p = untouched;
    spoil(before);
    const double slip[2] = {along, 0};
    const Outcome outcome = rc_law_slip(usual_law(), &before, x, slip, &after);
    assert_true(after.p == untouched);
    return outcome;
  };
}

// Products of the usual scene.
template <class Spoil> auto product_with(const Spoil& spoil) {
  return [=]() -> Outcome {
    const Scene scene;
    rc_product* made = nullptr;
    assert_int_equal(rc_product_create(&scene.system, nullptr, &made), RC_OK);
    const ProductHandle product(made);
    std::vector<double> p(points, 1.0), u(points, untouched);
    spoil(p);
    const Outcome outcome = rc_product_apply(made, RC_IN(p.data()), RC_OUT(u.data()));
    for (const double value : u) assert_true(value == untouched);
    return outcome;
  };
}

}  // namespace

Section laws() {
  const rc_status refused = RC_ERR_ARGUMENT;
  return {
      "Contact laws",
      {
          {"`rc_law_create`: out is null",
           refused,
           {"rc_law_create: out is null"},
           [] {
             const Patch patch;
             return rc_law_create(&patch.scene.system, nullptr, &patch.spec, nullptr);
           }},
          {"`rc_law_create`: spec is null",
           refused,
           {"rc_law_create: rc_law_spec is null"},
           [] {
             const Patch patch;
             rc_law* law = nullptr;
             return rc_law_create(&patch.scene.system, nullptr, nullptr, &law);
           }},
          {"`rc_law_create`: struct_size = 0",
           refused,
           {"rc_law_create: rc_law_spec.struct_size = " + too_small<rc_law_spec>(0)},
           patch_with([](Patch& a) { a.spec.struct_size = 0; })},
          {"`rc_law_create`: reserved = 1", refused, {"rc_law_spec.reserved = 1 must be 0"}, patch_with([](Patch& a) {
             a.spec.reserved = 1;
           })},
          {"`rc_law_create`: undeformed_gap is null",
           refused,
           {"rc_law_create: rc_law_spec.undeformed_gap is null"},
           patch_with([](Patch& a) { a.spec.undeformed_gap = {}; })},
          {"`rc_law_create`: all points masked", refused, {"rc_law_create: all points are masked"}, patch_with([](Patch& a) {
             a.mask.assign(points, 0);
           })},
          {"`rc_law_create`: p_lower = 0",
           refused,
           {"rc_law_spec.p_lower = 0, p_upper = 0.1: must be 0 < p_lower < p_upper, finite"},
           patch_with([](Patch& a) { a.spec.p_lower = 0; })},
          {"`rc_law_create`: p_upper below p_lower", refused, {"must be 0 < p_lower < p_upper"}, patch_with([](Patch& a) {
             a.spec.p_upper = 0.001;
           })},
          {"`rc_law_create`: p_upper = infinity", refused, {"p_upper = inf: must be"}, patch_with([](Patch& a) {
             a.spec.p_upper = infinity;
           })},
          {"`rc_law_create`: tolerance = 1e-9",
           refused,
           {"rc_law_spec.tolerance = 1e-09 must be 1e-6 .. 0.1; double precision does not prove less"},
           patch_with([](Patch& a) { a.spec.tolerance = 1e-9; })},
          {"`rc_law_create`: tolerance_conductance = 2",
           refused,
           {"rc_law_spec.tolerance_conductance = 2 must be 0 or 1e-4 .. 1"},
           patch_with([](Patch& a) { a.spec.tolerance_conductance = 2; })},
          {"`rc_law_create`: bulk = 9", refused, {"rc_law_spec.bulk = 9 is none of RC_LAW_BULK_*"}, patch_with([](Patch& a) {
             a.spec.bulk = 9;
           })},
          {"`rc_law_create`: RC_LAW_BULK_MEAN, periodic",
           RC_ERR_INCOMPATIBLE,
           {"RC_LAW_BULK_MEAN is for a half-space with free or semi-periodic boundaries; take RC_LAW_BULK_AUTO"},
           patch_with([](Patch& a) {
             a.spec.bulk = RC_LAW_BULK_MEAN;
             a.scene.system.boundary = RC_BOUNDARY_PERIODIC;
           })},
          {"`rc_law_create`: RC_LAW_BULK_GIVEN without a stiffness",
           refused,
           {"rc_law_spec.bulk_stiffness = 0 must be positive and finite with RC_LAW_BULK_GIVEN, and 0 otherwise"},
           patch_with([](Patch& a) { a.spec.bulk = RC_LAW_BULK_GIVEN; })},
          {"`rc_law_create`: area = 1, of 16 cells",
           refused,
           {"rc_law_spec.area = 1 is smaller than the points that are not masked, 16"},
           patch_with([](Patch& a) { a.spec.area = 1; })},
          {"`rc_law_create`: max_nodes = 2",
           refused,
           {"rc_law_spec.max_nodes = 2 must be 0, or at least 3"},
           patch_with([](Patch& a) { a.spec.max_nodes = 2; })},
          {"`rc_law_create`: nx = 0", RC_ERR_SHAPE, {"rc_law_create: ", "nx = 0"}, patch_with([](Patch& a) {
             a.scene.system.nx = 0;
           })},
          {"`rc_law_create`: a pressure at which the patch is closed",
           RC_ERR_INFEASIBLE,
           {"the patch is closed: it yields as a whole; lower p_upper"},
           patch_with([](Patch& a) {
             a.scene.system.boundary = RC_BOUNDARY_PERIODIC;
             a.spec.p_upper = 100;
           })},
          {"`rc_law_create`: more than max_nodes are needed",
           RC_STOP_MAX_ITER,
           {"more than rc_law_spec.max_nodes = 3 nodes are needed"},
           patch_with([](Patch& a) {
             a.spec.max_nodes = 3;
             a.spec.tolerance = 1e-4;
           })},
          {"`rc_law_describe`: law is null",
           refused,
           {"rc_law_describe: law is null"},
           [] {
             rc_law_info info = RC_LAW_INFO_INIT;
             return rc_law_describe(nullptr, &info);
           }},
          {"`rc_law_describe_node`: i = -1",
           refused,
           {"rc_law_describe_node: i = -1 is none of ", " nodes"},
           [] {
             rc_law_point node = RC_LAW_POINT_INIT;
             return rc_law_describe_node(usual_law(), -1, &node);
           }},
          {"`rc_law_pressure`: x = NaN",
           refused,
           {"rc_law_pressure: law or an output is null, or the number is NaN or infinite"},
           [] {
             double p = untouched;
             const Outcome outcome = rc_law_pressure(usual_law(), nan, &p, nullptr, nullptr);
             assert_true(p == untouched);
             return outcome;
           }},
          {"`rc_law_pressures`: an output in a device's memory",
           refused,
           {"rc_law_pressures: slope.memory = \"cuda\": this call takes arrays in the host's memory only; copy it there, and set "
            "memory to null"},
           [] {
             const double x[] = {0.1};
             double slope[] = {0};
             return rc_law_pressures(usual_law(), 1, RC_IN(x), {}, {slope, RC_NATIVE, 0, "cuda"}, {});
           }},
          {"`rc_law_pressures`: a number is infinite",
           refused,
           {"rc_law_pressures: x[1] = inf is not finite"},
           [] {
             const double x[] = {0, infinity};
             return rc_law_pressures(usual_law(), 2, RC_IN(x), {}, {}, {});
           }},
          {"`rc_law_overclosure`: x is null",
           refused,
           {"rc_law_overclosure: law or an output is null"},
           [] { return rc_law_overclosure(usual_law(), 1, nullptr); }},
          {"`rc_law_gap_conductance`: both resistivities 0",
           refused,
           {"rc_law_gap_conductance: rho1 and rho2 must be >= 0, not both 0"},
           [] {
             double conductance = 0;
             return rc_law_gap_conductance(usual_law(), 0.05, 0, 0, &conductance);
           }},
          {"`rc_law_evaluate`: x = infinity",
           refused,
           {"rc_law_evaluate: x = inf is not finite"},
           [] {
             rc_law_point point = RC_LAW_POINT_INIT;
             return rc_law_evaluate(usual_law(), infinity, &point);
           }},
          {"`rc_law_save`: a folder that is not there",
           refused,
           {"rc_law_save: nowhere/a.law: cannot be written"},
           [] { return rc_law_save(usual_law(), "nowhere/a.law"); }},
          {"`rc_file_write`: a folder",
           refused,
           {"rc_file_write: .: cannot be written: it is a folder, give the name of a file"},
           [] { return rc_file_write(".", "text", 4); }},
          {"`rc_law_load`: no file",
           refused,
           {"rc_law_load: errors.law: cannot be read: there is no such file"},
           loading(nullptr)},
          {"`rc_law_load`: a folder",
           refused,
           {"rc_law_load: .: cannot be read: it is a folder, give a file"},
           [] {
             rc_law* law = nullptr;
             return rc_law_load(".", &law);
           }},
          {"`rc_law_load`: an empty file", refused, {"errors.law: cannot be read, or is empty"}, loading("")},
          {"`rc_law_load`: another file",
           refused,
           {"errors.law: not a file of a law: it does not begin with \"roughcontact-law \""},
           loading("hello")},
          {"`rc_law_load`: a newer version",
           refused,
           {"errors.law: a law of version 2; this library reads up to 1: a newer library is needed"},
           loading("roughcontact-law 2\n")},
          {"`rc_law_load`: a damaged file",
           refused,
           {"errors.law: damaged: its checksum differs; copy it again as a binary file, or make the law again"},
           loading("roughcontact-law 1\nmodulus 1\nsum 0123456789abcdef\n")},
          {"`rc_law_export`: format = 9",
           refused,
           {"rc_law_export_spec.format = 9 is none of RC_LAW_CSV (1)"},
           export_with([](rc_law_export_spec& a) { a.format = 9; })},
          {"`rc_law_export`: rows = 201, for CalculiX",
           refused,
           {"rc_law_export_spec.rows = 201 must be 5 .. 200"},
           export_with([](rc_law_export_spec& a) { a.rows = 201; })},
          {"`rc_law_export`: rho1 = -1",
           refused,
           {"rc_law_export_spec.rho1 = -1, rho2 = 0 must be >= 0 and finite"},
           export_with([](rc_law_export_spec& a) { a.rho1 = -1; })},
          {"`rc_law_export`: length = -1",
           refused,
           {"rc_law_export_spec.length = -1, force = 1 must be positive and finite"},
           export_with([](rc_law_export_spec& a) { a.length = -1; })},
          {"`rc_law_export`: beyond = 0.5",
           refused,
           {"rc_law_export_spec.beyond = 0.5 must be 1 or more, and finite"},
           export_with([](rc_law_export_spec& a) { a.beyond = 0.5; })},
          {"`rc_law_export`: mu = 0.3 for MOOSE",
           refused,
           {"rc_law_export_spec.mu = 0.3: this format has no friction"},
           export_with([](rc_law_export_spec& a) {
             a.mu = 0.3;
             a.format = RC_LAW_MOOSE;
           })},
          {"`rc_law_slip`: mu = -1",
           refused,
           {"rc_law_slip_state.mu = -1 must be >= 0 and finite"},
           slip_with([](rc_law_slip_state& a) { a.mu = -1; })},
          {"`rc_law_slip`: nu = 0.6",
           refused,
           {"rc_law_slip_state.nu = 0.6 must be 0 .. 0.5"},
           slip_with([](rc_law_slip_state& a) { a.nu = 0.6; })},
          {"`rc_law_slip`: the slip is NaN",
           refused,
           {"slip = nan, 0 must be finite"},
           slip_with([](rc_law_slip_state&) {}, 0.1, nan)},
          {"`rc_law_slip`: a state with slip before contact",
           refused,
           {"rc_law_slip_state holds slip before contact, at the overclosure 0; begin with RC_LAW_SLIP_STATE_INIT"},
           slip_with([](rc_law_slip_state& a) { a.memory[1] = 1; })},
          {"`rc_law_slip`: a state that is none",
           refused,
           {"rc_law_slip_state.memory is none that rc_law_slip has left; begin with RC_LAW_SLIP_STATE_INIT"},
           slip_with([](rc_law_slip_state& a) { a.memory[1] = 99, a.memory[0] = 1; })},
          {"`rc_law_export`: units in which a slope overflows",
           refused,
           {"in these units a number is beyond double precision"},
           export_with([](rc_law_export_spec& a) {
             a.force = 1e308;
             a.length = 1e-6;
           })},
          {"`rc_law_export`: rows that CalculiX would move apart",
           refused,
           {"CalculiX changes overclosures that are nearer than 1e-10: choose a smaller unit of length, or fewer rows"},
           export_with([](rc_law_export_spec& a) { a.length = 1e-9; })},
          {"`rc_law_open`: name is empty",
           refused,
           {"rc_law_open: name is null or empty"},
           [] {
             const rc_law* law = nullptr;
             return rc_law_open("", nullptr, &law);
           }},
          {"`rc_law_open`: no file of that name",
           refused,
           {"rc_law_open: unheard.law: cannot be read: there is no such file"},
           [] {
             const rc_law* law = nullptr;
             return rc_law_open("unheard", nullptr, &law);
           }},
      }};
}

Section products() {
  const rc_status refused = RC_ERR_ARGUMENT;
  return {"Products",
          {
              {"`rc_product_create`: no boundary",
               refused,
               {"rc_product_create: rc_system.boundary is not set"},
               [] {
                 Scene scene;
                 scene.system.boundary = 0;
                 rc_product* product = nullptr;
                 const Outcome outcome = rc_product_create(&scene.system, nullptr, &product);
                 assert_null(product);
                 return outcome;
               }},
              {"`rc_product_create`: nx = 0",
               RC_ERR_SHAPE,
               {"rc_product_create: nx = 0"},
               [] {
                 Scene scene;
                 scene.system.nx = 0;
                 rc_product* product = nullptr;
                 return rc_product_create(&scene.system, nullptr, &product);
               }},
              {"`rc_product_apply`: p with NaN",
               refused,
               {"rc_product_apply: p = nan at ix=1, iy=1 is not finite"},
               product_with([](std::vector<double>& p) { p[5] = nan; })},
              {"`rc_product_apply`: deflections overflow",
               RC_ERR_NUMERIC,
               {"rc_product_apply: a deflection is not finite; p is up to"},
               product_with([](std::vector<double>& p) { p.assign(points, 1.7e308); })},
              {"`rc_product_apply`: p of another type",
               refused,
               {"rc_product_apply: p.type = 1 is not RC_NATIVE"},
               [] {
                 const Scene scene;
                 rc_product* made = nullptr;
                 assert_int_equal(rc_product_create(&scene.system, nullptr, &made), RC_OK);
                 const ProductHandle product(made);
                 std::vector<float> p(points, 1.0F);
                 std::vector<double> u(points, untouched);
                 return Outcome(rc_product_apply(made, {p.data(), RC_SINGLE, 0, nullptr}, RC_OUT(u.data())));
               }},
          }};
}

}  // namespace errors
