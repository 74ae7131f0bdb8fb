// The iteration of haar-cg on its machines: the plain one, whose loops say what is computed, and that of threads. They give the
// same residual at each of the first steps, the same number of steps, and the same pressures to the tolerance.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "core/thread_team.h"
#include "kernel/kernel.h"
#include "registry/options_handle.h"
#include "solvers/haar_cg/iteration/iteration.h"
#include "solvers/haar_cg/plain/machine.h"
#include "solvers/haar_cg/threads/thread_machine.h"
#include "support/cmocka.hpp"

namespace {

using rc::HaarEnding;
using Field = std::vector<double>;

static_assert(rc::Machine<rc::PlainMachine<float>> && rc::Machine<rc::PlainMachine<double>>);
static_assert(rc::Machine<rc::ThreadMachine<float>> && rc::Machine<rc::ThreadMachine<double>>);
static_assert(rc::Machine<rc::ThreadMachine<float, float>>);

constexpr double tol = 1e-9, mean_pressure = 0.2, infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t compared_steps = 6;  // later the differences in rounding have grown

// A half-space's product, written out: every entry of H by the offset of its cells.
struct Product : rc_problem {
  std::int64_t nx, ny;
  bool periodic;
  Field k;  // [iy*nx + ix]

  double entry(std::int64_t i, std::int64_t j) const {
    const std::int64_t x = std::abs(i % nx - j % nx), y = std::abs(i / nx - j / nx);
    return k[static_cast<std::size_t>(y * nx + x)];
  }
  void multiply(const double* x, double* y) const {
    for (std::int64_t i = 0; i < nx * ny; ++i) {
      y[i] = 0;
      for (std::int64_t j = 0; j < nx * ny; ++j)
        if (x[j] != 0) y[i] += entry(i, j) * x[j];
    }
  }
};

struct Contact {
  const char* name;
  std::int64_t nx, ny;
  double hx, hy;
  bool periodic, by_load;
  double depth;           // of the highest point, relative to the roughness
  double cap = infinite;  // of the pressure
};

Field rough(const Contact& c) {
  Field u;
  std::mt19937 random(7);
  for (std::int64_t y = 0; y < c.ny; ++y)
    for (std::int64_t x = 0; x < c.nx; ++x) {
      const double i = static_cast<double>(x) / static_cast<double>(c.nx), j = static_cast<double>(y) / static_cast<double>(c.ny);
      u.push_back(std::sin(13 * i + 5 * j) * std::cos(11 * j) + 0.2 * static_cast<double>(random() % 1000) * 1e-3);
    }
  const double highest = *std::max_element(u.begin(), u.end());
  for (double& value : u) value = c.by_load ? (value - highest) / c.depth : 1 + (value - highest) / c.depth;
  return u;
}

struct Solution {
  HaarEnding ending;
  double approach;
  std::int64_t steps;
  Field residuals;  // at each step
  Field p;
};

template <class M> Solution solved(M& machine, const rc::HaarTask& task) {
  std::int64_t last = 0;
  Field residuals;
  const auto poll = [&](std::int64_t steps, double residual) {
    last = steps;
    residuals.push_back(residual);
    return true;
  };
  const rc::HaarOutcome outcome = rc::HaarIteration(machine, task, poll).run(0);
  return {outcome.ending, outcome.approach, last, residuals, {}};
}

// A contact, and its solutions on the machines.
class Solved {
 public:
  Solved(const Contact& c, Field u) : c_(c), u_(std::move(u)) {
    product_.nx = c.nx;
    product_.ny = c.ny;
    product_.k.resize(u_.size());
    if (c.periodic)
      rc::kernel::periodic_coefficients(*rc::kernel::find("spectral"), c.hx, c.hy, c.nx, c.ny, c.nx, c.ny, product_.k.data());
    else
      rc::kernel::coefficients(*rc::kernel::find("love"), c.hx, c.hy, c.nx, c.ny, product_.k.data());
    grid_.nx = c.nx;
    grid_.ny = c.ny;
    grid_.hx = c.hx;
    grid_.hy = c.hy;
    grid_.boundary = c.periodic ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE;
    grid_.softness = 1;
    inputs_ = rc::tree_inputs(grid_, c.nx * c.ny, [&](std::int64_t mx, std::int64_t my, Field& out) {
      out.resize(static_cast<std::size_t>(mx * my));
      for (std::int64_t i = 0; i < mx * my; ++i)
        out[static_cast<std::size_t>(i)] = product_.k[static_cast<std::size_t>(i / mx * c.nx + i % mx)];
    });
    task_ = {.by_load = c.by_load,
             .load = mean_pressure * static_cast<double>(u_.size()),
             .cap = c.cap,
             .tol = tol,
             .least_scale = c.periodic && c.by_load ? 0.25 * mean_pressure : 0,
             .periodic_mean = inputs_.table.mean,
             .elongated = inputs_.elongated};
  }

  template <class Real> Solution on_plain(const Field& start) const {
    rc::PlainMachine<Real> machine(
        u_, start, c_.cap, [&](const Field& x, Field& y) { product_.multiply(x.data(), y.data()); },
        rc::PlainTree(inputs_.cells.mx, inputs_.cells.my, inputs_.table, false),
        rc::PlainTree(inputs_.cells.mx, inputs_.cells.my, inputs_.table, true));
    Solution found = solved(machine, task_);
    found.p = machine.pressures();
    return found;
  }

  template <class Real> Solution on_threads(const Field& start) const {
    const rc::ThreadTeam team(2);
    Product product = product_;
    product.n = static_cast<std::int64_t>(u_.size());
    product.u = u_.data();
    product.grid = &grid_;
    product.length = product.pressure = 1;
    product.cap = c_.cap;
    product.team = &team;
    product.apply = [](const rc_problem* problem, const double* x, double* y) -> rc_status {
      static_cast<const Product*>(problem)->multiply(x, y);
      return RC_OK;
    };
    product.apply_float = [](const rc_problem* problem, const float* x, float* y) -> rc_status {
      const Field wide(x, x + problem->n);
      Field result(wide.size());
      static_cast<const Product*>(problem)->multiply(wide.data(), result.data());
      std::copy(result.begin(), result.end(), y);
      return RC_OK;
    };
    const rc_host host{};
    const rc_options options{};
    const rc::Problem problem(host, product, options);
    Field p = start;
    rc::ThreadMachine<Real> machine(problem, p.data(), rc::HaarTreePair(inputs_.cells, inputs_.table));
    Solution found = solved(machine, task_);
    found.p = std::move(p);
    return found;
  }

  // The largest violation of the conditions, by a product in double precision, relative to the largest penetration.
  double violation(const Solution& found) const {
    Field w(u_.size());
    product_.multiply(found.p.data(), w.data());
    double worst = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
      const double gap = w[i] - u_[i] - found.approach, p = found.p[i];
      worst = std::max(worst, p <= 0 ? -gap : p >= c_.cap ? gap : std::abs(gap));
      if (!(p >= 0 && p <= c_.cap)) return infinite;
    }
    return worst / (c_.by_load ? std::max(found.approach, task_.least_scale) : 1);
  }

 private:
  const Contact& c_;
  const Field u_;
  Product product_{};
  rc_grid grid_{};
  rc::TreeInputs inputs_;
  rc::HaarTask task_;
};

template <class Real> void compare(const Contact& c, const Field& start) {
  const Solved contact(c, rough(c));
  const Solution by_plain = contact.on_plain<Real>(start), by_threads = contact.on_threads<Real>(start);
  const Field& p = by_threads.p;
  double difference = 0, most = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    difference = std::max(difference, std::abs(p[i] - by_plain.p[i]));
    most = std::max(most, p[i]);
  }
  const Field &a = by_threads.residuals, &b = by_plain.residuals;
  assert_int_equal(a.size(), b.size());
  const auto first = std::find_if(b.begin(), b.end(), [](double r) { return std::isfinite(r); }) - b.begin();
  assert_in_range(first, 0, static_cast<std::ptrdiff_t>(b.size()) - 2);
  double apart = 0;  // of residuals, relative to the first that is measured
  for (std::size_t k = first; k < std::min(first + compared_steps, b.size()); ++k)
    apart = std::max(apart, std::abs(a[k] - b[k]) / b[first]);
  std::printf(
      "%s, %s precision: %lld steps on threads, %lld plain, residuals differ by %.1e of the first, pressures by %.1e of the "
      "largest\n",
      c.name, sizeof(Real) == 4 ? "mixed" : "double", static_cast<long long>(by_threads.steps),
      static_cast<long long>(by_plain.steps), apart, difference / most);
  assert_true(by_threads.ending == HaarEnding::solved && by_plain.ending == HaarEnding::solved);
  assert_true(most > 0);
  assert_true(difference <= 100 * tol * most);
  assert_true(std::abs(by_threads.approach - by_plain.approach) <= 100 * tol);
  assert_true(apart <= 5e-3);
  assert_true(contact.violation(by_plain) <= 2 * tol);
  assert_int_equal(by_threads.steps, by_plain.steps);
}

constexpr Contact contacts[] = {{"square, by approach", 24, 24, 1, 1, false, false, 1.2},
                                {"square, by load", 24, 24, 1, 1, false, true, 1.2},
                                {"odd sides, by approach", 31, 18, 1, 1, false, false, 0.7},
                                {"odd sides, by load", 31, 18, 1, 1, false, true, 1},
                                {"one row", 1, 60, 1, 1, false, false, 1},
                                {"long cells", 20, 25, 1, 4, false, false, 1},
                                {"periodic, by approach", 20, 24, 1, 1, true, false, 0.9},
                                {"periodic, by load", 20, 24, 1, 1, true, true, 1},
                                {"periodic, two levels around", 40, 48, 1, 1, true, true, 1},
                                {"periodic, sides of four times odd numbers", 36, 28, 1, 1, true, false, 0.9},
                                {"periodic, one side odd", 32, 17, 1, 1, true, true, 1},
                                {"periodic, long cells", 24, 16, 1, 2.5, true, true, 1},
                                {"periodic, wide cells", 16, 24, 2.5, 1, true, false, 0.9},
                                {"capped, by approach", 24, 24, 1, 1, false, false, 1.2, 0.1},
                                {"capped, by load", 24, 24, 1, 1, false, true, 1.2, 0.3},
                                {"capped, nearly all points", 31, 18, 1, 1, false, true, 1, 1.01 * mean_pressure},
                                {"capped, one row", 1, 60, 1, 1, false, false, 1, 0.3},
                                {"capped, long cells", 20, 25, 1, 4, false, false, 1, 0.1},
                                {"capped, periodic, by approach", 20, 24, 1, 1, true, false, 0.8, 0.1},
                                {"capped, above the mean plane", 20, 24, 1, 1, true, false, 1.4, 0.6},
                                {"capped, periodic, by load", 20, 24, 1, 1, true, true, 1, 0.4}};

// A load without a cap starts from pressures, all others from none.
void machines_agree(void**) {
  for (const Contact& contact : contacts) {
    const double pressure = contact.by_load && contact.cap == infinite ? mean_pressure : 0;
    const Field start(static_cast<std::size_t>(contact.nx * contact.ny), pressure);
    compare<float>(contact, start);
    compare<double>(contact, start);
  }
}

void machines_agree_from_any_start(void**) {
  for (const Contact& contact : contacts) {
    std::mt19937 random(3);
    Field start(static_cast<std::size_t>(contact.nx * contact.ny));
    for (double& value : start) value = static_cast<double>(random() % 100) - 60;  // negative pressures are taken as 0
    compare<float>(contact, start);
  }
}

// A product that is not finite ends the iteration at that step.
void a_product_that_is_not_finite_is_noticed(void**) {
  const rc::CouplingTable table{8, 8, Field(64, 1.0), 1, 1};
  rc::PlainMachine<double> machine(
      Field(64, 1.0), Field(64, 0.0), infinite, [](const Field&, Field& y) { y.assign(y.size(), std::nan("")); },
      rc::PlainTree(8, 8, table, false), rc::PlainTree(8, 8, table, true));
  const Solution found = solved(machine, {.tol = tol});
  assert_true(found.ending == HaarEnding::not_finite);
  assert_int_equal(found.steps, 0);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(machines_agree), cmocka_unit_test(machines_agree_from_any_start),
                              cmocka_unit_test(a_product_that_is_not_finite_is_noticed)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
