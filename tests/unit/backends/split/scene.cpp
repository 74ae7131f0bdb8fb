#include "scene.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <numeric>

#include "kernel/kernel.h"
#include "support/cmocka.hpp"
#include "support/unit_system.h"

extern "C" rc_status rc_builtin_split(const rc_host*, const rc_plugin**);

namespace split {

const rc_backend& backend() {
  const rc_plugin* plugin = nullptr;
  if (rc_builtin_split(nullptr, &plugin) != RC_OK) std::abort();
  return *plugin->backends[0];
}

namespace {

rc_system system_of(const Grid& grid) {
  rc_system system = support::unit_system();
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = grid.nx;
  system.ny = grid.ny;
  system.hx = grid.hx;
  system.hy = grid.hy;
  return system;
}

void check(rc_status status) {
  if (status != RC_OK) fail_msg("status %d: %s", static_cast<int>(status), contract::StandInHost::message().c_str());
}

}  // namespace

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

Operator::Operator(const Grid& grid, const std::string& spacing, const std::string& threads)
    : host_(backend()), system_(system_of(grid)), kernel_(grid.kernel), team_(std::stoll(threads)) {
  host_.set("split.spacing", spacing);
  spec_ = {sizeof(rc_operator_spec), &system_, kernel_.c_str(), host_.options(), &team_, nullptr};
  check(backend().create(&host_, &spec_, &self_));
}

Operator::~Operator() { backend().destroy(self_); }

void Operator::bind(const Index& domain) {
  domain_ = domain;
  const rc_domain bound{sizeof(rc_domain), static_cast<std::int64_t>(domain_.size()), domain_.data(), 0.0};
  check(backend().bind(self_, &bound));
}

Vector Operator::apply(const Vector& x) {
  Vector y(domain_.size(), std::numeric_limits<double>::quiet_NaN());
  check(backend().apply(self_, x.data(), y.data()));
  return y;
}

Floats Operator::apply_float(const Vector& x) {
  const Floats single(x.begin(), x.end());
  Floats y(domain_.size(), std::numeric_limits<float>::quiet_NaN());
  check(backend().apply_float(self_, single.data(), y.data()));
  return y;
}

Vector Operator::field(const Vector& x) {
  Vector y(static_cast<std::size_t>(system_.nx * system_.ny), std::numeric_limits<double>::quiet_NaN());
  check(backend().field(self_, x.data(), y.data()));
  return y;
}

void Operator::screen(const Vector& x, rc_screen& request) { check(backend().screen(self_, x.data(), &request)); }

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

Index every_point(const Grid& grid) {
  Index index(static_cast<std::size_t>(grid.points()));
  std::iota(index.begin(), index.end(), 0);
  return index;
}

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

namespace {

template <class Values> double difference(const Values& a, const Vector& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double off = std::abs(static_cast<double>(a[i]) - b[i]);
    if (!(off <= result)) result = off;  // a NaN stays
  }
  return result;
}

}  // namespace

double largest_difference(const Vector& a, const Vector& b) { return difference(a, b); }
double largest_difference(const Floats& a, const Vector& b) { return difference(a, b); }

double effort() {
  const char* quick = std::getenv("RC_TEST_QUICK");
  return quick && *quick && std::strcmp(quick, "0") != 0 ? 0.1 : 1.0;
}

}  // namespace split
