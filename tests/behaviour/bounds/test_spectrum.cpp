// The facts about H that the proofs rely on: a bound of its smallest eigenvalue, and of the stiffness of flat punches.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "contact/spectrum.h"
#include "contact/system.h"
#include "kernel/kernel.h"
#include "kernel/lowest_eigenvalue.h"
#include "kernel/semi_periodic.h"
#include "support/cmocka.hpp"
#include "support/unit_system.h"

namespace {

using Vector = std::vector<double>;
constexpr double pi = 3.14159265358979323846;

struct Grid {
  std::string kernel;
  std::int64_t nx, ny;
  double hx, hy;
};

const rc::kernel::Kernel& kernel_of(const std::string& name) { return *rc::kernel::find(name); }

// H from the coefficients at all offsets of the grid.
Vector matrix_of(const Vector& table, const Grid& g) {
  Vector matrix;
  const std::int64_t n = g.nx * g.ny;
  for (std::int64_t i = 0; i < n; ++i)
    for (std::int64_t j = 0; j < n; ++j)
      matrix.push_back(table[static_cast<std::size_t>(std::abs(i / g.nx - j / g.nx) * g.nx + std::abs(i % g.nx - j % g.nx))]);
  return matrix;
}

Vector matrix_of(const std::string& name, const Grid& g) {
  Vector table(static_cast<std::size_t>(g.nx * g.ny));
  rc::kernel::coefficients(kernel_of(name), g.hx, g.hy, g.nx, g.ny, table.data());
  return matrix_of(table, g);
}

// Cholesky's factor of matrix - shift I in place; false if it has none.
bool factorise(Vector& matrix, double shift) {
  const auto n = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(matrix.size()))));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = matrix[i * n + j] - (i == j ? shift : 0);
      for (std::size_t k = 0; k < j; ++k) sum -= matrix[i * n + k] * matrix[j * n + k];
      if (i == j && !(sum > 0)) return false;
      matrix[i * n + j] = i == j ? std::sqrt(sum) : sum / matrix[j * n + j];
    }
  return true;
}

// 1'H^-1 1.
double flat_punch(Vector factor) {
  const auto n = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(factor.size()))));
  Vector x(n, 1.0);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= factor[i * n + k] * x[k];
    x[i] /= factor[i * n + i];
    sum += x[i] * x[i];
  }
  return sum;
}

std::vector<Grid> grids() {
  std::vector<Grid> result;
  for (const rc::kernel::Kernel& kernel : rc::kernel::all()) {
    if (kernel.boundary != rc::kernel::Boundary::free) continue;
    for (const auto& [nx, ny] : {std::pair<std::int64_t, std::int64_t>{1, 1}, {1, 30}, {2, 2}, {7, 3}, {13, 12}, {20, 20}})
      for (const double aspect : {1.0, 1.7, 0.1, 10.0, 100.0, 1000.0})
        if (aspect == 1 || !kernel.square_cells) result.push_back({kernel.name, nx, ny, 2.0, 2.0 * aspect});
  }
  return result;
}

struct Promised {
  double lowest, share, punch;  // eigenvalue; x'Hx over that of galerkin's; force of a flat punch for a depth of 1
  double rounding;              // of the share: eigenvalues may be as far below 0
};

// Each holds on this grid, and what can come near does.
void check_promised(const Promised& promised, const Grid& g, const Vector& h, const Vector& galerkin, double least_punch) {
  const auto fail_if = [&](bool wrong, const char* what, double bound) {
    if (wrong)
      fail_msg("%s %dx%d cells %g x %g: %s %g", g.kernel.c_str(), static_cast<int>(g.nx), static_cast<int>(g.ny), g.hx, g.hy,
               what, bound);
  };
  Vector matrix = h;
  fail_if(!(promised.lowest > 0) || !factorise(matrix, promised.lowest), "an eigenvalue is below", promised.lowest);
  matrix = h;
  for (std::size_t i = 0; i < matrix.size(); ++i) matrix[i] -= promised.share * galerkin[i];
  fail_if(!(promised.share > 0) || !factorise(matrix, -promised.rounding), "x'Hx is below that of galerkin times",
          promised.share);
  matrix = h;
  assert_true(factorise(matrix, 0));
  const double punch = flat_punch(matrix) * g.hx * g.hy;
  fail_if(!(punch <= promised.punch), "a flat punch is stiffer than", promised.punch);
  fail_if(punch < least_punch * promised.punch, "a flat punch does not come near", promised.punch);
}

// A flat punch is no stiffer than the disc around it, and the checkerboard comes near the lowest eigenvalue.
void grids_keep_their_bounds(void**) {
  for (const Grid& grid : grids()) {
    Vector h = matrix_of(grid.kernel, grid);
    const double lowest = rc::kernel::lowest_eigenvalue(kernel_of(grid.kernel), grid.hx, grid.hy),
                 share = rc::kernel::share_of_galerkin(kernel_of(grid.kernel));
    const double disc = std::hypot(static_cast<double>(grid.nx) * grid.hx, static_cast<double>(grid.ny) * grid.hy) / share;
    check_promised({lowest, share, disc, 1e-11 * grid.hx}, grid, h, matrix_of("galerkin", grid), 0);
    if (grid.nx >= 20 && factorise(h, 1.05 * lowest))
      fail_msg("%s cells %g x %g: no eigenvalue is below 1.05 times the bound %g", grid.kernel.c_str(), grid.hx, grid.hy, lowest);
  }
}

// Published values of the symbol at (pi, pi), square cells of side 1.
void square_cells_have_the_known_bounds(void**) {
  const std::pair<const char*, double> known[] = {
      {"disc", 0.72908}, {"eq9", 0.08139}, {"galerkin", 0.34021}, {"love", 0.58069}, {"punch", 0.44477}};
  for (const auto& [name, value] : known) {
    const double bound = rc::kernel::lowest_eigenvalue(kernel_of(name), 1, 1);
    if (!(bound <= value + 1e-5 && bound >= 0.994 * value)) fail_msg("%s: %g, known %g", name, bound, value);
  }
}

rc_system strip_system(const Grid& g) {
  rc_system system = support::unit_system();
  system.boundary = RC_BOUNDARY_PERIODIC_X;
  system.nx = g.nx;
  system.ny = g.ny;
  system.hx = g.hx;
  system.hy = g.hy;
  return system;
}

Vector strip_table(const std::string& name, const Grid& g) {
  Vector table(static_cast<std::size_t>(g.nx * g.ny));
  rc::kernel::semi_periodic_coefficients(kernel_of(name), strip_system(g), {0, 0, g.nx, g.ny}, table.data());
  return table;
}

// Galerkin on a strip, as the mean of love over 4 by 4 parts of both cells.
Vector strip_galerkin(const Grid& g) {
  constexpr std::int64_t parts = 4;
  const Grid fine{"love", parts * g.nx, parts * g.ny, g.hx / parts, g.hy / parts};
  const Vector love = strip_table("love", fine);
  Vector table;
  for (std::int64_t iy = 0; iy < g.ny; ++iy)
    for (std::int64_t ix = 0; ix < g.nx; ++ix) {
      double sum = 0;
      for (std::int64_t dy = 1 - parts; dy < parts; ++dy)
        for (std::int64_t dx = 1 - parts; dx < parts; ++dx)
          sum += static_cast<double>((parts - std::abs(dx)) * (parts - std::abs(dy))) *
                 love[static_cast<std::size_t>(std::abs(parts * iy + dy) * fine.nx + (parts * ix + dx + fine.nx) % fine.nx)];
      table.push_back(sum / (parts * parts));
    }
  return table;
}

void strips_keep_their_bounds(void**) {
  for (const std::string name : {"love", "spectral"})
    for (const Grid& grid :
         {Grid{name, 8, 6, 1, 1}, Grid{name, 16, 20, 0.5, 2}, Grid{name, 20, 16, 2, 0.5}, Grid{name, 1, 9, 1, 1},
          Grid{name, 9, 1, 1, 1}, Grid{name, 1, 3, 1, 10}, Grid{name, 3, 64, 0.3, 3.3}, Grid{name, 64, 5, 3, 0.3},
          Grid{name, 7, 30, 1, 1}, Grid{name, 2, 2, 1, 1}, Grid{name, 1, 1, 1, 1}, Grid{name, 12, 12, 1, 100}}) {
      const rc::kernel::Strip strip = rc::kernel::strip_of(strip_system(grid));
      const double share = rc::kernel::share_of_galerkin(strip);
      check_promised({rc::kernel::lowest_eigenvalue(kernel_of(name), strip), share,
                      rc::kernel::punch_stiffness(strip, strip.width()) / share, 0},
                     grid, matrix_of(strip_table(name, grid), grid), matrix_of(strip_galerkin(grid), grid),
                     grid.ny > 8 ? 0.9 : 0);
    }
}

void the_lowest_wave_is_the_smallest_of_the_symbol(void**) {
  const rc::kernel::Kernel& kernel = kernel_of("spectral");
  for (const auto& [nx, ny] : {std::pair<std::int64_t, std::int64_t>{2, 1}, {1, 9}, {8, 8}, {9, 4}, {15, 31}}) {
    Vector symbol(static_cast<std::size_t>((nx / 2 + 1) * (ny / 2 + 1)));
    rc::kernel::symbol(kernel, 1, 3, nx, ny, symbol.data());
    const double least = *std::min_element(symbol.begin() + 1, symbol.end());
    const double bound = rc::kernel::lowest_wave_eigenvalue(kernel, 1, 3, nx, ny);
    assert_true(bound <= least && bound >= 0.999 * least);
  }
  assert_true(rc::kernel::lowest_wave_eigenvalue(kernel, 1, 1, 1, 1) == 0);
}

rc::Spectrum spectrum_of_matrix(const Vector& matrix) {
  rc_system system = support::unit_system();
  system.op = RC_OPERATOR_DENSE;
  system.nx = std::llround(std::sqrt(static_cast<double>(matrix.size())));
  system.dense = matrix.data();
  system.dense_ld = system.nx;
  return rc::spectrum_of(rc::checked_system(system, rc_options{rc::Context::standard(), {}}, true));
}

// A chain of neighbours, whose eigenvalues are known.
void a_callers_matrix_is_factorised(void**) {
  for (const std::int64_t n : {1, 2, 5, 40, 121})
    for (const double lowest : {1e-6, 1e-3, 0.5}) {
      Vector matrix(static_cast<std::size_t>(n * n), 0.0);
      const double diagonal = lowest + 2 * std::cos(pi / static_cast<double>(n + 1));
      for (std::int64_t i = 0; i < n; ++i) {
        matrix[static_cast<std::size_t>(i * n + i)] = diagonal;
        if (i > 0) matrix[static_cast<std::size_t>(i * n + i - 1)] = matrix[static_cast<std::size_t>((i - 1) * n + i)] = -1;
      }
      const rc::Spectrum found = spectrum_of_matrix(matrix);
      const double least = lowest / diagonal;
      if (!(found.lowest <= least * (1 + 1e-9) && found.lowest >= 0.89 * least))
        fail_msg("n %d: %g, smallest eigenvalue %g", static_cast<int>(n), found.lowest, least);
      Vector factor = matrix;
      for (double& value : factor) value /= diagonal;
      assert_true(factorise(factor, 0));
      // No smaller than the exact one, which round-off of 1e-12 an entry may move by its part of the smallest eigenvalue.
      const double above = found.flat_punch / flat_punch(factor) - 1, may = 2e-12 * static_cast<double>(n) / least;
      if (!(above >= 0 && above <= may))
        fail_msg("n %d, smallest eigenvalue %g: 1'H^-1 1 is %g too large", static_cast<int>(n), least, above);
      assert_true(found.diagonal == 1);
    }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(grids_keep_their_bounds), cmocka_unit_test(square_cells_have_the_known_bounds),
                              cmocka_unit_test(strips_keep_their_bounds),
                              cmocka_unit_test(the_lowest_wave_is_the_smallest_of_the_symbol),
                              cmocka_unit_test(a_callers_matrix_is_factorised)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
