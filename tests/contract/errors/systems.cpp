#include <roughcontact/product.h>

#include <vector>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

constexpr bool countable = sizeof(void*) == 8;  // 1e15 points, by addresses

template <class Spoil> auto refuse(const Spoil& spoil) {
  return [spoil] {
    Scene scene;
    spoil(scene);
    return create(scene);
  };
}

auto grid(std::int64_t nx, std::int64_t ny) {
  return refuse([=](Scene& scene) {
    scene.system.nx = nx;
    scene.system.ny = ny;
  });
}

// Shared by the ranks of an exchange that has one.
auto shared_grid(std::int64_t nx, std::int64_t ny) {
  return [=]() -> Outcome {
    Scene scene;
    scene.system.nx = nx;
    scene.system.ny = ny;
    const rc_exchange alone = one_rank();
    rc_contact* contact = nullptr;
    const Outcome outcome = rc_ranks_contact_create(&alone, &scene.system, nullptr, &contact);
    rc_contact_destroy(contact);
    return outcome;
  };
}

auto coefficients(const char* kernel, double hx, double hy, std::int64_t nx, std::int64_t ny) {
  return [=] {
    double out[4];
    return rc_kernel_coefficients(kernel, hx, hy, nx, ny, out);
  };
}

auto system_value(double rc_system::*member, double value) {
  return refuse([=](Scene& scene) { scene.system.*member = value; });
}

}  // namespace

Section shapes() {
  const rc_status refused = RC_ERR_SHAPE;
  return {
      "Shape of the grid",
      {
          {"system and step as the macros begin them",
           refused,
           {"rc_solve: nx = 0, ny = 0 must both be >= 1; set the points along x and y"},
           [] {
             const rc_system system = RC_SYSTEM_INIT;
             const rc_step step = RC_STEP_INIT;
             return rc_solve(&system, &step, nullptr, answer().result());
           }},
          {"nx = 0", refused, {"rc_contact_create: nx = 0, ny = 4 must both be >= 1"}, grid(0, side)},
          {"ny = -1", refused, {"nx = 4, ny = -1 must both be >= 1"}, grid(side, -1)},
          {"nx = INT64_MIN", refused, {"nx = -9223372036854775808"}, grid(INT64_MIN, side)},
          {"nx = ny = INT64_MAX",
           refused,
           {"nx*ny = 9223372036854775807 * 9223372036854775807 is more than", "points"},
           grid(INT64_MAX, INT64_MAX)},
          {"nx = PTRDIFF_MAX, ny = 1", refused, {"nx*ny =", "* 1 is more than"}, grid(PTRDIFF_MAX, 1)},
          {"nx = ny = 2^32, whose product wraps to 0",
           refused,
           {"nx*ny = 4294967296 * 4294967296 is more than"},
           grid(INT64_C(1) << 32, INT64_C(1) << 32)},
          {"1e9 by 1e6 points: the gap cannot be stored",
           countable ? RC_ERR_MEMORY : RC_ERR_SHAPE,
           {countable ? "rc_solve: nx*ny = 1000000000 * 1000000 points need at least 8000000000000000 bytes, this machine has"
                      : "is more than"},
           [] {
             Scene scene;
             scene.system.nx = 1000000000;
             scene.system.ny = 1000000;
             return solve(scene);
           }},
          {"half-space of 1e6 by 1e6 points",
           countable ? RC_ERR_MEMORY : RC_ERR_SHAPE,
           {countable ? "rc_contact_create: nx*ny = 1000000 * 1000000 points need at least 8000000000000 bytes" : "is more than"},
           grid(1000000, 1000000)},
          {"product of 1e6 by 1e6 points",
           countable ? RC_ERR_MEMORY : RC_ERR_SHAPE,
           {countable ? "rc_product_create: nx*ny = 1000000 * 1000000 points need at least 8000000000000 bytes" : "is more than"},
           [] {
             Scene scene;
             scene.system.nx = scene.system.ny = 1000000;
             rc_product* product = nullptr;
             return rc_product_create(&scene.system, nullptr, &product);
           }},
          {"callback for 1e9 by 1e6 points",
           countable ? RC_ERR_MEMORY : RC_ERR_SHAPE,
           {countable
                ? "rc_contact_create: nx*ny = 1000000000 * 1000000 points need at least 8000000000000000 bytes, this machine has"
                : "is more than"},
           [] {
             Scene scene = callback_scene([](const double*, double*, std::int64_t, void*) { return std::int32_t{0}; });
             scene.system.nx = 1000000000;
             scene.system.ny = 1000000;
             return create(scene);
           }},
          {"ranks: nx = ny = 2^52",
           refused,
           {"rc_ranks_contact_create: rank 0: nx*ny = 4503599627370496 * 4503599627370496 is more than"},
           shared_grid(INT64_C(1) << 52, INT64_C(1) << 52)},
          {"ranks: 4 by 2^45 points on one rank",
           countable ? RC_ERR_MEMORY : RC_ERR_SHAPE,
           {countable ? "rc_ranks_contact_create: rank 0: nx*ny = 4 * 35184372088832 points need at least" : "is more than"},
           shared_grid(4, INT64_C(1) << 45)},
          {"kernel coefficients: nx = 0",
           refused,
           {"rc_kernel_coefficients: nx = 0, ny = 2 must both be >= 1"},
           coefficients("love", 1, 1, 0, 2)},
          {"kernel coefficients: nx*ny overflows",
           refused,
           {"rc_kernel_coefficients: nx*ny = "},
           coefficients("love", 1, 1, INT64_C(1) << 62, 4)},
      }};
}

Section values() {
  const rc_status refused = RC_ERR_ARGUMENT;
  return {"Values of the system",
          {
              {"op = 7", refused, {"rc_system.op = 7 is none of"}, refuse([](Scene& scene) { scene.system.op = 7; })},
              {"boundary = 0",
               refused,
               {"rc_system.boundary is not set: RC_BOUNDARY_PERIODIC (2) for a sample"},
               refuse([](Scene& scene) { scene.system.boundary = 0; })},
              {"hx = 0", refused, {"rc_system.hx = 0 must be a positive finite length"}, system_value(&rc_system::hx, 0)},
              {"hy = -1e-6",
               refused,
               {"rc_system.hy = -1e-06 must be a positive finite length"},
               system_value(&rc_system::hy, -1e-6)},
              {"hx = NaN", refused, {"rc_system.hx = nan must be"}, system_value(&rc_system::hx, nan)},
              {"hy = infinity", refused, {"rc_system.hy = inf must be"}, system_value(&rc_system::hy, infinity)},
              {"hx = hy = 1e-200: the cell area underflows",
               refused,
               {"the cell area hx*hy = 1e-200 * 1e-200 is beyond double precision"},
               refuse([](Scene& scene) { scene.system.hx = scene.system.hy = 1e-200; })},
              {"hx = hy = 1e200: the cell area overflows",
               refused,
               {"the cell area hx*hy = 1e+200 * 1e+200 is beyond double precision"},
               refuse([](Scene& scene) { scene.system.hx = scene.system.hy = 1e200; })},
              {"modulus = 0",
               refused,
               {"rc_system.modulus = 0 must be positive and finite (contact modulus E*)"},
               system_value(&rc_system::modulus, 0)},
              {"modulus = -2e11",
               refused,
               {"rc_system.modulus = -200000000000 must be positive"},
               system_value(&rc_system::modulus, -2e11)},
              {"modulus = NaN", refused, {"rc_system.modulus = nan must be"}, system_value(&rc_system::modulus, nan)},
              {"modulus = infinity", refused, {"rc_system.modulus = inf must be"}, system_value(&rc_system::modulus, infinity)},
              {"modulus = 1e-310: pressures underflow",
               refused,
               {"sqrt(hx*hy)/modulus = 1 / ", "is beyond double precision"},
               system_value(&rc_system::modulus, 1e-310)},
              {"hardness = -1",
               refused,
               {"rc_system.hardness = -1 must be positive, or 0 where all is elastic"},
               system_value(&rc_system::hardness, -1)},
              {"hardness = NaN", refused, {"rc_system.hardness = nan must be positive"}, system_value(&rc_system::hardness, nan)},
              {"hardness = 1e-310: deflections underflow",
               refused,
               {"rc_system.hardness = ", "what a unit pressure deflects, is beyond double precision; choose other units"},
               system_value(&rc_system::hardness, 1e-310)},
              {"hardness = infinity: elastic", RC_OK, {}, system_value(&rc_system::hardness, infinity)},
              {"cells more than 1e150 times as long as wide",
               refused,
               {"cells of hx = 1e+80 by hy = 1e-80 are more than 1e+150 times as long as wide"},
               refuse([](Scene& scene) {
                 scene.system.hx = 1e80;
                 scene.system.hy = 1e-80;
               })},
              {"kernel coefficients: cells more than 1e150 times as long as wide",
               refused,
               {"rc_kernel_coefficients: cells of hx = 1e-90 by hy = 1e+90 are more than 1e+150 times as long as wide"},
               coefficients("galerkin", 1e-90, 1e90, 2, 2)},
              {"kernel coefficients: hx = NaN",
               refused,
               {"rc_kernel_coefficients: rc_system.hx = nan must be"},
               coefficients("love", nan, 1, 2, 2)},
              {"kernel coefficients: hy = 0",
               refused,
               {"rc_kernel_coefficients: rc_system.hy = 0 must be"},
               coefficients("love", 1, 0, 2, 2)},
          }};
}

namespace {

auto matrix(std::vector<double> entries) {
  return [entries] {
    Scene scene = dense_scene();
    scene.dense = entries;
    scene.system.dense = scene.dense.data();
    scene.system.dense_ld = scene.dense.size() == 4 ? 2 : 3;
    scene.system.nx = scene.system.dense_ld;
    scene.system.ny = 1;
    return create(scene);
  };
}

auto spoilt_matrix(void (*spoil)(rc_system&)) {
  return [spoil] {
    Scene scene = dense_scene();
    spoil(scene.system);
    return create(scene);
  };
}

}  // namespace

Section dense_matrices() {
  return {
      "Dense matrices",
      {
          {"dense is null", RC_ERR_ARGUMENT, {"rc_system.dense is null"}, spoilt_matrix([](rc_system& s) { s.dense = nullptr; })},
          {"dense_ld smaller than n", RC_ERR_SHAPE, {"rc_system.dense_ld = 3 must be >= n = 4"}, spoilt_matrix([](rc_system& s) {
             s.dense_ld = 3;
           })},
          {"dense_ld negative", RC_ERR_SHAPE, {"rc_system.dense_ld = -4 must be >= n = 4"}, spoilt_matrix([](rc_system& s) {
             s.dense_ld = -4;
           })},
          {"n*dense_ld overflows",
           RC_ERR_SHAPE,
           {"n*dense_ld = 1000000 * 1000000000000 is more than", "entries"},
           spoilt_matrix([](rc_system& s) {
             s.nx = 1000000;
             s.ny = 1;
             s.dense_ld = 1000000000000;
           })},
          {"entry is NaN", RC_ERR_ARGUMENT, {"dense matrix: entry (0, 1) is nan"}, matrix({1, nan, 0, 1})},
          {"entry is infinite", RC_ERR_ARGUMENT, {"dense matrix: entry (1, 1) is inf"}, matrix({1, 0, 0, infinity})},
          {"not symmetric",
           RC_ERR_ARGUMENT,
           {"dense matrix is not symmetric: entry (1, 0) = 0.2 but (0, 1) = 0.1; allowed difference 1e-12"},
           matrix({1, 0.1, 0.2, 1})},
          {"diagonal entry 0",
           RC_ERR_NUMERIC,
           {"dense matrix is not positive definite: diagonal entry 1 is 0, must be > 0"},
           matrix({1, 0, 0, 0})},
          {"negative definite", RC_ERR_NUMERIC, {"diagonal entry 0 is -1, must be > 0"}, matrix({-1, 0, 0, -1})},
          {"indefinite with a positive diagonal",
           RC_ERR_NUMERIC,
           {"dense matrix is not positive definite: entry (1, 0) = 2 exceeds the geometric mean of the diagonal entries 1 and 1"},
           matrix({1, 2, 2, 1})},
          {"indefinite although every pair of rows looks fine",
           RC_ERR_NUMERIC,
           {"the sum of its entries is -0.6, must be > 0"},
           matrix({1, -0.6, -0.6, -0.6, 1, -0.6, -0.6, -0.6, 1})},
          {"indefinite, which only the solver's factorisation finds",
           RC_ERR_NUMERIC,
           {"rc_solve: ", "not positive definite"},
           [] {
             // Rows 0 and 1 nearly agree, but their products with row 2 differ in sign.
             Scene scene = dense_scene();
             scene.dense = {1, 0.9, 0.9, 0.9, 1, 0.1, 0.9, 0.1, 1};
             scene.system.dense = scene.dense.data();
             scene.system.dense_ld = scene.system.nx = 3;
             scene.system.ny = 1;
             scene.step.target = 5;
             return solve(scene, options_with({{"solver", "nnls"}}).get());
           }},
      }};
}

namespace {

// A diagonal operator that goes wrong at the product number `at`.
struct Fault {
  enum Kind { none, reports, returns_nan } kind = none;
  int at = 0, products = 0;
};

std::int32_t diagonal(const double* x, double* y, std::int64_t n, void* user) {
  Fault& fault = *static_cast<Fault*>(user);
  for (std::int64_t i = 0; i < n; ++i) y[i] = x[i];
  if (++fault.products < fault.at || fault.kind == Fault::none) return 0;
  if (fault.kind == Fault::reports) return 1;
  y[n / 2] = nan;
  return 0;
}

auto faulty(Fault::Kind kind, int at, const char* solver = "polonsky-keer") {
  return [=] {
    Fault fault{kind, at, 0};
    const Scene scene = callback_scene(diagonal, &fault);
    return solve(scene, options_with({{"solver", solver}}).get());
  };
}

std::int32_t negative(const double* x, double* y, std::int64_t n, void*) {
  for (std::int64_t i = 0; i < n; ++i) y[i] = -x[i];
  return 0;
}

// Neighbours attract more than a point resists: eigenvalues 3 and -1.
std::int32_t indefinite(const double* x, double* y, std::int64_t n, void*) {
  for (std::int64_t i = 0; i < n; ++i) y[i] = x[i] + 2 * x[i ^ 1];
  return 0;
}

Outcome indefinite_with(const char* solver) {
  Scene scene = callback_scene(indefinite);
  scene.step.target = 5;
  return solve(scene, options_with({{"solver", solver}}).get());
}

Outcome certified_by_an_indefinite_product() {
  const Scene scene = callback_scene(indefinite);
  const ContactHandle contact = made(scene);
  std::vector<double> p;
  for (std::int64_t i = 0; i < points; ++i) p.push_back(i % 2 == 0 ? 1 : -1);
  rc_result result{};
  result.struct_size = sizeof result;
  result.p.data = p.data();
  return rc_contact_certify(contact.get(), &scene.step, &result);
}

// After a failed product the same contact solves as if nothing had happened.
Outcome recovers_after_failure() {
  Fault fault{Fault::reports, 3, 0};
  const Scene scene = callback_scene(diagonal, &fault);
  const ContactHandle contact = made(scene);
  assert_int_equal(solve(contact.get(), scene), RC_ERR_EXTERNAL);
  assert_true(answer().untouched());
  fault.kind = Fault::none;
  return solve(contact.get(), scene);
}

}  // namespace

Section callbacks() {
  const char* const reported = "the caller's apply function reported failure";
  return {"Callbacks",
          {
              {"apply is null", RC_ERR_ARGUMENT, {"rc_system.apply is null"}, [] { return create(callback_scene(nullptr)); }},
              {"fails at once", RC_ERR_EXTERNAL, {"rc_solve: ", reported}, faulty(Fault::reports, 1)},
              {"fails at the third product", RC_ERR_EXTERNAL, {"rc_solve: ", reported}, faulty(Fault::reports, 3)},
              {"fails at the third product, inside nnls",
               RC_ERR_EXTERNAL,
               {"rc_solve: ", reported},
               faulty(Fault::reports, 3, "nnls")},
              {"works again after a failure", RC_OK, {}, recovers_after_failure},
              {"returns NaN at once",
               RC_ERR_NUMERIC,
               {"the caller's apply function returned nan at ix=0, iy=2"},
               faulty(Fault::returns_nan, 1)},
              {"returns NaN at the second product",
               RC_ERR_NUMERIC,
               {"the caller's apply function returned a value that is not finite"},
               faulty(Fault::returns_nan, 2)},
              {"returns NaN at the third product, inside nnls",
               RC_ERR_NUMERIC,
               {"the caller's apply function returned a value that is not finite"},
               faulty(Fault::returns_nan, 3, "nnls")},
              {"negative definite",
               RC_ERR_NUMERIC,
               {"the caller's apply function is not positive definite: 1'H1 = -16, must be > 0"},
               [] { return create(callback_scene(negative)); }},
              {"indefinite, met by polonsky-keer",
               RC_ERR_NUMERIC,
               {"polonsky-keer: the operator is not positive definite"},
               [] { return indefinite_with("polonsky-keer"); }},
              {"indefinite, met by the certificate",
               RC_ERR_NUMERIC,
               {"rc_contact_certify: the caller's apply function is not positive definite: p'Hp = ", ", must be > 0"},
               certified_by_an_indefinite_product},
              {"indefinite, met by nnls",
               RC_ERR_NUMERIC,
               {"the operator is not positive definite"},
               [] { return indefinite_with("nnls"); }},
          }};
}

}  // namespace errors
