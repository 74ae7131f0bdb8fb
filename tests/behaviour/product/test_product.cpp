// Products of callers against sums over pairs of points.
#include <roughcontact/product.h>

#include <cmath>

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
  check(rc_product_apply(product, RC_IN(p.data()), RC_OUT(u.data())) == RC_OK, rc_last_error());
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

void over_the_pressures() {
  const Problem problem = rough_problem(nx, ny);
  const Product product = made(problem.system);
  const Field p = pressures(problem.points()), u = applied(product.get(), p);
  Field both = p;
  check(rc_product_apply(product.get(), RC_IN(both.data()), RC_OUT(both.data())) == RC_OK, rc_last_error());
  check_same(both, u, "u over p");
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

void refusals() {
  const Problem problem = rough_problem(nx, ny);
  rc_product* none = nullptr;
  check_equal(rc_product_create(&problem.system, nullptr, nullptr), RC_ERR_ARGUMENT, "out = null");
  check_equal(rc_product_create(nullptr, nullptr, &none), RC_ERR_ARGUMENT, "system = null");
  const Product product = made(problem.system);
  Field p = pressures(problem.points()), u(p.size(), 5);
  const auto refused = [&](rc_product* by, const double* from, double* to, const char* words) {
    check_equal(rc_product_apply(by, RC_IN(from), RC_OUT(to)), RC_ERR_ARGUMENT, words);
    check(std::string(rc_last_error()).find(words) != std::string::npos, rc_last_error());
  };
  refused(nullptr, p.data(), u.data(), "product is null");
  refused(product.get(), nullptr, u.data(), "p is null");
  refused(product.get(), p.data(), nullptr, "u is null");
  const Field large(p.size(), 1e308);
  check_equal(rc_product_apply(product.get(), RC_IN(large.data()), RC_OUT(u.data())), RC_ERR_NUMERIC, "overflow");
  check_same(u, Field(u.size(), 5), "u after an overflow");
  p[nx + 2] = NAN;
  refused(product.get(), p.data(), u.data(), "p = nan at ix=2, iy=1 is not finite");
  check_same(u, Field(u.size(), 5), "u after a refusal");
  rc_product_destroy(nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Test> tests{{"deflections_are_written_over_the_pressures", over_the_pressures},
                          {"a_matrix_and_a_function", of_a_matrix},
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
