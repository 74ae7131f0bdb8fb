// Solves with H[a,a] for sets of grid points that change a little from one call to the next.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "influence.h"
#include "memory_limit.h"
#include "updatable_cholesky.h"

namespace rc_dense {

class WorkingSet {
 public:
  explicit WorkingSet(MemoryLimit limit) : limit_(limit) {}

  // H[points, points] x = b for ascending points; held: bytes in use elsewhere. On failure the factor is dropped.
  void solve(const Influence&, std::span<const Point> points, const double* b, double* x, double held);
  void clear();
  double bytes() const { return UpdatableCholesky::bytes(static_cast<double>(factor_.capacity())); }

 private:
  void update(const Influence&, std::span<const Point> points, double held);
  void remove(std::span<const std::int64_t> removed, std::vector<Point>& added);
  void append(const Influence&, std::span<const Point> added, double held);
  void refine(const Influence&, std::span<const double> b, std::span<double> x) const;
  std::vector<std::int64_t> ascending() const;

  MemoryLimit limit_;
  UpdatableCholesky factor_;
  std::vector<Point> points_;  // in the factor's order: that of their arrival
  std::int64_t rotated_ = 0;   // unknowns taken out by rotations since the factor was empty
};

}  // namespace rc_dense
