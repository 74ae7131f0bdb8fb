#include "near_field.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "failure.h"

namespace rc_cholmod {

using rc_common::Point;

namespace {

// Wendland (1995), phi_{3,1}: positive definite in up to three dimensions and zero from r = 1 on. H merely cut off at a radius is
// indefinite; its entries times phi of the distances are a Schur product of a positive definite matrix and a positive
// semidefinite one with ones on the diagonal, hence positive definite.
double taper(double r) { return r < 1.0 ? std::pow(1.0 - r, 4) * (4.0 * r + 1.0) : 0.0; }

struct Neighbour {
  std::int64_t dx, dy;
  double weight;
};

std::vector<Neighbour> neighbours(double radius) {
  std::vector<Neighbour> all;
  const auto reach = static_cast<std::int64_t>(radius);
  for (std::int64_t dy = -reach; dy <= reach; ++dy)
    for (std::int64_t dx = -reach; dx <= reach; ++dx)
      if (const double weight = taper(std::hypot(static_cast<double>(dx), static_cast<double>(dy)) / radius); weight > 0.0)
        all.push_back({dx, dy, weight});
  return all;
}

// The position of the point (x, y), or -1.
class Lookup {
 public:
  Lookup(const rc_system& system, std::span<const Point> points)
      : nx_(system.nx),
        ny_(system.ny),
        wraps_(system.op == RC_OPERATOR_HALFSPACE && system.boundary == RC_BOUNDARY_PERIODIC),
        position_(static_cast<std::size_t>(nx_ * ny_), -1) {
    for (std::size_t i = 0; i < points.size(); ++i)
      position_[static_cast<std::size_t>(points[i].y * nx_ + points[i].x)] = static_cast<int>(i);
  }

  bool wraps() const { return wraps_; }
  int at(std::int64_t x, std::int64_t y) const {
    if (wraps_) {
      x = (x + nx_) % nx_;
      y = (y + ny_) % ny_;
    } else if (x < 0 || y < 0 || x >= nx_ || y >= ny_) {
      return -1;
    }
    return position_[static_cast<std::size_t>(y * nx_ + x)];
  }

 private:
  std::int64_t nx_, ny_;
  bool wraps_;
  std::vector<int> position_;
};

}  // namespace

NearField::NearField(Session& session, const rc_common::MemoryLimit& limit, const rc_system& system,
                     const rc_common::Influence& H, std::span<const Point> points, double radius, double shift)
    : session_(session) {
  const Lookup lookup(system, points);
  // On a periodic grid a pair has one distance, the shortest, only if the taper ends before its images begin.
  if (lookup.wraps()) radius = std::min(radius, 0.5 * static_cast<double>(std::min(system.nx, system.ny)));
  const std::vector<Neighbour> near = neighbours(std::max(radius, 0.5));
  const auto n = static_cast<std::int64_t>(points.size());
  const double most = static_cast<double>(n) * (static_cast<double>(near.size()) + 1.0) / 2.0;
  limit.require("the near field", n, 12.0 * most);
  Session::Sparse A = session.sparse(n, n, most, -1);
  int *column = columns_of(*A), *row = rows_of(*A), count = 0;
  column[0] = 0;
  for (std::int64_t j = 0; j < n; ++j) {
    const Point point = points[static_cast<std::size_t>(j)];
    for (const Neighbour& neighbour : near)
      if (const int i = lookup.at(point.x + neighbour.dx, point.y + neighbour.dy); i >= j) {
        H.column(points.subspan(static_cast<std::size_t>(i), 1), point, values_of(*A) + count);
        values_of(*A)[count] *= neighbour.weight;
        row[count++] = i;
      }
    column[j + 1] = count;
  }
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
