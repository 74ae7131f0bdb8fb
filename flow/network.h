// The gap as a network: cells are its nodes, edges between neighbours conduct.
#pragma once

#include <cstdint>
#include <limits>

#include "stop.h"

namespace rc::flow {

inline constexpr std::int64_t outside = -1;  // inlet and outlet, one node: an edge from the inlet has a jump of 1

struct Grid {
  std::int64_t nx, ny;   // the flow is along x
  double along, across;  // width over distance of edges along x and y
  bool cell;             // x repeats, with a jump of 1 over each period; false: inlet and outlet
  bool sides;            // y repeats
  std::int64_t size() const { return nx * ny; }
};

enum class Side : std::uint8_t { inlet, left, right, above, below, none };

// The drop of the pressure along an edge is phi(from) - phi(to) + jump.
struct Edge {
  std::int64_t from, to;
  double conductance;
  double jump_x, jump_y;
  Side of_to, of_from;  // where the edge lies, seen from either end; a tree of paths names its edges so
};

inline double cube(double g) { return g * g * g; }
inline double in_series(double a, double b) { return 2 * a * (b / (a + b)); }

// Calls visit for each edge that conducts. gap(i) is the height of cell i, 0: closed.
template <class Gap, class Visit> void each_edge(const Grid& grid, const Gap& gap, const Visit& visit) {
  for (std::int64_t y = 0; y < grid.ny; ++y) {
    stop_if_asked();
    const std::int64_t row = y * grid.nx, next = y + 1 < grid.ny ? row + grid.nx : 0;
    for (std::int64_t x = 0; x < grid.nx; ++x) {
      const std::int64_t i = row + x;
      const double k = cube(gap(i));
      if (!(k > 0)) continue;
      if (!grid.cell && x == 0) visit(Edge{outside, i, 2 * k * grid.along, 1, 0, Side::inlet, Side::none});
      const bool last = x + 1 == grid.nx;
      if (last && !grid.cell) visit(Edge{i, outside, 2 * k * grid.along, 0, 0, Side::none, Side::none});
      if (!last || grid.cell) {
        const std::int64_t j = last ? row : i + 1;
        if (const double other = cube(gap(j)); other > 0)
          visit(Edge{i, j, in_series(k, other) * grid.along, last ? 1.0 : 0.0, 0, Side::left, Side::right});
      }
      if (next > 0 || grid.sides) {
        const std::int64_t j = next + x;
        if (const double other = cube(gap(j)); other > 0)
          visit(Edge{i, j, in_series(k, other) * grid.across, 0, next > 0 ? 0.0 : 1.0, Side::above, Side::below});
      }
    }
  }
}

// The neighbour across a side, or `outside`.
inline std::int64_t neighbour(const Grid& grid, std::int64_t i, Side side) {
  const std::int64_t x = i % grid.nx, wide = grid.nx, n = grid.size();
  if (side == Side::left) return x > 0 ? i - 1 : grid.cell ? i + wide - 1 : outside;
  if (side == Side::right) return x + 1 < wide ? i + 1 : grid.cell ? i - wide + 1 : outside;
  if (side == Side::above) return i >= wide ? i - wide : grid.sides ? i + n - wide : outside;
  if (side == Side::below) return i + wide < n ? i + wide : grid.sides ? i + wide - n : outside;
  return outside;
}

// A sum whose relative error is at most 4 epsilon if all terms have one sign.
class Sum {
 public:
  void add(double term) {
    const double next = sum_ + term, part = next - sum_;
    rest_ += (sum_ - (next - part)) + (term - part);
    sum_ = next;
  }
  double value() const { return sum_ + rest_; }

 private:
  double sum_ = 0, rest_ = 0;
};

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace rc::flow
