#include "near_field.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "failure.h"

namespace rc_cholmod {

using rc_common::Point;

namespace {

// Wendland (1995), phi_{3,1}: positive definite in up to three dimensions, and zero from r = 1 on. H merely cut off at a radius
// is indefinite. Its entries times phi of the distances are the Schur product of a positive definite matrix and a positive
// semidefinite one with ones on the diagonal, which is positive definite.
double taper(double r) { return r < 1.0 ? std::pow(1.0 - r, 4) * (4.0 * r + 1.0) : 0.0; }

struct Neighbour {
  std::int64_t dx, dy;
  double weight;
};

// Which points are near one another on a grid.
class Nearness {
 public:
  Nearness(const rc_system& system, double radius)
      : nx_(system.nx),
        ny_(system.ny),
        wraps_(system.op == RC_OPERATOR_HALFSPACE && system.boundary == RC_BOUNDARY_PERIODIC),
        // On a periodic grid a pair has many distances. The taper must end at half a period, so that only the shortest counts.
        radius_(wraps_ ? std::min(radius, 0.5 * static_cast<double>(std::min(nx_, ny_))) : radius),
        reach_x_(std::min(static_cast<std::int64_t>(radius_), nx_ - 1)),
        reach_y_(std::min(static_cast<std::int64_t>(radius_), ny_ - 1)) {}

  // An upper bound of a point's neighbours, itself among them.
  double most() const { return (2.0 * static_cast<double>(reach_x_) + 1.0) * (2.0 * static_cast<double>(reach_y_) + 1.0); }

  double weight(std::int64_t dx, std::int64_t dy) const {
    return taper(std::hypot(static_cast<double>(dx), static_cast<double>(dy)) / radius_);
  }
  double weight(Point a, Point b) const { return weight(shortest(a.x - b.x, nx_), shortest(a.y - b.y, ny_)); }

  std::vector<Neighbour> neighbours() const {
    std::vector<Neighbour> all;
    for (std::int64_t dy = -reach_y_; dy <= reach_y_; ++dy)
      for (std::int64_t dx = -reach_x_; dx <= reach_x_; ++dx)
        if (const double by = weight(dx, dy); by > 0.0) all.push_back({dx, dy, by});
    return all;
  }

  // Numbers of the grid's points; -1: outside.
  std::int64_t number(std::int64_t x, std::int64_t y) const {
    if (wraps_) {
      x = (x + nx_) % nx_;
      y = (y + ny_) % ny_;
    } else if (x < 0 || y < 0 || x >= nx_ || y >= ny_) {
      return -1;
    }
    return y * nx_ + x;
  }
  std::int64_t points() const { return nx_ * ny_; }

 private:
  std::int64_t shortest(std::int64_t d, std::int64_t period) const {
    d = std::abs(d);
    return wraps_ ? std::min(d, period - d) : d;
  }

  std::int64_t nx_, ny_;
  bool wraps_;
  double radius_;
  std::int64_t reach_x_, reach_y_;
};

}  // namespace

NearField::NearField(Session& session, const rc_common::MemoryLimit& limit, const rc_operator_spec& spec,
                     const rc_common::Influence& H, std::span<const Point> points, double radius, double shift)
    : session_(session) {
  const Nearness nearness(*spec.system, std::max(radius, 0.5));
  const auto n = static_cast<std::int64_t>(points.size());
  // Looks at all pairs of points, or looks each point's neighbours up, whichever is less.
  const bool by_pairs = nearness.most() >= static_cast<double>(n);
  const std::vector<Neighbour> near = by_pairs ? std::vector<Neighbour>() : nearness.neighbours();
  const double most =
      0.5 * static_cast<double>(n) * (static_cast<double>(by_pairs ? n : static_cast<std::int64_t>(near.size())) + 1.0);
  limit.require("the near field", n, 12.0 * most);
  std::vector<int> position;
  if (!by_pairs) {
    position.assign(static_cast<std::size_t>(nearness.points()), -1);
    for (std::size_t i = 0; i < points.size(); ++i)
      position[static_cast<std::size_t>(nearness.number(points[i].x, points[i].y))] = static_cast<int>(i);
  }
  Session::Sparse A = session.sparse(n, n, most, -1);
  int *column = columns_of(*A), *row = rows_of(*A), count = 0;
  column[0] = 0;
  for (std::int64_t j = 0; j < n; ++j) {
    if (j % 64 == 0) check_for_stop(spec);
    const Point point = points[static_cast<std::size_t>(j)];
    const auto add = [&](std::int64_t i, double weight) {
      H.column(points.subspan(static_cast<std::size_t>(i), 1), point, values_of(*A) + count);
      values_of(*A)[count] *= weight;
      row[count++] = static_cast<int>(i);
    };
    for (std::int64_t i = j; by_pairs && i < n; ++i)
      if (const double weight = nearness.weight(points[static_cast<std::size_t>(i)], point); weight > 0.0) add(i, weight);
    for (const Neighbour& neighbour : near) {
      const std::int64_t number = nearness.number(point.x + neighbour.dx, point.y + neighbour.dy);
      const std::int64_t i = number < 0 ? -1 : position[static_cast<std::size_t>(number)];
      if (i >= j) add(i, neighbour.weight);
    }
    column[j + 1] = count;
  }
  check_for_stop(spec);
  A->sorted = 0;
  session.order(false);
  L_ = session.analyze(*A);
  limit.require("the near field's factor", n, 12.0 * session.common()->lnz, 12.0 * most);
  if (!session.factorize(*A, shift, *L_))
    fail(RC_ERR_NUMERIC, "the near field is not positive definite at unknown ", L_->minor + 1, " of ", n,
         "; the matrix must be symmetric positive definite");
  A.reset();
  session.to_columns(*L_);
}

}  // namespace rc_cholmod
