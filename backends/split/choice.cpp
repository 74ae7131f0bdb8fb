#include "choice.h"

#include <algorithm>
#include <cmath>

#include "scheme.h"
#include "short_range.h"

namespace rc_split {

namespace {

// Seconds in single precision with wide vectors: for a row of a tile and one source; for a value of the coarse transform, per
// doubling of its length; for a tile spread or interpolated. Double precision takes twice that.
constexpr double row_time = 0.5e-9, transform_time = 0.3e-9, tile_time = 0.4e-6;

// Seconds to look whether there is a tile with sources at a place.
constexpr double visit_time = 3e-9;

// Set-up: seconds for an entry of the short range and for a value of the coarse grid's kernel, and the number of products that
// share them, which is small in double precision.
constexpr double entry_time = 0.2e-6, kernel_time = 60e-9;
template <class T> constexpr double products_to_come = sizeof(T) == sizeof(float) ? 20 : 4;

// Bytes that a coarse grid may take that is not the coarsest: a fixed part, and a part for each point of the domain.
constexpr double free_memory = 64.0 * (1 << 20), memory_per_point = 24;

// The part of the trial set that carries pressure: it holds the contact with a halo.
constexpr double share_in_contact = 0.25;

// Up to this many tiles a side, a table of H between all of them stays in the cache.
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
  std::vector<std::int32_t> sums_;
};

}  // namespace

template <class T> double cutoff(int spacing, double hx, double hy) { return scheme<T>.reach * spacing * std::max(hx, hy); }

template <class T> Plan choose(const Tiles& tiles, const Frame& frame, Targets targets, double hx, double hy, int wanted) {
  const double precision = sizeof(T) / sizeof(float);
  const bool everywhere = targets == Targets::frame;
  const std::int64_t asked = everywhere ? frame.tiles() : tiles.count();
  const double points = static_cast<double>(tiles.first(tiles.count())), sources = share_in_contact * points;
  if (std::max(frame.nx, frame.ny) <= largest_direct)
    return {0, precision * sources * static_cast<double>(asked) * side * row_time};
  const Occupancy occupancy(tiles);
  Plan best;
  double least = 0;
  for (int spacing : {4, 8, 16}) {
    if (wanted != 0 && spacing != wanted) continue;
    const Range range = Range::within(cutoff<T>(spacing, hx, hy), hx, hy);
    double near = 0;  // counted in the box around the cutoff's circle
    for (std::int64_t tile = 0; tile < tiles.count(); ++tile) {
      const std::int64_t reached =
          everywhere ? (2 * range.x + 1) * (2 * range.y + 1) : occupancy.around(tiles.place(tile), range.x, range.y);
      near += static_cast<double>(tiles.entries(tile) * reached);
    }
    const double visits = static_cast<double>(asked * (2 * range.x + 1) * (2 * range.y + 1));
    const auto length = [&](std::int64_t n) {
      return 2 * static_cast<double>(n * side / spacing + scheme<T>.nodes + scheme<T>.bend);
    };
    const double values = length(frame.nx) * length(frame.ny);
    const double seconds =
        precision * (0.75 * near * share_in_contact * side * row_time + 0.5 * values * std::log2(values) * transform_time +
                     static_cast<double>(asked + tiles.count()) * tile_time) +
        visits * visit_time;
    // The rows and the kernel's eigenvalues; the kernel while it is transformed.
    const double memory = values * (0.75 * sizeof(T) + 0.25 * sizeof(double));
    if (spacing < 16 && wanted == 0 && memory > free_memory + memory_per_point * points) continue;
    const double reach = cutoff<T>(spacing, 1, 1);
    const double with_set_up = seconds + (reach * reach * entry_time + 0.25 * values * kernel_time) / products_to_come<T>;
    if (best.spacing != 0 && with_set_up >= least) continue;
    best = {spacing, seconds};
    least = with_set_up;
  }
  return best;
}

template double cutoff<float>(int, double, double);
template double cutoff<double>(int, double, double);
template Plan choose<float>(const Tiles&, const Frame&, Targets, double, double, int);
template Plan choose<double>(const Tiles&, const Frame&, Targets, double, double, int);

}  // namespace rc_split
