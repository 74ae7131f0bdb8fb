// H x where it may overlap the surface. For x >= 0 the short range adds at least -slack_ to H x, so a point stays apart if the
// smooth part less slack_ keeps it apart. H has no negative entry, so a point that is apart without deflection stays apart, too.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "operator.h"

namespace rc_split {

namespace {

// Added to the slack, relative to the largest product: far above the error of the products.
constexpr double margin = 1e-9;

class Screen {
 public:
  Screen(const rc_operator_spec& spec, const Frame& grid, const Tiles& tiles, const Product<double>& product, const double* x,
         rc_screen& request)
      : team_(*spec.team),
        nx_(spec.system->nx),
        ny_(spec.system->ny),
        end_row_(ny_),
        grid_(grid),
        tiles_(tiles),
        product_(product),
        request_(request) {
    const std::int64_t n = tiles.first(tiles.count());
    bounded_ = product.spacing() > 0 && std::all_of(x, x + n, [](double value) { return value >= 0; });
    if (bounded_) slack_ = -product.short_range().lowest() * std::accumulate(x, x + n, 0.0);
    lowest_ = request.tile_lowest;
    if (request.undeformed_gap.type == RC_SINGLE)
      single_gap_ = static_cast<const float*>(request.undeformed_gap.data);
    else
      double_gap_ = static_cast<const double*>(request.undeformed_gap.data);
    if (request.rows > 0) {
      first_row_ = request.first_row;
      end_row_ = first_row_ + request.rows;
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

  double gap(std::int64_t point) const {
    const std::int64_t at = point - first_row_ * nx_;
    return single_gap_ ? single_gap_[at] : double_gap_[at];
  }
  bool looked_at(std::int64_t point) const { return !request_.mask || request_.mask[point - first_row_ * nx_]; }
  // Rows of points in a row of tiles that are looked at, from its first one on.
  std::int64_t begin(std::int64_t row) const { return std::max<std::int64_t>(0, first_row_ - row * side); }
  std::int64_t end(std::int64_t row) const { return std::min(height(row), end_row_ - row * side); }

  // The lowest gap of each tile in a row of tiles. least [nx]: scratch, the lowest gap of each column of points; with it the gap
  // is read once, in its order in memory.
  void find_lowest(std::int64_t row, double* least, double* lowest) const {
    constexpr double none = std::numeric_limits<double>::infinity();
    std::fill_n(least, nx_, none);
    for (std::int64_t r = begin(row); r < end(row); ++r) {
      const std::int64_t first = (row * side + r - first_row_) * nx_;
      const std::uint8_t* const mask = request_.mask ? request_.mask + first : nullptr;
      const auto lower = [&](const auto* gap) {
        if (mask)
          for (std::int64_t i = 0; i < nx_; ++i) least[i] = mask[i] && gap[i] < least[i] ? gap[i] : least[i];
        else
          for (std::int64_t i = 0; i < nx_; ++i) least[i] = gap[i] < least[i] ? gap[i] : least[i];
      };
      if (single_gap_)
        lower(single_gap_ + first);
      else
        lower(double_gap_ + first);
    }
    for (std::int64_t column = 0; column < grid_.nx; ++column)
      lowest[column] = *std::min_element(least + column * side, least + column * side + width(column));
  }

  // Whether the smooth part shows that a tile stays apart.
  bool stays_apart(TilePlace place) const {
    alignas(64) double smooth[cells_of_tile];
    product_.smooth_tile(place, smooth);
    for (std::int64_t r = begin(place.y); r < end(place.y); ++r)
      for (std::int64_t c = 0; c < width(place.x); ++c) {
        const std::int64_t point = (place.y * side + r) * nx_ + place.x * side + c;
        const double deflection = request_.unit * (smooth[r * side + c] - slack_);
        if (looked_at(point) && !(request_.approach - gap(point) <= deflection)) return false;
      }
    return true;
  }

  // Tiles without points of the domain that are not proven to stay apart.
  void select(std::vector<TilePlace>& list) {
    std::vector<std::uint8_t> chosen(static_cast<std::size_t>(grid_.tiles()));
    const std::int64_t room = lowest_ ? 0 : nx_ + grid_.nx;
    Array<double> scratch(static_cast<std::size_t>(team_.threads * room));
    roughcontact::for_each(team_, grid_.ny, true, [&](std::int64_t row, std::int64_t thread) {
      if (begin(row) >= end(row)) return;
      double* const least = scratch.data() + thread * room;
      const double* const lowest = lowest_ ? lowest_ + row * grid_.nx : least + nx_;
      if (!lowest_) find_lowest(row, least, least + nx_);
      for (std::int64_t column = 0; column < grid_.nx; ++column) {
        const TilePlace place{column, row};
        if (!(request_.approach - lowest[column] > 0)) continue;  // H has no negative entry
        if (tiles_.at(column, row) >= 0 || (bounded_ && stays_apart(place))) continue;
        chosen[static_cast<std::size_t>(row * grid_.nx + column)] = 1;
      }
    });
    for (std::int64_t tile = 0; tile < grid_.tiles(); ++tile)
      if (chosen[static_cast<std::size_t>(tile)]) list.push_back({tile % grid_.nx, tile / grid_.nx});
  }

  // Products at the tiles, a batch at a time: written to y at points of the domain, compared with the surface elsewhere.
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
    for (std::int64_t r = begin(place.y); r < end(place.y); ++r)
      for (std::int64_t c = 0; c < width(place.x); ++c) {
        const std::int64_t point = (place.y * side + r) * nx_ + place.x * side + c;
        if (inside[r * side + c] || !looked_at(point)) continue;
        const double depth = request_.approach - gap(point) - request_.unit * value[r * side + c];
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
  std::int64_t first_row_ = 0, end_row_;  // rows of points that are looked at
  const Frame& grid_;
  const Tiles& tiles_;
  const Product<double>& product_;
  rc_screen& request_;
  // request_'s, where it has them
  const double* lowest_ = nullptr;
  const float* single_gap_ = nullptr;  // one of them is null
  const double* double_gap_ = nullptr;
  bool bounded_ = false;  // the bound holds
  double slack_ = 0, largest_ = 0;
};

}  // namespace

void Operator::screen(const double* x, rc_screen& request) {
  Product<double>& product = screen_product();
  product.load(x);
  Screen(spec_, grid_, tiles_, product, x, request).run();
}

}  // namespace rc_split
