// The contact-set solve against factors of the matrix: free and periodic, dense and scattered sets, some of the points or all of
// them as unknowns of the operator, with products in single precision and without.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

#include "contact/slopes/contact_set_solve.h"
#include "core/thread_team.h"
#include "kernel/kernel.h"
#include "registry/options_handle.h"
#include "support/cmocka.hpp"

namespace {

using Field = std::vector<double>;
using Points = std::vector<std::int64_t>;

constexpr double tol = 1e-8;

// A half-space's product, written out, as a backend.
struct Matrix {
  std::int64_t nx, ny;
  Field k;  // [iy*nx + ix]
  Points points;

  double entry(std::int64_t i, std::int64_t j) const {
    const std::int64_t x = std::abs(i % nx - j % nx), y = std::abs(i / nx - j / nx);
    return k[static_cast<std::size_t>(y * nx + x)];
  }
  template <class Real> void multiply(const Real* x, Real* y) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
      Real sum = 0;
      for (std::size_t j = 0; j < points.size(); ++j)
        if (x[j] != 0) sum += static_cast<Real>(entry(points[i], points[j])) * x[j];
      y[i] = sum;
    }
  }
};

rc_backend written_out(bool single) {
  rc_backend backend{};
  backend.struct_size = sizeof backend;
  backend.name = "written-out";
  backend.caps = single ? RC_CAP_FLOAT : 0;
  backend.create = [](const rc_host*, const rc_operator_spec* spec, void** self) -> rc_status {
    const rc_system& s = *spec->system;
    auto* const matrix = new Matrix{s.nx, s.ny, Field(static_cast<std::size_t>(s.nx * s.ny)), {}};
    if (s.boundary == RC_BOUNDARY_PERIODIC)
      rc::kernel::periodic_coefficients(*rc::kernel::find("spectral"), s.hx, s.hy, s.nx, s.ny, s.nx, s.ny, matrix->k.data());
    else
      rc::kernel::coefficients(*rc::kernel::find("love"), s.hx, s.hy, s.nx, s.ny, matrix->k.data());
    *self = matrix;
    return RC_OK;
  };
  backend.destroy = [](void* self) { delete static_cast<Matrix*>(self); };
  backend.bind = [](void* self, const rc_domain* domain) -> rc_status {
    Points& points = static_cast<Matrix*>(self)->points;
    points.resize(static_cast<std::size_t>(domain->n));
    for (std::int64_t i = 0; i < domain->n; ++i) points[static_cast<std::size_t>(i)] = domain->index ? domain->index[i] : i;
    return RC_OK;
  };
  backend.apply = [](void* self, const double* x, double* y) -> rc_status {
    static_cast<const Matrix*>(self)->multiply(x, y);
    return RC_OK;
  };
  backend.apply_float = [](void* self, const float* x, float* y) -> rc_status {
    static_cast<const Matrix*>(self)->multiply(x, y);
    return RC_OK;
  };
  return backend;
}

struct Case {
  const char* name;
  std::int64_t nx, ny;
  bool periodic;
  double share;  // of the points in contact
  bool box;      // they fill a box; otherwise they are scattered
  bool few;      // the operator knows two points of three
  bool single = true;
};

constexpr Case cases[] = {{"free, dense", 24, 20, false, 0.5, false, false},
                          {"free, scattered", 24, 20, false, 0.06, false, false},
                          {"free, a box", 24, 20, false, 0.3, true, false},
                          {"free, few unknowns", 25, 31, false, 0.3, false, true},
                          {"free, double precision", 25, 31, false, 0.3, false, true, false},
                          {"free, one row", 120, 1, false, 0.5, false, false},
                          {"free, one column", 1, 120, false, 0.5, false, false},
                          {"periodic, dense", 24, 20, true, 0.6, false, false},
                          {"periodic, all but a few points", 24, 20, true, 0.99, false, false},
                          {"periodic, scattered", 24, 20, true, 0.06, false, false},
                          {"periodic, few unknowns", 25, 31, true, 0.3, false, true},
                          {"periodic, double precision", 25, 31, true, 0.3, false, true, false}};

// A solve with all that it stands on.
class Set {
 public:
  explicit Set(const Case& c) : backend_(written_out(c.single)), op_(make_operator(c)), solve_(make_solve(c)) {}
  Set(const Set&) = delete;

  std::size_t size() const { return points_.size(); }
  rc::ContactSetSolve& solve() { return solve_; }
  double mean() const { return solve_.mean(); }
  std::int64_t products() const { return op_.products(); }
  Field multiplied(const double* x) const {
    Field y(size());
    for (std::size_t i = 0; i < size(); ++i)
      for (std::size_t j = 0; j < size(); ++j) y[i] += (matrix_.entry(points_[i], points_[j]) + mean()) * x[j];
    return y;
  }
  // By Gauss's method.
  Field direct(const double* b) const {
    const std::size_t n = size();
    std::vector<Field> a(n, Field(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) a[i][j] = matrix_.entry(points_[i], points_[j]) + mean();
      a[i][n] = b[i];
    }
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = k + 1; i < n; ++i)
        for (std::size_t j = n + 1; j-- > k;) a[i][j] -= a[i][k] / a[k][k] * a[k][j];
    Field x(n);
    for (std::size_t i = n; i-- > 0;) {
      x[i] = a[i][n];
      for (std::size_t j = i + 1; j < n; ++j) x[i] -= a[i][j] * x[j];
      x[i] /= a[i][i];
    }
    return x;
  }

 private:
  rc::Operator make_operator(const Case& c);
  rc::ContactSetSolve make_solve(const Case& c);

  rc_backend backend_;
  rc_host host_{};
  rc_options options_{};
  rc_system system_ = RC_SYSTEM_INIT;
  rc::ThreadTeam team_{2};
  rc::TrialSet trial_;
  Points positions_, points_;  // of the contact set
  Matrix matrix_;
  rc::Operator op_;
  rc::ContactSetSolve solve_;
};

rc::Operator Set::make_operator(const Case& c) {
  system_.nx = c.nx;
  system_.ny = c.ny;
  system_.hx = system_.hy = system_.modulus = 1;
  system_.boundary = c.periodic ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE;
  std::mt19937 random(11);
  for (std::int64_t i = 0; i < c.nx * c.ny; ++i) {
    if (c.few && random() % 3 == 0) continue;
    const bool in = c.box ? i % c.nx >= 3 && i % c.nx < 15 && i / c.nx >= 5 : random() % 1000 < 1000 * c.share;
    if (in) {
      positions_.push_back(trial_.n);
      points_.push_back(i);
    }
    ++trial_.n;
    if (c.few) trial_.index.push_back(i);
  }
  return {backend_, host_, system_, "love", options_, team_, 1};
}

rc::ContactSetSolve Set::make_solve(const Case& c) {
  op_.bind(trial_);
  rc_operator_spec spec{};
  spec.system = &system_;
  void* made = nullptr;
  backend_.create(&host_, &spec, &made);
  matrix_ = *static_cast<Matrix*>(made);
  backend_.destroy(made);
  rc_grid grid{};
  grid.nx = c.nx;
  grid.ny = c.ny;
  grid.hx = grid.hy = 1;
  grid.boundary = system_.boundary;
  grid.softness = 1;
  return {op_, positions_, grid, 0.3, team_, [&](std::int64_t mx, std::int64_t my, Field& out) {
            out.clear();
            for (std::int64_t y = 0; y < my; ++y)
              for (std::int64_t x = 0; x < mx; ++x) out.push_back(matrix_.k[static_cast<std::size_t>(y * c.nx + x)]);
          }};
}

double length(const Field& v) {
  double sum = 0;
  for (const double value : v) sum += value * value;
  return std::sqrt(sum);
}

double distance(const Field& a, const double* b) {
  Field d(a);
  for (std::size_t i = 0; i < d.size(); ++i) d[i] -= b[i];
  return length(d);
}

// Ones, as the stiffness has them, then noise of very different sizes.
Field right_sides(std::size_t n, std::size_t count) {
  std::mt19937 random(5);
  Field b(n, 1.0);
  for (std::size_t k = 1; k < count; ++k)
    for (std::size_t i = 0; i < n; ++i)
      b.push_back((static_cast<double>(random() % 2001) / 1000 - 1) * std::pow(1e6, static_cast<double>(k) - 2));
  return b;
}

void answers_are_those_of_a_direct_solver(void**) {
  constexpr std::size_t count = 3;
  for (const Case& c : cases) {
    Set set(c);
    const std::size_t n = set.size();
    const Field b = right_sides(n, count);
    Field x(b.size());
    rc::ContactSetBound bounds[count];
    assert_int_equal(set.solve()(b, tol, x, bounds), RC_OK);
    std::printf("%s, %zu points: %lld products for %zu right-hand sides\n", c.name, n, static_cast<long long>(set.products()),
                count);
    assert_in_range(set.products(), 1, 18 * count);
    for (std::size_t k = 0; k < count; ++k) {
      const Field right(b.begin() + static_cast<std::ptrdiff_t>(k * n), b.begin() + static_cast<std::ptrdiff_t>((k + 1) * n));
      const double* const found = x.data() + k * n;
      const double size = length(right), residual = distance(set.multiplied(found), right.data());
      const Field exact = set.direct(right.data());
      double form = 0;
      for (std::size_t i = 0; i < n; ++i) form += right[i] * exact[i];
      assert_true(residual <= bounds[k].residual && bounds[k].residual <= tol * size);
      assert_true(distance(exact, found) <= 10 * tol * length(exact));
      assert_true(std::abs(form - bounds[k].form) <= bounds[k].error && bounds[k].error <= 1e-9 * form);
    }
  }
}

void a_start_saves_products(void**) {
  for (const Case& c : cases) {
    Set set(c);
    const Field b = right_sides(set.size(), 1);
    Field x(set.size());
    rc::ContactSetBound bound;
    assert_int_equal(set.solve()(b, 1e-9, x, {&bound, 1}), RC_OK);
    const std::int64_t from_zero = set.products();
    assert_int_equal(set.solve()(b, tol, x, {&bound, 1}), RC_OK);
    assert_int_equal(set.products(), from_zero + 1);  // its residual is looked at, and is small enough
    for (double& value : x) value *= -1e6;            // worse than none
    assert_int_equal(set.solve()(b, tol, x, {&bound, 1}), RC_OK);
    assert_true(distance(set.multiplied(x.data()), b.data()) <= bound.residual && bound.residual <= tol * length(b));
  }
}

void what_round_off_hides_is_not_promised(void**) {
  for (const Case& c : cases) {
    Set set(c);
    const Field b = right_sides(set.size(), 1);
    Field x(set.size());
    rc::ContactSetBound bound;
    assert_int_equal(set.solve()(b, 1e-15, x, {&bound, 1}), RC_STOP_STALLED);
    assert_true(distance(set.multiplied(x.data()), b.data()) <= bound.residual);
    assert_true(bound.residual > 1e-15 * length(b) && bound.residual <= 1e-11 * length(b));
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(answers_are_those_of_a_direct_solver), cmocka_unit_test(a_start_saves_products),
                              cmocka_unit_test(what_round_off_hides_is_not_promised)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
