#include "formats/resample.h"

#include <algorithm>
#include <cmath>

#include "formats/readers.h"

namespace rc::formats {

namespace {

// The points of a map that give the height at one place along an axis, and their weights.
struct Stencil {
  std::int64_t point[4] = {};
  double weight[4] = {};
  int size = 0;  // 0: outside of the map

  void add(std::int64_t at, double by) {
    if (by == 0) return;
    const auto found = std::find(point, point + size, at);
    if (found != point + size) {
      weight[found - point] += by;
      return;
    }
    point[size] = at;
    weight[size++] = by;
  }
};

class Interpolator {
 public:
  Interpolator(std::int64_t count, bool repeats, Interpolation method) : count_(count), repeats_(repeats), method_(method) {}

  Stencil at(double place) const {
    constexpr double round_off = 1e-9;  // of a pitch
    Stencil stencil;
    const double last = static_cast<double>(count_ - 1);
    if (std::abs(place - std::round(place)) < round_off) place = std::round(place);
    if (!repeats_ && !(place >= 0 && place <= last)) return stencil;
    double cell = std::floor(place);
    if (!repeats_ && cell == last && place == last && last > 0) cell = last - 1;
    const double t = place - cell;
    const auto first = static_cast<std::int64_t>(repeats_ ? std::fmod(cell, static_cast<double>(count_)) : cell);
    const bool linear = method_ == Interpolation::linear || (!repeats_ && count_ < 3);
    if (linear || t == 0 || t == 1) {
      put(first, 1 - t, stencil);
      put(first + 1, t, stencil);
      return stencil;
    }
    put(first - 1, 0.5 * t * (-1 + t * (2 - t)), stencil);
    put(first, 1 + t * t * (-2.5 + 1.5 * t), stencil);
    put(first + 1, 0.5 * t * (1 + t * (4 - 3 * t)), stencil);
    put(first + 2, 0.5 * t * t * (t - 1), stencil);
    return stencil;
  }

 private:
  void put(std::int64_t i, double weight, Stencil& to) const {
    if (repeats_) {
      to.add(((i % count_) + count_) % count_, weight);
    } else if (i == -1) {  // 3 z_0 - 3 z_1 + z_2
      add_edge(0, 1, weight, to);
    } else if (i == count_) {
      add_edge(count_ - 1, -1, weight, to);
    } else if (weight != 0) {
      to.add(i, weight);
    }
  }
  static void add_edge(std::int64_t edge, std::int64_t inwards, double weight, Stencil& to) {
    to.add(edge, 3 * weight);
    to.add(edge + inwards, -3 * weight);
    to.add(edge + 2 * inwards, weight);
  }

  std::int64_t count_;
  bool repeats_;
  Interpolation method_;
};

std::vector<Stencil> stencils(const Interpolator& axis, const Samples& samples) {
  std::vector<Stencil> found;
  for (std::int64_t i = 0; i < samples.count; ++i)
    found.push_back(axis.at(samples.first + static_cast<double>(i) * samples.step));
  return found;
}

}  // namespace

std::vector<double> heights_at(const Surface& surface, bool repeats, Interpolation method, const Samples& x, const Samples& y) {
  const std::vector<Stencil> along_x = stencils({surface.nx, repeats, method}, x),
                             along_y = stencils({surface.ny, repeats, method}, y);
  std::vector<double> heights;
  heights.reserve(along_x.size() * along_y.size());
  for (const Stencil& v : along_y)
    for (const Stencil& u : along_x) {
      double sum = 0;
      for (int k = 0; k < v.size; ++k)
        for (int j = 0; j < u.size; ++j)
          sum += v.weight[k] * u.weight[j] * surface.heights[static_cast<std::size_t>(v.point[k] * surface.nx + u.point[j])];
      heights.push_back(v.size > 0 && u.size > 0 ? sum : missing_height);
    }
  return heights;
}

}  // namespace rc::formats
