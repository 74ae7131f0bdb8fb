// Influence coefficients: pure functions of numbers. Lengths in, lengths out: the deflection of an elastic half-space
// times E* under unit pressure on one hx x hy cell.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace rc::kernel {

enum class Boundary { free, periodic };

// The offsets (first_x + ix, first_y + iy), 0 <= ix < mx, 0 <= iy < my, of a table out[iy*mx + ix].
struct Window {
  std::int64_t first_x, first_y, mx, my;
};

// A kernel of the homogeneous half-space.
struct Kernel {
  const char* name;
  const char* summary;                                               // one line
  Boundary boundary;                                                 // where it is defined
  bool square_cells;                                                 // needs hx == hy
  bool semi_periodic;                                                // also on grids that repeat along one axis
  void (*window)(double hx, double hy, const Window&, double* out);  // free coefficients; null: periodic boundaries only
};

// All of them, sorted by name.
std::span<const Kernel> all();
const Kernel* find(std::string_view name);  // nullptr if there is none

// Free kernels: out[iy*mx + ix] = coefficient at offset (ix*hx, iy*hy), 0 <= ix < mx, 0 <= iy < my.
// Relative error <= 1e-12 at every offset up to 16384 cells.
void coefficients(const Kernel&, double hx, double hy, std::int64_t mx, std::int64_t my, double* out);

// coefficients() of any window; constructing a kernel's expansion costs some microseconds.
void window_coefficients(const Kernel&, double hx, double hy, const Window&, double* out);

// Periodic kernels on an nx x ny grid: eigenvalues of the discrete operator at wave numbers kx = 0..nx/2, ky = 0..ny/2,
// out[ky*(nx/2+1) + kx]; the mean's is 0.
void symbol(const Kernel&, double hx, double hy, std::int64_t nx, std::int64_t ny, double* out);

// The operator of a symbol in real space, out[iy*mx + ix] for offsets 0 <= ix < mx <= nx, 0 <= iy < my <= ny.
void from_symbol(std::vector<double> symbol, std::int64_t nx, std::int64_t ny, std::int64_t mx, std::int64_t my, double* out);
void periodic_coefficients(const Kernel&, double hx, double hy, std::int64_t nx, std::int64_t ny, std::int64_t mx,
                           std::int64_t my, double* out);

}  // namespace rc::kernel
