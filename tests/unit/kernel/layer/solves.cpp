// Contacts of layered half-spaces: every pair, intervals, an accuracy goal, known loads, and the number of products.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include "layer.h"
#include "support/unit_system.h"

namespace layer {

namespace {

using Settings = std::vector<std::pair<const char*, std::string>>;

std::string text(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}

Settings settings_of(const Layer& layer) {
  return {{RC_OPT_KERNEL, "layer"},
          {"layer.thickness", text(layer.thickness)},
          {"layer.modulus", text(layer.modulus)},
          {"layer.poisson", text(layer.poisson)},
          {"layer.substrate_poisson", text(layer.substrate)},
          {"layer.base", layer.base},
          {"layer.interface", layer.interface}};
}

Settings with(Settings one, const Settings& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

struct Surface {
  std::int64_t side;
  std::vector<double> gap;
  std::int32_t boundary = RC_BOUNDARY_FREE;
  double cell = 1, modulus = 1;
};

Surface sphere(std::int64_t side, double radius, std::int32_t boundary = RC_BOUNDARY_FREE) {
  Surface made{side, {}, boundary};
  const double centre = 0.5 * static_cast<double>(side - 1);
  for (std::int64_t i = 0; i < side * side; ++i) {
    const double x = static_cast<double>(i % side) - centre, y = static_cast<double>(i / side) - centre;
    made.gap.push_back((x * x + y * y) / (2 * radius));
  }
  return made;
}

// Waves of random phases, amplitudes falling with the wave number to the power 1.8, root mean square height 1.
Surface rough(std::int64_t side, std::int32_t boundary) {
  Surface made{side, std::vector<double>(static_cast<std::size_t>(side * side)), boundary};
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> phase(0, 2 * pi);
  double square = 0;
  for (int ky = 0; ky <= 16; ++ky)
    for (int kx = ky == 0 ? 1 : -16; kx <= 16; ++kx) {
      const double at = phase(generator), size = std::pow(std::hypot(kx, ky), -1.8);
      square += size * size / 2;
      for (std::int64_t i = 0; i < side * side; ++i)
        made.gap[static_cast<std::size_t>(i)] +=
            size * std::cos(2 * pi * static_cast<double>(kx * (i % side) + ky * (i / side)) / static_cast<double>(side) + at);
    }
  const double lowest = *std::min_element(made.gap.begin(), made.gap.end());
  for (double& each : made.gap) each = (each - lowest) / std::sqrt(square);
  return made;
}

class Context {
 public:
  Context() { assert_int_equal(rc_context_create(0, nullptr, nullptr, nullptr, &context_), RC_OK); }
  ~Context() { rc_context_destroy(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  rc_context* get() const { return context_; }

  rc_result solve(const Surface& surface, const Settings& settings, double target,
                  std::int32_t control = RC_CONTROL_APPROACH) const {
    rc_options* options = nullptr;
    assert_int_equal(rc_options_create(context_, &options), RC_OK);
    for (const auto& [key, value] : settings) assert_int_equal(rc_options_set_text(options, key, value.c_str()), RC_OK);
    rc_system system = support::unit_system();
    system.nx = system.ny = surface.side;
    system.hx = system.hy = surface.cell;
    system.modulus = surface.modulus;
    system.boundary = surface.boundary;
    rc_step step = RC_STEP_INIT;
    step.control = control;
    step.target = target;
    step.undeformed_gap.data = surface.gap.data();
    rc_result result = RC_RESULT_INIT;
    result.status = rc_solve(&system, &step, options, &result);
    rc_options_destroy(options);
    return result;
  }

 private:
  rc_context* context_ = nullptr;
};

void assert_near(double value, double wanted, double tolerance, const std::string& what) {
  if (!(std::abs(value - wanted) <= tolerance * std::abs(wanted)))
    fail_msg("%s: %.15g instead of %.15g; %s", what.c_str(), value, wanted, rc_last_error());
}

void every_pair_agrees(void**) {
  const Context context;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const Layer& layer : {Layer{0.4, 0.2}, Layer{3, 6}, Layer{2, 1, 0.4, 0.3, "rigid", "bonded"},
                               Layer{3, 2, 0.3, 0.3, "half-space", "frictionless"}}) {
      const Surface surface = sphere(16, 40, boundary);
      const rc_result wanted = context.solve(
          surface, with(settings_of(layer), {{RC_OPT_SOLVER, "nnls"}, {RC_OPT_BACKEND, "dense"}, {RC_OPT_TOL, "1e-12"}}), 0.4);
      assert_int_equal(wanted.status, RC_OK);
      assert_true(wanted.load_lower <= wanted.load && wanted.load <= wanted.load_upper &&
                  wanted.load_upper < 1.0001 * wanted.load);
      for (std::int64_t i = 0; i < rc_component_count(context.get(), RC_COMPONENT_SOLVER); ++i)
        for (const char* backend : {"dense", "fft", "cholmod"})
          for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD}) {
            rc_component solver = RC_COMPONENT_INIT;
            assert_int_equal(rc_component_describe(context.get(), RC_COMPONENT_SOLVER, i, &solver), RC_OK);
            const bool by_load = control == RC_CONTROL_LOAD;
            const rc_result found = context.solve(
                surface,
                with(
                    settings_of(layer),
                    {{RC_OPT_SOLVER, solver.name}, {RC_OPT_BACKEND, backend}, {RC_OPT_TOL, "1e-9"}, {RC_OPT_MAX_ITER, "100000"}}),
                by_load ? wanted.load : 0.4, control);
            if (found.status == RC_ERR_NO_BACKEND) continue;  // not built
            const std::string name = std::string(solver.name) + " on " + backend;
            if (std::string(solver.name) == "greedy" && found.status == RC_UNCERTIFIED) continue;
            if (found.status != RC_OK) fail_msg("%s: %d %s", name.c_str(), found.status, rc_last_error());
            if (by_load)
              assert_near(found.approach, 0.4, 1e-6, name);
            else
              assert_near(found.load, wanted.load, 1e-6, name);
            assert_true(found.load_lower <= wanted.load * (1 + 1e-6) && wanted.load <= found.load_upper * (1 + 1e-6));
          }
    }
}

void an_accuracy_goal_is_kept(void**) {
  const Context context;
  const Surface surface = sphere(256, 3000);
  for (const Layer& layer : {Layer{2, 0.2}, Layer{10, 5}, Layer{300, 5}}) {
    const double wanted = context.solve(surface, settings_of(layer), 1).load;
    const rc_result found = context.solve(surface, with(settings_of(layer), {{RC_OPT_ACCURACY, "0.02"}}), 1);
    if (found.status != RC_OK) assert_int_equal(found.status, RC_WITHIN_GOAL);
    assert_near(found.load, wanted, 0.02, "accuracy 0.02");
  }
}

void products_are_hardly_more_than_on_a_half_space(void**) {
  const Context context;
  const bool all = std::getenv("RC_TEST_QUICK") == nullptr;
  double worst = 0;
  bool good = true;
  for (const std::int64_t side : all ? std::vector<std::int64_t>{64, 128, 256} : std::vector<std::int64_t>{64})
    for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
      const Surface surface = rough(side, boundary);
      const Settings pair{{RC_OPT_SOLVER, "haar-cg"}, {RC_OPT_BACKEND, "fft"}};
      for (const double share : {0.02, 0.3, 0.8}) {  // of the mean gap
        double mean = 0;
        for (const double each : surface.gap) mean += each / static_cast<double>(side * side);
        // One mean pressure for all layers would leave them in different contact: one share of the surface does not.
        const auto solved = [&](const Settings& kernel) { return context.solve(surface, with(kernel, pair), share * mean); };
        const rc_result plain = solved({});
        if (plain.status == RC_ERR_NO_BACKEND) skip();
        assert_int_equal(plain.status, RC_OK);
        for (const double modulus : {0.1, 0.5, 2.0, 10.0})
          for (const double thickness : {0.01, 0.3, 1.0, 3.0, 0.1 * static_cast<double>(side), static_cast<double>(side),
                                         100 * static_cast<double>(side)}) {
            const rc_result found = solved(settings_of({thickness, modulus}));
            if (found.status != RC_OK) fail_msg("status %d %s", found.status, rc_last_error());
            const double ratio = static_cast<double>(found.products) / static_cast<double>(plain.products);
            worst = std::max(worst, ratio);
            // A stiff layer is a plate, for which the trees are not made.
            const double allowed = modulus < 5 ? 1.3 : boundary == RC_BOUNDARY_FREE ? 1.7 : 3.2;
            const bool few = found.products <= plain.products + 6;
            good = good && (ratio <= allowed || few);
            if (ratio > 1.3 && !few)
              print_message("%ld %s share %g E1/E2 %g t %g: %ld products, half-space %ld, contact %.2g and %.2g\n",
                            static_cast<long>(side), boundary == RC_BOUNDARY_FREE ? "free" : "periodic", share, modulus,
                            thickness, static_cast<long>(found.products), static_cast<long>(plain.products),
                            static_cast<double>(found.contacts) / static_cast<double>(side * side),
                            static_cast<double>(plain.contacts) / static_cast<double>(side * side));
          }
      }
    }
  print_message("most products: %.2f times those of the half-space\n", worst);
  assert_true(good);
}

}  // namespace

const std::vector<CMUnitTest> solve_tests = {
    cmocka_unit_test(every_pair_agrees),
    cmocka_unit_test(an_accuracy_goal_is_kept),
    cmocka_unit_test(products_are_hardly_more_than_on_a_half_space),
};

}  // namespace layer
