#include "accuracy_scene.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace bench {

namespace {

constexpr double exact_tol = 1e-13;

struct Exact {
  Truth truth;
  rc_result result;
};

Exact solve_exactly(std::int64_t n, const Field& gap, double approach, std::int64_t threads) {
  Options options;
  options.set(RC_OPT_TOL, exact_tol).set(RC_OPT_THREADS, static_cast<double>(threads));
  rc_step step = RC_STEP_INIT;
  step.gap = gap.data();
  step.target = approach;
  Exact exact;
  exact.truth.pressure.resize(gap.size());
  exact.result = Contact(unit_square(n), options).solve(step, exact.truth.pressure.data());
  exact.truth.load = exact.result.load;
  exact.truth.area = exact.result.contact_area;
  return exact;
}

Json grid_record(const std::string& scene, std::int64_t n, const char* against, const rc_result& result, const Json& errors) {
  Json record = {{"scene", scene}, {"n", n}, {"against", against}, {"status", rc_status_name(result.status)}};
  record["kkt"] = std::max({result.kkt_primal, result.kkt_dual, result.kkt_complementarity});
  record.update(errors);
  return record;
}

// Means over 2 x 2 cells.
Field coarsened(const Field& fine, std::int64_t n) {
  Field coarse;
  coarse.reserve(static_cast<std::size_t>(n * n));
  for (std::int64_t iy = 0; iy < n; ++iy)
    for (std::int64_t ix = 0; ix < n; ++ix) {
      const double* const corner = fine.data() + 4 * n * iy + 2 * ix;
      coarse.push_back(0.25 * (corner[0] + corner[1] + corner[2 * n] + corner[2 * n + 1]));
    }
  return coarse;
}

AccuracyScene hertz(std::int64_t threads) {
  const Hertz sphere;
  AccuracyScene scene{
      "hertz", 96, sphere.approach(), sphere.gap(96), {sphere.load(), sphere.contact_area(), sphere.pressure(96)}};
  for (const std::int64_t n : {48, 96, 192, 384}) {
    const Exact exact = solve_exactly(n, sphere.gap(n), sphere.approach(), threads);
    const Truth analytic{sphere.load(), sphere.contact_area(), sphere.pressure(n)};
    scene.discretisation.push_back(
        grid_record(scene.name, n, "analytic", exact.result,
                    errors_against(analytic, exact.truth.pressure, exact.truth.load, exact.truth.area)));
  }
  return scene;
}

AccuracyScene self_affine(std::int64_t n, std::int64_t threads) {
  constexpr double area = 0.1;
  SelfAffine surface;
  surface.cut_off = static_cast<double>(n) / 8;
  AccuracyScene scene{"self-affine-" + std::to_string(n), n, 0, self_affine_gap(n, surface), {}};

  // The approach at which a light-load estimate of the load for this area is reached, loosely.
  constexpr double area_per_load = 2.2;  // of E* rms slope
  Options loose;
  loose.set(RC_OPT_TOL, 1e-3).set(RC_OPT_THREADS, static_cast<double>(threads));
  rc_step step = RC_STEP_INIT;
  step.gap = scene.gap.data();
  step.control = RC_CONTROL_LOAD;
  step.target = area * surface.rms_slope / area_per_load;
  scene.approach = Contact(unit_square(n), loose).solve(step).displacement;

  const Exact exact = solve_exactly(n, scene.gap, scene.approach, threads);
  scene.truth = exact.truth;
  const Exact fine = solve_exactly(2 * n, self_affine_gap(2 * n, surface), scene.approach, threads);
  const Truth finer{fine.truth.load, fine.truth.area, coarsened(fine.truth.pressure, n)};
  scene.discretisation.push_back(grid_record(scene.name, n, "half the cell size", exact.result,
                                             errors_against(finer, exact.truth.pressure, exact.truth.load, exact.truth.area)));
  return scene;
}

}  // namespace

Json errors_against(const Truth& truth, const Field& pressure, double load, double area) {
  double difference = 0, square = 0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    difference += (pressure[i] - truth.pressure[i]) * (pressure[i] - truth.pressure[i]);
    square += truth.pressure[i] * truth.pressure[i];
  }
  return {{"load_error", std::abs(load / truth.load - 1)},
          {"area_error", std::abs(area / truth.area - 1)},
          {"pressure_error", std::sqrt(difference / square)}};
}

std::int64_t AccuracyScene::candidates() const {
  return std::count_if(gap.begin(), gap.end(), [this](double value) { return value < approach; });
}

AccuracyScene make_accuracy_scene(const std::string& name, std::int64_t threads) {
  if (name == "hertz") return hertz(threads);
  const std::string_view prefix = "self-affine-";
  std::int64_t n = 0;
  if (name.starts_with(prefix)) std::from_chars(name.data() + prefix.size(), name.data() + name.size(), n);
  if (n < 16) throw Failure("unknown scene \"" + name + "\": hertz or self-affine-N");
  return self_affine(n, threads);
}

}  // namespace bench
