#include "operator.h"

#include <algorithm>
#include <string>

namespace rc_split {

namespace {

// The direct part is circular in lengths: beyond this ratio of the cell's sides it would reach over too many cells.
constexpr double largest_ratio = 4;

// Far beyond what fits into memory; a product of two of them is far from overflow.
constexpr std::int64_t longest_axis = std::int64_t{1} << 24;

// Whole tiles of a grid.
std::int64_t tiles_of(std::int64_t points) { return (points + side - 1) / side; }

}  // namespace

Operator::Operator(const rc_host* host, const rc_operator_spec& spec) : host_(host), spec_(spec) {
  const rc_system& system = *spec.system;
  if (system.op != RC_OPERATOR_HALFSPACE || system.boundary != RC_BOUNDARY_FREE)
    fail(RC_ERR_INCOMPATIBLE, "only half-space grids with free boundaries; use another backend (\"fft\")");
  const double ratio = std::max(system.hx / system.hy, system.hy / system.hx);
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
  box_product_.bound = grid_product_.bound = float_product_.bound = false;
  tiles_ = Tiles(domain, nx, ny);
  modelled_ = 0;
  for (std::int64_t tile = 0; tile < tiles_.count(); ++tile) {
    const TilePlace place = tiles_.place(tile);
    modelled_ += std::min(side, nx - place.x * side) * std::min(side, ny - place.y * side);
  }
}

const FarField& Operator::far() {
  if (!far_) far_ = std::make_unique<FarField>(host_, spec_);
  return *far_;
}

template <class T>
Product<T>& Operator::ready(Bound<T>& bound, std::optional<Tables<T>>& tables, const Frame& frame, std::int64_t targets) {
  if (!tables) tables.emplace(host_, spec_);
  if (!bound.product) bound.product.emplace(host_, spec_, *tables, spacing_);
  if (!bound.bound) bound.product->bind(tiles_, frame, targets, [this]() -> const FarField& { return far(); });
  bound.bound = true;
  return *bound.product;
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

void Operator::apply(const double* x, double* y) { multiply(ready(box_product_, tables_, tiles_.box(), tiles_.count()), x, y); }

void Operator::apply_float(const float* x, float* y) {
  multiply(ready(float_product_, float_tables_, tiles_.box(), tiles_.count()), x, y);
}

// Where the domain's box is the grid, one product serves both.
Product<double>& Operator::grid_product() {
  if (tiles_.box() == grid_) return ready(box_product_, tables_, grid_, tiles_.count());
  return ready(grid_product_, tables_, grid_, grid_.tiles());
}

void Operator::field(const double* x, double* y) {
  const std::int64_t nx = spec_.system->nx, ny = spec_.system->ny;
  Product<double>& product = grid_product();
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
