#include "choice.h"

#include <algorithm>
#include <cmath>

#include "scheme.h"
#include "short_range.h"

namespace rc_split {

namespace {

// Seconds in single precision, with wide vectors: a row of a tile for one source, a value of the coarse transform per doubling of
// its length, a tile spread or interpolated. Double precision takes twice that.
constexpr double row_time = 0.5e-9, transform_time = 0.3e-9, tile_time = 0.4e-6;

// A look at a place where a tile with sources may be.
constexpr double visit_time = 3e-9;

// The trial set holds the contact with a halo.
constexpr double share_in_contact = 0.25;

// Up to this many tiles a table of H between all of them stays in the cache.
constexpr std::int64_t largest_direct = 8;

// How many tiles lie within a rectangle of the box.
class Occupancy {
 public:
  explicit Occupancy(const Tiles& tiles) : box_(tiles.box()), sums_(static_cast<std::size_t>((box_.nx + 1) * (box_.ny + 1))) {
    for (std::int64_t y = 0; y < box_.ny; ++y)
      for (std::int64_t x = 0; x < box_.nx; ++x)
        sums_[index(x + 1, y + 1)] = sums_[index(x + 1, y)] + sums_[index(x, y + 1)] - sums_[index(x, y)] +
                                     (tiles.at(box_.x + x, box_.y + y) >= 0 ? 1 : 0);
  }
  std::int64_t around(TilePlace tile, std::int64_t rx, std::int64_t ry) const {
    const std::int64_t left = std::max<std::int64_t>(tile.x - box_.x - rx, 0),
                       right = std::min(tile.x - box_.x + rx + 1, box_.nx);
    const std::int64_t top = std::max<std::int64_t>(tile.y - box_.y - ry, 0),
                       bottom = std::min(tile.y - box_.y + ry + 1, box_.ny);
    return sums_[index(right, bottom)] - sums_[index(left, bottom)] - sums_[index(right, top)] + sums_[index(left, top)];
  }

 private:
  std::size_t index(std::int64_t x, std::int64_t y) const { return static_cast<std::size_t>(y * (box_.nx + 1) + x); }

  Frame box_;
  std::vector<std::int64_t> sums_;
};

}  // namespace

template <class T> double cutoff(int spacing, double hx, double hy) { return scheme<T>.reach * spacing * std::max(hx, hy); }

template <class T> Plan choose(const Tiles& tiles, const Frame& frame, std::int64_t targets, double hx, double hy, int wanted) {
  const double precision = sizeof(T) / sizeof(float);
  const double sources = share_in_contact * static_cast<double>(tiles.first(tiles.count()));
  if (std::max(frame.nx, frame.ny) <= largest_direct)
    return {0, precision * sources * static_cast<double>(targets) * side * row_time};
  const Occupancy occupancy(tiles);
  const bool everywhere = targets > tiles.count();  // all tiles of the frame
  Plan best;
  for (int spacing : {4, 8, 16}) {
    if (wanted != 0 && spacing != wanted) continue;
    const Range range = Range::within(cutoff<T>(spacing, hx, hy), hx, hy);
    double near = 0;  // by the box around the circle
    for (std::int64_t tile = 0; tile < tiles.count(); ++tile) {
      const std::int64_t reached =
          everywhere ? (2 * range.x + 1) * (2 * range.y + 1) : occupancy.around(tiles.place(tile), range.x, range.y);
      near += static_cast<double>(tiles.entries(tile) * reached);
    }
    const double visits = static_cast<double>(targets * (2 * range.x + 1) * (2 * range.y + 1));
    const auto length = [&](std::int64_t n) {
      return 2 * static_cast<double>(n * side / spacing + scheme<T>.nodes + scheme<T>.bend);
    };
    const double values = length(frame.nx) * length(frame.ny);
    const double seconds =
        precision * (0.75 * near * share_in_contact * side * row_time + 0.5 * values * std::log2(values) * transform_time +
                     static_cast<double>(targets + tiles.count()) * tile_time) +
        visits * visit_time;
    if (best.spacing == 0 || seconds < best.seconds) best = {spacing, seconds};
  }
  return best;
}

template double cutoff<float>(int, double, double);
template double cutoff<double>(int, double, double);
template Plan choose<float>(const Tiles&, const Frame&, std::int64_t, double, double, int);
template Plan choose<double>(const Tiles&, const Frame&, std::int64_t, double, double, int);

}  // namespace rc_split
