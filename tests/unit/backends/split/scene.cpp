#include "scene.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "kernel/kernel.h"

extern "C" rc_status rc_builtin_split(const rc_host*, const rc_plugin**);

namespace split {

const rc_backend& backend() {
  const rc_plugin* plugin = nullptr;
  if (rc_builtin_split(nullptr, &plugin) != RC_OK) std::abort();
  return *plugin->backends[0];
}

Reference::Reference(const Grid& grid) : grid_(grid), table_(static_cast<std::size_t>(grid.points())) {
  rc::kernel::coefficients(*rc::kernel::find(grid.kernel), grid.hx, grid.hy, grid.nx, grid.ny, table_.data());
}

Vector Reference::product(const Index& points, const Index& domain, const Vector& x) const {
  Vector y;
  y.reserve(points.size());
  for (const std::int64_t point : points) {
    const std::int64_t px = point % grid_.nx, py = point / grid_.nx;
    double sum = 0;
    for (std::size_t j = 0; j < domain.size(); ++j)
      if (x[j] != 0)
        sum += x[j] * table_[static_cast<std::size_t>(std::abs(py - domain[j] / grid_.nx) * grid_.nx +
                                                      std::abs(px - domain[j] % grid_.nx))];
    y.push_back(sum);
  }
  return y;
}

Operator::Operator(const Grid& grid, const char* spacing, const char* threads)
    : Host(spacing, threads),
      contract::Operator(backend(), host, contract::halfspace(RC_BOUNDARY_FREE, grid.nx, grid.ny, grid.hx, grid.hy), grid.kernel),
      points_(grid.points()) {}

Vector Operator::every_product(const Vector& x, bool float_first) {
  Vector single;
  if (float_first) single = apply_float(x);
  Vector all = apply(x);
  if (!float_first) single = apply_float(x);
  const Vector gap(static_cast<std::size_t>(points_), 0.5);
  Vector y(x.size()), depth(100);
  Index found(100);
  rc_screen request{.struct_size = sizeof(rc_screen),
                    .approach = 20.0,
                    .unit = 1.0,
                    .undeformed_gap = {gap.data(), RC_NATIVE, 0, nullptr},
                    .y = y.data(),
                    .room = 100,
                    .found = found.data(),
                    .depth = depth.data()};
  screen(x, request);
  y.push_back(static_cast<double>(request.n_found));
  for (const Vector& values : {single, y, depth, field(x)}) all.insert(all.end(), values.begin(), values.end());
  return all;
}

double uniform(Random& random) { return static_cast<double>(random()) / 4294967296.0; }

Index islands(const Grid& grid, double share, Random& random) {
  std::vector<char> inside(static_cast<std::size_t>(grid.points()));
  double covered = 0;
  const double width = static_cast<double>(grid.nx), height = static_cast<double>(grid.ny);
  while (covered < share * static_cast<double>(grid.points())) {
    const double x = uniform(random) * width, y = uniform(random) * height, radius = 0.5 + 12 * uniform(random) * uniform(random);
    const auto from = [radius](double at) { return static_cast<std::int64_t>(std::max(0.0, at - radius)); };
    const auto to = [radius](double at, double end) { return static_cast<std::int64_t>(std::min(end - 1, at + radius)); };
    for (std::int64_t iy = from(y); iy <= to(y, height); ++iy)
      for (std::int64_t ix = from(x); ix <= to(x, width); ++ix) {
        char& point = inside[static_cast<std::size_t>(iy * grid.nx + ix)];
        if (point || std::hypot(static_cast<double>(ix) - x, static_cast<double>(iy) - y) > radius) continue;
        point = 1;
        ++covered;
      }
  }
  Index index;
  for (std::int64_t i = 0; i < grid.points(); ++i)
    if (inside[static_cast<std::size_t>(i)]) index.push_back(i);
  return index;
}

Vector pressures(const Index& domain, Random& random) {
  Vector x(domain.size());
  for (double& value : x) value = std::max(0.0, 2 * uniform(random) - 1);
  return x;
}

Index every_point(const Grid& grid) { return contract::range(0, grid.points()); }

Index some_of(const Index& points, std::size_t count) {
  Index some;
  const std::size_t step = points.size() / count + 1;
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
  return some;
}

double largest(const Vector& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

}  // namespace split
