// H x where it may overlap the surface. For x >= 0 both parts of H x are sums of what is not negative: on a tile, H x is at least
// the smooth part, which is at least the least node of the coarse grid that the tile is interpolated from times the least sum of
// interpolation weights.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "operator.h"

namespace rc_split {

namespace {

// Taken off the bound, relative to the largest product: some orders above the error of the products.
constexpr double margin = 1e-9;

class Screen {
 public:
  Screen(const rc_operator_spec& spec, const Frame& grid, const Tiles& tiles, const Product<double>& product, const double* x,
         rc_screen& request)
      : team_(*spec.team),
        nx_(spec.system->nx),
        ny_(spec.system->ny),
        grid_(grid),
        tiles_(tiles),
        product_(product),
        request_(request) {
    const std::int64_t n = tiles.first(tiles.count());
    bounded_ = product.spacing() > 0 && std::all_of(x, x + n, [](double value) { return value >= 0; });
    if (bounded_) {
      weight_ = product.least_weight();
      slack_ = -product.short_range().lowest() * std::accumulate(x, x + n, 0.0);
    }
  }

  void run() {
    request_.n_found = 0;
    std::vector<TilePlace> list;
    for (std::int64_t tile = 0; tile < tiles_.count(); ++tile) list.push_back(tiles_.place(tile));
    evaluate(list);
    slack_ += margin * largest_;
    list.clear();
    select(list);
    evaluate(list);
  }

 private:
  std::int64_t width(std::int64_t column) const { return std::min(side, nx_ - column * side); }
  std::int64_t height(std::int64_t row) const { return std::min(side, ny_ - row * side); }

  // The deepest that any point of a tile would be without deflection.
  double deepest(TilePlace place) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::int64_t r = 0; r < height(place.y); ++r) {
      const std::int64_t first = (place.y * side + r) * nx_ + place.x * side;
      for (std::int64_t i = first; i < first + width(place.x); ++i)
        if (!request_.mask || request_.mask[i]) least = std::min(least, request_.gap[i]);
    }
    return request_.approach - least;
  }

  // Tiles without points of the domain that are not proven to stay apart.
  void select(std::vector<TilePlace>& list) {
    std::vector<std::uint8_t> chosen(static_cast<std::size_t>(grid_.tiles()));
    const std::int64_t count = bounded_ ? product_.nodes_per_axis() : 0, step = bounded_ ? product_.nodes_per_tile() : 0;
    const std::int64_t nodes = bounded_ ? (grid_.nx - 1) * step + count : 0;
    std::vector<double> scratch(static_cast<std::size_t>(team_.threads * nodes));
    roughcontact::for_each(team_, grid_.ny, true, [&](std::int64_t row, std::int64_t thread) {
      double* const least = scratch.data() + thread * nodes;
      if (bounded_) {
        const double* const first = product_.nodes({0, row});
        std::copy_n(first, nodes, least);
        for (std::int64_t i = 1; i < count; ++i)
          for (std::int64_t k = 0; k < nodes; ++k) least[k] = std::min(least[k], first[i * product_.node_stride() + k]);
      }
      for (std::int64_t column = 0; column < grid_.nx; ++column) {
        if (tiles_.at(column, row) >= 0) continue;
        const double depth = deepest({column, row});
        if (!(depth > 0)) continue;  // H has no negative entry
        if (bounded_) {
          const double node = *std::min_element(least + column * step, least + column * step + count);
          if (node > 0 && request_.unit * (node * weight_ - slack_) >= depth) continue;
        }
        chosen[static_cast<std::size_t>(row * grid_.nx + column)] = 1;
      }
    });
    for (std::int64_t tile = 0; tile < grid_.tiles(); ++tile)
      if (chosen[static_cast<std::size_t>(tile)]) list.push_back({tile % grid_.nx, tile / grid_.nx});
  }

  // Products of the tiles, some at a time: into y where they are of the domain, compared with the surface elsewhere.
  void evaluate(const std::vector<TilePlace>& list) {
    constexpr std::size_t batch = 512;
    Array<double> values(std::min(batch, list.size()) * cells_of_tile);
    for (std::size_t begin = 0; begin < list.size(); begin += batch) {
      const std::size_t end = std::min(begin + batch, list.size());
      roughcontact::for_each(team_, static_cast<std::int64_t>(end - begin), product_.parallel(),
                             [&](std::int64_t i, std::int64_t) {
                               product_.tile(list[begin + static_cast<std::size_t>(i)], values.data() + i * cells_of_tile);
                             });
      for (std::size_t i = begin; i < end; ++i) take(list[i], values.data() + (i - begin) * cells_of_tile);
    }
  }

  void take(TilePlace place, const double* value) {
    bool inside[cells_of_tile] = {};
    if (const std::int64_t tile = tiles_.at(place.x, place.y); tile >= 0)
      for (std::int64_t i = 0; i < tiles_.entries(tile); ++i) {
        const std::uint8_t cell = tiles_.cells(tile)[i];
        inside[cell] = true;
        request_.y[tiles_.positions(tile)[i]] = value[cell];
        largest_ = std::max(largest_, std::abs(value[cell]));
      }
    for (std::int64_t r = 0; r < height(place.y); ++r)
      for (std::int64_t c = 0; c < width(place.x); ++c) {
        const std::int64_t point = (place.y * side + r) * nx_ + place.x * side + c;
        if (inside[r * side + c] || (request_.mask && !request_.mask[point])) continue;
        const double depth = request_.approach - request_.gap[point] - request_.unit * value[r * side + c];
        if (!(depth > 0)) continue;
        if (request_.n_found < request_.room) {
          request_.found[request_.n_found] = point;
          request_.depth[request_.n_found] = depth;
        }
        ++request_.n_found;
      }
  }

  const rc_team& team_;
  std::int64_t nx_, ny_;
  const Frame& grid_;
  const Tiles& tiles_;
  const Product<double>& product_;
  rc_screen& request_;
  bool bounded_ = false;  // the bound holds
  double weight_ = 0, slack_ = 0, largest_ = 0;
};

}  // namespace

void Operator::screen(const double* x, rc_screen& request) {
  Product<double>& product = grid_product();
  product.load(x);
  Screen(spec_, grid_, tiles_, product, x, request).run();
}

}  // namespace rc_split
