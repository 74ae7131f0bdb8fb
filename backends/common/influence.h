// Entries of the influence matrix H by grid points. Nothing of the size of H is stored here.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <roughcontact/plugin.hpp>
#include <span>
#include <vector>

namespace rc_common {

struct Point {
  std::int64_t y, x;  // in this order points compare as their numbers y*nx + x do
  auto operator<=>(const Point&) const = default;
};

// Neighbours in one row of the grid whose values follow each other in a vector.
struct Run {
  Point first;
  std::int64_t count, position;
};

std::vector<Run> runs_of(std::span<const Point> points);

class Influence {
 public:
  virtual ~Influence() = default;

  // Called before entries of points within mx x my cells are asked for.
  virtual void prepare(std::int64_t mx, std::int64_t my) = 0;
  // Sets the eigenvalue of H for the constant vector; only periodic systems have one.
  virtual void set_zero_mode(double zero_mode) = 0;
  // out[k] = H(rows[k], column)
  virtual void column(std::span<const Point> rows, Point column, double* out) const = 0;
  // y = H[targets, points] x. The cost is the number of nonzeros of x times the number of targets.
  virtual void multiply(std::span<const Point> points, const double* x, std::span<const Run> targets, double* y) const = 0;
};

std::unique_ptr<Influence> make_influence(const rc_host*, const rc_operator_spec&, const roughcontact::Component&);

}  // namespace rc_common
