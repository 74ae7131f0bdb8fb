// Kernels from outside: what they give, and which descriptions are refused.
#include <roughcontact/analysis.h>
#include <roughcontact/law.h>

#include <algorithm>

#include "kernel_scene.h"

namespace plugins {

namespace {

void a_kernel_of_ones_own_serves_every_pair() {
  const Registry registry("");
  Spoilt sound;
  const rc_kernel kernel = decay(sound);
  assert_int_equal(registry.add(kernel), RC_OK);
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const double wanted =
        boundary == RC_BOUNDARY_FREE ? load_of_matrix(1) : pressed(registry, {{RC_OPT_BACKEND, "dense"}}, boundary).result.load;
    for (const std::string& solver : pairs::solver_names())
      for (const char* backend : {"dense", "fft", "cholmod"}) {
        const Pressed found = pressed(
            registry, {{RC_OPT_SOLVER, solver}, {RC_OPT_BACKEND, backend}, {RC_OPT_TOL, "1e-9"}, {RC_OPT_MAX_ITER, "100000"}},
            boundary);
        if (found.status == RC_ERR_NO_BACKEND || (found.status != RC_OK && solver == "greedy")) continue;  // not built
        if (found.status != RC_OK) fail_msg("%s on %s: %s", solver.c_str(), backend, rc_last_error());
        assert_string_equal(found.result.kernel, "decay");
        assert_near(found.result.load, wanted, 1e-6);
      }
  }
}

// The kernel of a half-space whose modulus grows with depth^0 is the usual one. Lengths are the caller's for cells of any size.
void a_kernel_comes_from_a_file() {
  const Scratch scratch;
  const std::string file = scratch.put({"graded"});
  const Registry registry(scratch.path());
  const auto load = [&](double cell, const char* exponent) {
    const Pressed found(registry, paraboloid_of(RC_BOUNDARY_PERIODIC, cell),
                        {{RC_OPT_KERNEL, "graded"}, {"graded.length", pairs::text(8 * cell)}, {"graded.exponent", exponent}});
    pairs::check(found.status == RC_OK, rc_last_error());
    return found.result.load / (cell * cell);
  };
  assert_near(load(1, "0"), Pressed(registry, paraboloid_of(RC_BOUNDARY_PERIODIC)).result.load, 1e-6);
  assert_near(load(1e-6, "0.5"), load(1, "0.5"), 1e-6);
  assert_true(std::abs(load(1, "0.5") / load(1, "0") - 1) > 0.1);
  bool listed = false;
  for (std::int64_t i = 0; i < rc_component_count(registry.get(), RC_COMPONENT_KERNEL); ++i) {
    rc_component each = RC_COMPONENT_INIT;
    assert_int_equal(rc_component_describe(registry.get(), RC_COMPONENT_KERNEL, i, &each), RC_OK);
    listed = listed || (each.name == std::string("graded") && each.origin == file);
  }
  assert_true(listed);
  const pairs::Settings settings{{RC_OPT_KERNEL, "graded"}, {"graded.length", "1"}};
  const pairs::Contact contact(paraboloid_of(RC_BOUNDARY_PERIODIC), pairs::automatic, settings, registry.get());
  const pairs::Options changed = pairs::make_options(pairs::automatic, "graded", {{"graded.length", "2"}}, registry.get());
  assert_int_equal(rc_contact_set_options(contact.handle(), changed.get()), RC_ERR_OPTION);
  assert_message_has("option \"graded.length\" is fixed when the contact is created; make a new contact to change it");
}

void spoilt_kernels_are_refused() {
  const struct {
    void (*spoil)(rc_kernel&);
    const char* reason;
  } rows[] = {
      {[](rc_kernel& k) { k.window = nullptr; }, "kernel \"decay\" has no window() but its caps say otherwise"},
      {[](rc_kernel& k) { k.caps = RC_KERNEL_FREE; }, "kernel \"decay\" has symbol() but its caps say otherwise"},
      {[](rc_kernel& k) { k.caps = 0, k.window = nullptr, k.symbol = nullptr; }, "kernel \"decay\" lacks window and symbol"},
      {[](rc_kernel& k) { k.name = "love"; }, "a component named \"love\" is registered already"},
      {[](rc_kernel& k) { k.license = nullptr; }, "lacks a summary or a licence"},
  };
  for (const auto& row : rows) {
    const Registry registry("", RC_CONTEXT_NO_PLUGINS);
    Spoilt sound;
    rc_kernel kernel = decay(sound);
    row.spoil(kernel);
    assert_int_equal(registry.add(kernel), RC_ERR_PLUGIN);
    assert_message_has(row.reason);
  }
}

void boundaries_and_cells_are_checked() {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  Spoilt sound;
  rc_kernel kernel = decay(sound);
  kernel.caps = RC_KERNEL_FREE | RC_KERNEL_SQUARE;
  kernel.symbol = nullptr;
  assert_int_equal(registry.add(kernel), RC_OK);
  assert_int_equal(pressed(registry, {}, RC_BOUNDARY_PERIODIC).status, RC_ERR_INCOMPATIBLE);
  assert_message_has("kernel \"decay\" is not for periodic boundaries, which the system has; use kernel=auto");
  pairs::Problem problem = paraboloid_of();
  assert_int_equal(Pressed(registry, problem, {{RC_OPT_KERNEL, "decay"}}).status, RC_OK);
  problem.system.hy *= 2;
  assert_int_equal(Pressed(registry, problem, {{RC_OPT_KERNEL, "decay"}}).status, RC_ERR_INCOMPATIBLE);
  assert_message_has("kernel \"decay\" needs square cells");
}

// exp(-|x| - |y|) on a grid that repeats along one axis, spoilt where the test says.
rc_status strip_window(const rc_host*, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y, std::int64_t mx,
                       std::int64_t my, double* out) {
  const rc_system& s = *spec->system;
  const Spoilt& spoilt = support::decay_of(spec);
  const auto folded = [](std::int64_t offset, std::int64_t period) {
    return std::min(offset % period, period - offset % period);
  };
  for (std::int64_t iy = first_y; iy < first_y + my; ++iy)
    for (std::int64_t ix = first_x; ix < first_x + mx; ++ix) {
      const std::int64_t x = s.boundary == RC_BOUNDARY_PERIODIC_X ? folded(ix, s.nx) : ix,
                         y = s.boundary == RC_BOUNDARY_PERIODIC_Y ? folded(iy, s.ny) : iy;
      *out++ = (ix == spoilt.x && iy == spoilt.y ? spoilt.factor : 1) * std::exp(-static_cast<double>(x + y));
    }
  return RC_OK;
}

rc_kernel strip(Spoilt& spoilt) {
  rc_kernel kernel = decay(spoilt);
  kernel.caps = RC_KERNEL_FREE | RC_KERNEL_SEMI_PERIODIC;
  kernel.window = strip_window;
  kernel.symbol = nullptr;
  return kernel;
}

// Wherever the false coefficient lies, also where a transform does not read it.
void coefficients_of_a_period_must_be_symmetric() {
  for (const char* backend : {"dense", "fft", "auto"})
    for (const std::int32_t boundary : {RC_BOUNDARY_PERIODIC_X, RC_BOUNDARY_PERIODIC_Y}) {
      const bool along_x = boundary == RC_BOUNDARY_PERIODIC_X;
      const auto status_of = [&](Spoilt spoilt) {
        const Registry registry("");
        const rc_kernel kernel = strip(spoilt);
        assert_int_equal(registry.add(kernel), RC_OK);
        return pressed(registry, {{RC_OPT_BACKEND, backend}}, boundary).status;
      };
      assert_int_equal(status_of({}), RC_OK);
      assert_int_equal(status_of({.x = 3, .y = 3, .factor = 1 + 1e-13}), RC_OK);
      for (const std::int64_t along : {1, 4, 5, 7, 11})
        for (const std::int64_t across : {0, 2, 11}) {
          const std::int64_t x = along_x ? along : across, y = along_x ? across : along;
          assert_int_equal(status_of({.x = x, .y = y, .factor = 0.9}), RC_ERR_NUMERIC);
          assert_message_has("kernel \"decay\": the coefficients at offsets (");
          const auto place = [](std::int64_t at_x, std::int64_t at_y) {
            return "(" + std::to_string(at_x) + ", " + std::to_string(at_y) + ")";
          };
          assert_message_has(place(x, y).c_str());
          assert_message_has(place(along_x ? side - x : x, along_x ? y : side - y).c_str());
          assert_message_has(along_x ? "the grid repeats after 12 points along x" : "the grid repeats after 12 points along y");
        }
    }
}

void coefficients_must_not_depend_on_the_window() {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  Spoilt spoilt;
  rc_kernel kernel = decay(spoilt);
  kernel.window = [](const rc_host* host, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y, std::int64_t mx,
                     std::int64_t my, double* out) {
    support::decay_window(host, spec, first_x, first_y, mx, my, out);
    for (std::int64_t i = 0; i < mx * my; ++i) out[i] /= first_x == 0 ? 1 : 2;
    return rc_status{RC_OK};
  };
  assert_int_equal(registry.add(kernel), RC_OK);
  assert_int_equal(pressed(registry).status, RC_ERR_NUMERIC);
  assert_message_has("kernel \"decay\": the coefficient at offset (1, 0) is ");
  assert_message_has("must not depend on the window");
}

// Barber's relation is that of a homogeneous half-space, which a kernel must say.
void conductance_needs_a_homogeneous_half_space() {
  for (const bool homogeneous : {false, true})
    for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
      const Registry registry("", RC_CONTEXT_NO_PLUGINS);
      Spoilt sound;
      rc_kernel kernel = decay(sound);
      if (homogeneous) kernel.caps |= RC_KERNEL_HOMOGENEOUS;
      assert_int_equal(registry.add(kernel), RC_OK);
      const rc_result result = pressed(registry, {{RC_OPT_STIFFNESS, "1"}}, boundary).result;
      assert_int_equal(result.status, RC_OK);
      assert_int_equal(result.homogeneous, homogeneous);
      const rc_system system = support::unit_system();
      double conductance = -7;
      const rc_status status = rc_conductance(&system, &result, 1, 1, &conductance, nullptr, nullptr);
      assert_int_equal(status, homogeneous ? RC_OK : RC_ERR_ARGUMENT);
      if (homogeneous) {
        assert_near(conductance, result.stiffness, 1e-12);
      } else {
        assert_message_has("rc_result.homogeneous = 0: kernel \"decay\" is not that of a homogeneous half-space");
        assert_true(conductance == -7);
      }
    }
}

// The law of a layer has pressures and slopes, and no conductance, also after it was saved.
void a_law_remembers_whether_it_has_a_conductance() {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  Spoilt sound;
  const rc_kernel kernel = decay(sound);
  assert_int_equal(registry.add(kernel), RC_OK);
  const Scratch scratch;
  const std::string path = scratch.path() + "/a.law", deck = scratch.path() + "/a.inp";
  const rc_system system = paraboloid_of(RC_BOUNDARY_PERIODIC).system;
  std::vector<double> gap;
  for (std::int64_t i = 0; i < side * side; ++i) gap.push_back(static_cast<double>(i * 37 % 101) * 1e-2);
  rc_law_spec spec = RC_LAW_SPEC_INIT;
  spec.undeformed_gap = RC_IN(gap.data());
  spec.p_lower = 0.01;
  spec.p_upper = 0.05;
  spec.tolerance = 0.05;
  for (const char* name : {"decay", "spectral"}) {
    const bool homogeneous = std::string(name) == "spectral";
    const pairs::Options options = pairs::make_options(pairs::automatic, name, {{RC_OPT_TOL, "1e-8"}}, registry.get());
    rc_law* law = nullptr;
    spec.tolerance_conductance = 0.5;
    const rc_status asked = rc_law_create(&system, options.get(), &spec, &law);
    if (!homogeneous) {
      assert_int_equal(asked, RC_ERR_ARGUMENT);
      assert_message_has("rc_law_spec.tolerance_conductance = 0.5: no conductance follows from the slope of this law");
    }
    rc_law_destroy(law);
    spec.tolerance_conductance = 0;
    assert_true(rc_law_create(&system, options.get(), &spec, &law) >= 0);
    for (int loaded = 0; loaded < 2; ++loaded) {
      rc_law_info info = RC_LAW_INFO_INIT;
      assert_int_equal(rc_law_describe(law, &info), RC_OK);
      assert_true((info.modulus > 0) == homogeneous);
      double conductance = -7;
      assert_int_equal(rc_law_gap_conductance(law, 0.02, 1, 1, &conductance), homogeneous ? RC_OK : RC_ERR_ARGUMENT);
      if (!homogeneous) assert_message_has("a layer, or the caller's own matrix, product or kernel");
      rc_law_point point = RC_LAW_POINT_INIT;
      assert_int_equal(rc_law_evaluate(law, info.x_lower * 1.5, &point), RC_OK);
      assert_true(point.slope > 0 && std::isnan(point.conductance) == !homogeneous);
      rc_law_export_spec cards = RC_LAW_EXPORT_SPEC_INIT;
      cards.format = RC_LAW_ABAQUS;
      assert_int_equal(rc_law_export(law, deck.c_str(), &cards), RC_OK);
      cards.rho1 = 1;
      assert_int_equal(rc_law_export(law, deck.c_str(), &cards), homogeneous ? RC_OK : RC_ERR_ARGUMENT);
      if (!homogeneous) assert_message_has("rc_law_export_spec.rho1 = 1, rho2 = 0: no conductance follows");
      if (loaded) break;
      assert_int_equal(rc_law_save(law, path.c_str()), RC_OK);
      rc_law_destroy(law);
      assert_int_equal(rc_law_load(path.c_str(), &law), RC_OK);
    }
    rc_law_destroy(law);
  }
}

void a_backend_that_needs_the_far_field_is_passed_over() {
  const Registry registry("");
  Spoilt sound;
  const rc_kernel kernel = decay(sound);
  assert_int_equal(registry.add(kernel), RC_OK);
  const rc_status status = pressed(registry, {{RC_OPT_BACKEND, "split"}}).status;
  if (status == RC_ERR_NO_BACKEND) throw pairs::Skipped("split is not built");
  assert_int_equal(status, RC_ERR_INCOMPATIBLE);
  assert_message_has("backend \"split\" cannot do kernel \"decay\", whose far field is not that of the half-space");
  const Pressed chosen = pressed(registry, {{RC_OPT_BACKEND, "split,dense"}});
  assert_int_equal(chosen.status, RC_OK);
  assert_string_equal(chosen.result.backend, "dense");
  const Pressed large(registry, paraboloid_of(RC_BOUNDARY_FREE, 1, 512), {{RC_OPT_KERNEL, "decay"}, {RC_OPT_TOL, "1e-8"}});
  assert_int_equal(large.status, RC_OK);
  assert_has(large.explanation(),
             "split: backend \"split\" cannot do kernel \"decay\", whose far field is not that of the half-space\n");
}

}  // namespace

std::vector<pairs::Test> kernel_tests() {
  return {
      TEST(a_kernel_of_ones_own_serves_every_pair),
      TEST(a_kernel_comes_from_a_file),
      TEST(spoilt_kernels_are_refused),
      TEST(boundaries_and_cells_are_checked),
      TEST(coefficients_of_a_period_must_be_symmetric),
      TEST(coefficients_must_not_depend_on_the_window),
      TEST(conductance_needs_a_homogeneous_half_space),
      TEST(a_law_remembers_whether_it_has_a_conductance),
      TEST(a_backend_that_needs_the_far_field_is_passed_over),
  };
}

}  // namespace plugins
