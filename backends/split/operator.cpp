#include "operator.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

namespace rc_split {

namespace {

// The direct part reaches to a radius [length]: at a larger ratio of the cell's sides it would cover too many cells.
constexpr double largest_ratio = 4;

// Far beyond what fits into memory, while the product of two axes does not overflow.
constexpr std::int64_t longest_axis = std::int64_t{1} << 24;

constexpr std::int64_t least_points = 512 * 512;  // of a grid on which set-up pays
constexpr double least_tol = 1e-9;                // two digits above what these products are good for

double side_ratio(const rc_system& system) { return std::max(system.hx / system.hy, system.hy / system.hx); }

// Tiles that cover the points of an axis.
std::int64_t tiles_of(std::int64_t points) { return (points + side - 1) / side; }

// Lengthens a part of an axis to one of few lengths, so that a domain that grows a little keeps its coarse grid.
void lengthen(std::int64_t& first, std::int64_t& tiles, std::int64_t available) {
  constexpr std::int64_t short_enough = 16, steps = 8;  // set-up is cheap up to here; lengths between n and 2n
  if (tiles <= short_enough) return;
  const std::int64_t step = static_cast<std::int64_t>(std::bit_floor(static_cast<std::uint64_t>(tiles))) / steps;
  tiles = (tiles + step - 1) / step * step;
  if (8 * tiles >= 7 * available) tiles = available;
  first = std::min(first, available - tiles);
}

Frame roomy(Frame box, const Frame& grid) {
  lengthen(box.x, box.nx, grid.nx);
  lengthen(box.y, box.ny, grid.ny);
  return box;
}

}  // namespace

// A product costs what transforms of a box of eight times the points would, beside tables, windows and kernels.
void Operator::score(const rc_facts& facts, rc_estimate& estimate) {
  const rc_system& system = *facts.system;
  if (system.nx * system.ny < least_points) fail(RC_ERR_INCOMPATIBLE, "fewer than ", least_points, " points");
  if (facts.tol < least_tol) fail(RC_ERR_INCOMPATIBLE, "tol = ", facts.tol, " is below ", least_tol);
  if (side_ratio(system) > largest_ratio) fail(RC_ERR_INCOMPATIBLE, "sides of cells in a ratio above ", largest_ratio);
  const auto n = static_cast<double>(facts.n), box = static_cast<double>(facts.box),
             grid = static_cast<double>(system.nx * system.ny);
  estimate.seconds = 0.02;
  estimate.product = 8e-9 * n * std::log2(4 * box + 1);
  estimate.field = 1e-9 * grid * std::log2(4 * grid + 1);
  estimate.bytes = 44 * n + 64.0 * 1048576;
}

Operator::Operator(const rc_host* host, const rc_operator_spec& spec) : host_(host), spec_(spec), kernel_(host, spec_) {
  const rc_system& system = *spec.system;
  if (system.op != RC_OPERATOR_HALFSPACE || system.boundary != RC_BOUNDARY_FREE)
    fail(RC_ERR_INCOMPATIBLE, "only half-space grids with free boundaries; use another backend (\"fft\")");
  const double ratio = side_ratio(system);
  if (ratio > largest_ratio)
    fail(RC_ERR_INCOMPATIBLE, "cells of ", system.hx, " x ", system.hy, " have sides in the ratio ", ratio, ", more than ",
         largest_ratio, "; use another backend (\"fft\")");
  if (std::max(system.nx, system.ny) > longest_axis)
    fail(RC_ERR_SHAPE, "a grid of ", system.nx, "x", system.ny, " points has an axis longer than the limit ", longest_axis,
         "; use a coarser grid");
  const std::string spacing = roughcontact::option_text(host, spec.options, "split.spacing");
  spacing_ = spacing == "auto" ? 0 : std::stoi(spacing);
  grid_ = {0, 0, tiles_of(system.nx), tiles_of(system.ny)};
}

void Operator::bind(const rc_domain& domain) {
  const std::int64_t nx = spec_.system->nx, ny = spec_.system->ny;
  product_.bound = screen_product_.bound = field_product_.bound = float_product_.bound = false;
  tiles_ = Tiles(domain, nx, ny);
  frame_ = roomy(tiles_.box(), grid_);
  modelled_ = 0;
  for (std::int64_t tile = 0; tile < tiles_.count(); ++tile) {
    const TilePlace place = tiles_.place(tile);
    modelled_ += std::min(side, nx - place.x * side) * std::min(side, ny - place.y * side);
  }
}

// A product, which is set up when it is first asked for.
template <class T>
Product<T>& Operator::ready(Bound<T>& bound, std::optional<Tables<T>>& tables, const Frame& frame, Targets targets) {
  if (!tables) tables.emplace(kernel_);
  if (!bound.product) bound.product.emplace(*tables, spacing_);
  if (!bound.bound) bound.product->bind(tiles_, frame, targets);
  bound.bound = true;
  return *bound.product;
}

Product<double>& Operator::domain_product() { return ready(product_, tables_, frame_, Targets::domain); }

// Where the domain's frame is the grid, one product serves both.
Product<double>& Operator::screen_product() {
  return frame_ == grid_ ? domain_product() : ready(screen_product_, tables_, grid_, Targets::domain);
}

template <class T> void Operator::multiply(Product<T>& product, const T* x, T* y) {
  product.load(x);
  roughcontact::for_each(*spec_.team, tiles_.count(), product.parallel(), [&](std::int64_t tile, std::int64_t) {
    alignas(64) T out[cells_of_tile];
    product.tile(tiles_.place(tile), out);
    const std::int64_t* const positions = tiles_.positions(tile);
    const std::uint8_t* const cells = tiles_.cells(tile);
    for (std::int64_t i = 0; i < tiles_.entries(tile); ++i) y[positions[i]] = out[cells[i]];
  });
}

void Operator::apply(const double* x, double* y) { multiply(domain_product(), x, y); }

void Operator::apply_float(const float* x, float* y) {
  multiply(ready(float_product_, float_tables_, frame_, Targets::domain), x, y);
}

void Operator::field(const double* x, double* y) {
  const std::int64_t nx = spec_.system->nx, ny = spec_.system->ny;
  const bool all = tiles_.count() == grid_.tiles();
  Product<double>& product = all ? domain_product() : ready(field_product_, tables_, grid_, Targets::frame);
  product.load(x);
  roughcontact::for_each(*spec_.team, grid_.ny, true, [&](std::int64_t row, std::int64_t) {
    alignas(64) double out[cells_of_tile];
    for (std::int64_t column = 0; column < grid_.nx; ++column) {
      product.tile({column, row}, out);
      const std::int64_t width = std::min(side, nx - column * side);
      for (std::int64_t r = 0; r < std::min(side, ny - row * side); ++r)
        std::copy_n(out + r * side, width, y + (row * side + r) * nx + column * side);
    }
  });
}

}  // namespace rc_split
