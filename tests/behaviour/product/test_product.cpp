// Products of callers against sums over pairs of points, in any memory order.
#include <roughcontact/product.h>

#include <cmath>
#include <set>

#include "support/naive.h"
#include "support/registry.h"
#include "support/surfaces.h"

using namespace pairs;

namespace {

constexpr std::int64_t nx = 12, ny = 9;

struct Destroy {
  void operator()(rc_product* product) const { rc_product_destroy(product); }
};
using Product = std::unique_ptr<rc_product, Destroy>;

Product made(const rc_system& system, const rc_options* options = nullptr) {
  rc_product* product = nullptr;
  check(rc_product_create(&system, options, &product) == RC_OK, rc_last_error());
  return Product(product);
}

// Pressures of both signs.
Field pressures(std::size_t n) {
  Field p(n);
  for (std::size_t i = 0; i < n; ++i) p[i] = std::sin(1.7 * static_cast<double>(i)) + 0.3;
  return p;
}

Field applied(rc_product* product, const Field& p) {
  Field u(p.size(), NAN);
  check(rc_product_apply(product, p.data(), 1, nx, u.data(), 1, nx) == RC_OK, rc_last_error());
  return u;
}

void against_sums(std::int32_t boundary, const std::string& backend, const std::string& kernel) {
  Problem problem = rough_problem(nx, ny, boundary, 0.5, kernel == "eq9" ? 0.5 : 0.75);  // eq9 has square cells
  problem.system.modulus = 3;
  problem.kernel = kernel;
  const Options options = make_options({"auto", backend}, kernel);
  const Product product = made(problem.system, options.get());
  const Field p = pressures(problem.points()), u = applied(product.get(), p);
  check_near(u, pairs::product(influence_matrix(problem), p), 1e-12, "u");
  if (problem.periodic()) check_near(sum(u), 0, 1e-12 * largest(u) * static_cast<double>(u.size()), "sum of u");
  check_same(applied(product.get(), p), u, "the same product again");
}

void in_any_order() {
  const Problem problem = rough_problem(nx, ny);
  const Product product = made(problem.system);
  const Field p = pressures(problem.points()), u = applied(product.get(), p);
  Field columns(p.size()), spread(2 * p.size(), 7), expected(p.size());
  for (std::int64_t y = 0; y < ny; ++y)
    for (std::int64_t x = 0; x < nx; ++x) {
      columns[static_cast<std::size_t>(x * ny + y)] = p[static_cast<std::size_t>(y * nx + x)];
      expected[static_cast<std::size_t>(x * ny + y)] = u[static_cast<std::size_t>(y * nx + x)];
    }
  // From columns to every second value, backwards.
  check(rc_product_apply(product.get(), columns.data(), ny, 1, spread.data() + 2 * (nx * ny - 1), -2, -2 * nx) == RC_OK,
        rc_last_error());
  for (std::size_t i = 0; i < u.size(); ++i) {
    check_equal(spread[2 * i] == u[u.size() - 1 - i], 1, "a deflection");
    check_equal(spread[2 * i + 1] == 7, 1, "a value between");
  }
  // In place.
  check(rc_product_apply(product.get(), columns.data(), ny, 1, columns.data(), ny, 1) == RC_OK, rc_last_error());
  check_same(columns, expected, "u over p");
}

void of_a_matrix() {
  Problem problem = rough_problem(nx, ny);
  const Field matrix = influence_matrix(problem), p = pressures(problem.points());
  problem.system.op = RC_OPERATOR_DENSE;
  problem.system.dense = matrix.data();
  problem.system.dense_ld = nx * ny;
  const Field expected = pairs::product(matrix, p);
  check_near(applied(made(problem.system).get(), p), expected, 1e-13, "by a matrix");

  struct Given {
    const Field& matrix;
  } given{matrix};
  problem.system.op = RC_OPERATOR_CALLBACK;
  problem.system.user = &given;
  problem.system.apply = [](const double* x, double* y, std::int64_t n, void* user) -> std::int32_t {
    const Field product = pairs::product(static_cast<Given*>(user)->matrix, Field(x, x + n));
    std::copy(product.begin(), product.end(), y);
    return 0;
  };
  check_near(applied(made(problem.system).get(), p), expected, 1e-13, "by a function");
}

// Small distances of both signs, against a list of the places.
void distances_are_refused_exactly_if_points_coincide() {
  for (const auto& [columns, rows] : {std::pair<std::int64_t, std::int64_t>{4, 3}, {1, 5}, {5, 1}, {1, 1}}) {
    const Problem problem = rough_problem(columns, rows);
    const Product product = made(problem.system);
    const Field p = pressures(problem.points());
    Field u(400);
    for (std::int64_t x = -13; x <= 13; ++x)
      for (std::int64_t y = -13; y <= 13; ++y) {
        std::set<std::int64_t> places;
        for (std::int64_t iy = 0; iy < rows; ++iy)
          for (std::int64_t ix = 0; ix < columns; ++ix) places.insert(ix * x + iy * y);
        const bool coincide = places.size() < problem.points();
        const rc_status status = rc_product_apply(product.get(), p.data(), 1, columns, u.data() + 200, x, y);
        const std::string words = "u_x = " + std::to_string(x) + ", u_y = " + std::to_string(y);
        check_equal(status, coincide ? RC_ERR_ARGUMENT : RC_OK, words);
        if (coincide) check(std::string(rc_last_error()).find(words) != std::string::npos, rc_last_error());
      }
  }
}

// Offsets beyond the range of addresses are refused, before they are computed; a distance that no point has does not matter.
void huge_distances() {
  const Problem problem = rough_problem(nx, ny), row = rough_problem(nx, 1);
  const Product product = made(problem.system), of_row = made(row.system);
  const Field p = pressures(problem.points());
  Field u(p.size(), 5);
  for (const std::int64_t huge : {INT64_MAX, INT64_MIN, INT64_MIN + 1, INT64_MAX / 8 / nx, INT64_MAX / 2 + 1})
    for (const bool along_x : {true, false}) {
      check_equal(rc_product_apply(product.get(), p.data(), 1, nx, u.data(), along_x ? huge : 1, along_x ? 1 : huge),
                  RC_ERR_ARGUMENT, "u");
      check_equal(rc_product_apply(product.get(), p.data(), along_x ? huge : 1, along_x ? 1 : huge, u.data(), 1, nx),
                  RC_ERR_ARGUMENT, "p");
    }
  check_same(u, Field(u.size(), 5), "u after refusals");
  check_equal(rc_product_apply(of_row.get(), p.data(), 1, INT64_MIN, u.data(), 1, INT64_MIN), RC_OK, "one row");
}

void refusals() {
  const Problem problem = rough_problem(nx, ny);
  rc_product* none = nullptr;
  check_equal(rc_product_create(&problem.system, nullptr, nullptr), RC_ERR_ARGUMENT, "out = null");
  check_equal(rc_product_create(nullptr, nullptr, &none), RC_ERR_ARGUMENT, "system = null");
  const Product product = made(problem.system);
  Field p = pressures(problem.points()), u(p.size(), 5);
  const auto refused = [&](rc_product* by, const double* from, double* to, const char* words) {
    check_equal(rc_product_apply(by, from, 1, nx, to, 1, nx), RC_ERR_ARGUMENT, words);
    check(std::string(rc_last_error()).find(words) != std::string::npos, rc_last_error());
  };
  refused(nullptr, p.data(), u.data(), "product is null");
  refused(product.get(), nullptr, u.data(), "p is null");
  refused(product.get(), p.data(), nullptr, "u is null");
  check_equal(rc_product_apply(product.get(), p.data(), 1, nx, u.data(), 0, nx), RC_ERR_ARGUMENT, "u_x = 0");
  check_equal(rc_product_apply(product.get(), p.data(), INT64_MAX, nx, u.data(), 1, nx), RC_ERR_ARGUMENT, "p_x = INT64_MAX");
  check_equal(rc_product_apply(product.get(), Field(p.size(), 1e308).data(), 1, nx, u.data(), 1, nx), RC_ERR_NUMERIC, "overflow");
  check_same(u, Field(u.size(), 5), "u after an overflow");
  p[nx + 2] = NAN;
  refused(product.get(), p.data(), u.data(), "p = nan at ix=2, iy=1 is not finite");
  check_same(u, Field(u.size(), 5), "u after a refusal");
  rc_product_destroy(nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Test> tests{{"pressures_and_deflections_in_any_memory_order", in_any_order},
                          {"a_matrix_and_a_function", of_a_matrix},
                          {"distances_are_refused_exactly_if_points_coincide", distances_are_refused_exactly_if_points_coincide},
                          {"huge_distances", huge_distances},
                          {"bad_calls_are_refused", refusals}};
  for (const auto& [boundary, kernels] :
       {std::pair{RC_BOUNDARY_FREE, std::vector<std::string>{"love", "eq9", "galerkin"}}, {RC_BOUNDARY_PERIODIC, {"spectral"}}})
    for (const std::string& kernel : kernels)
      for (const std::string backend : {"fft", "dense"}) {
        const std::int32_t at = boundary;
        tests.push_back({(at == RC_BOUNDARY_FREE ? "free_" : "periodic_") + kernel + "_" + backend,
                         [at, backend, kernel] { against_sums(at, backend, kernel); }});
      }
  return run_group("product", tests, argc, argv);
}
