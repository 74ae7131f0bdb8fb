// Solves with H[a,a] for sets of grid points that change a little from one call to the next.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/influence.h"
#include "updatable_cholesky.h"

namespace rc_dense {

using rc_common::Influence;
using rc_common::Point;

class WorkingSet {
 public:
  // H[points, points] x = b for ascending points. On failure the factor is dropped.
  void solve(const Influence&, std::span<const Point> points, const double* b, double* x);
  void clear();
  // Until the next solve the factor takes less memory.
  void rest() { factor_.rest(); }
  double bytes() const { return UpdatableCholesky::bytes(factor_.size()); }

 private:
  void update(const Influence&, std::span<const Point> points);
  void remove(std::span<const std::int64_t> removed, std::vector<Point>& added);
  void append(const Influence&, std::span<const Point> added);
  void refine(const Influence&, std::span<const double> b, std::span<double> x) const;
  std::vector<std::int64_t> ascending() const;

  UpdatableCholesky factor_;
  std::vector<Point> points_;  // in the factor's order, in which they arrived
  std::int64_t rotated_ = 0;   // unknowns taken out by rotations since the factor was empty
};

}  // namespace rc_dense
