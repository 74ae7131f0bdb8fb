#include "bounds.h"

#include <algorithm>
#include <cmath>

namespace rc::flow {

namespace {

// Of one term and of its sum, generously: a conductance is wrong by 8 half epsilons, a drop by 2, a square doubles both.
constexpr double term_rounding = 32 * epsilon;

double of(const std::vector<double>& potential, std::int64_t i) {
  return i == outside ? 0 : potential[static_cast<std::size_t>(i)];
}

// A flow without sources. On edges off the tree it is what the potential drives, as computed; on the tree it follows from
// conservation, and the rounding of the sums along the tree is bounded as they are made.
class Circulation {
 public:
  Circulation(const std::vector<double>& potential, bool along_y)
      : potential_(potential), along_y_(along_y), excess_(potential.size()), error_(potential.size()) {}

  double jump(const Edge& edge) const { return along_y_ ? edge.jump_y : edge.jump_x; }
  double off_tree(const Edge& edge) {
    const double flow = edge.conductance * (of(potential_, edge.from) - of(potential_, edge.to) + jump(edge));
    add(edge.from, flow, 0);
    add(edge.to, -flow, 0);
    return flow;
  }
  // The flow from its parent to a cell on which nothing hangs any more; error: out, of that flow.
  double on_tree(std::int64_t i, std::int64_t parent, double& error) {
    const auto at = static_cast<std::size_t>(i);
    error = error_[at];
    add(parent, excess_[at], error);
    return excess_[at];
  }

 private:
  void add(std::int64_t i, double flow, double error) {
    if (i == outside) return;
    const auto at = static_cast<std::size_t>(i);
    excess_[at] += flow;
    error_[at] = (error_[at] + error + epsilon * std::abs(excess_[at])) * (1 + 4 * epsilon);
  }

  const std::vector<double>& potential_;
  const bool along_y_;
  std::vector<double> excess_, error_;
};

bool in_tree(const Paths& paths, const Edge& edge) {
  const auto leads = [&](std::int64_t i, Side side) {
    return i != outside && side != Side::none && paths.parent[static_cast<std::size_t>(i)] == side;
  };
  return leads(edge.to, edge.of_to) || leads(edge.from, edge.of_from);
}

// The edge from a cell to its parent on the tree; orientation: out, 1 if the edge counts flows towards the cell, else -1.
Edge to_parent(const Grid& grid, const std::vector<double>& gap, std::int64_t i, Side side, double& orientation) {
  const auto k = [&](std::int64_t cell) { return cube(gap[static_cast<std::size_t>(cell)]); };
  if (side == Side::inlet) {
    orientation = 1;
    return {outside, i, 2 * k(i) * grid.along, 1, 0, side, Side::none};
  }
  const std::int64_t parent = neighbour(grid, i, side), n = grid.size();
  orientation = side == Side::left || side == Side::above ? 1 : -1;
  const bool is_along = side == Side::left || side == Side::right;
  const std::int64_t first = orientation > 0 ? parent : i;  // of the edge
  const bool wraps = is_along ? first % grid.nx + 1 == grid.nx : first + grid.nx >= n;
  const double conductance = in_series(k(i), k(parent)) * (is_along ? grid.along : grid.across);
  return {parent, i, conductance, wraps && is_along ? 1.0 : 0.0, wraps && !is_along ? 1.0 : 0.0, side, Side::none};
}

// Sums over edges of flows of one or two circulations: their net flow per period and dissipation, with their rounding.
struct Dissipation {
  Sum net[2][2];  // of circulation b along a
  Sum net_error;
  Sum xx, xy, yy, xy_error;

  void add(const Edge& edge, double orientation, const double* flow, const double* error, std::size_t fields) {
    const double jumps[] = {edge.jump_x, edge.jump_y};
    for (std::size_t b = 0; b < fields; ++b) {
      for (int a = 0; a < 2; ++a)
        if (jumps[a] != 0) net[a][b].add(orientation * flow[b] * jumps[a]);
      if (edge.jump_x != 0 || edge.jump_y != 0) net_error.add(error[b] + 4 * epsilon * std::abs(flow[b]));
    }
    const auto most = [&](std::size_t b) { return std::abs(flow[b]) + error[b]; };
    xx.add(most(0) * most(0) / edge.conductance);
    if (fields < 2) return;
    yy.add(most(1) * most(1) / edge.conductance);
    xy.add(flow[0] * flow[1] / edge.conductance);
    const double product = most(0) * most(1);
    xy_error.add((product - std::abs(flow[0] * flow[1]) + term_rounding * product) / edge.conductance);
  }
};

// F B^-1 F', less what rounding may add. More on B's diagonal makes the form smaller, so that it stays a lower bound; where the
// two circulations are almost one, this keeps the rounding small.
Tensor lower_form(const Dissipation& sums) {
  const double off = std::max(sums.xy_error.value(), 0.0), xy = sums.xy.value(), error = sums.net_error.value();
  double xx = sums.xx.value() * (1 + term_rounding) + off, yy = sums.yy.value() * (1 + term_rounding) + off;
  if (!(xx > 0) || !(yy > 0)) {  // no flow along one axis: the other circulation is alone
    const int b = xx > 0 ? 0 : 1;
    const double dissipated = b == 0 ? xx : yy, x = sums.net[0][b].value(), y = sums.net[1][b].value();
    if (!(dissipated > 0)) return {};
    const double loss = (2 * error + 16 * epsilon * (std::abs(x) + std::abs(y))) * (std::abs(x) + std::abs(y)) / dissipated;
    return {x * x / dissipated - loss, x * y / dissipated, y * y / dissipated - loss};
  }
  constexpr double almost_one = 1e-6, ridge = 1e-8;
  if (xx * yy - xy * xy < almost_one * xx * yy) {
    xx *= 1 + ridge;
    yy *= 1 + ridge;
  }
  const double determinant = xx * yy - xy * xy;
  double f[2][2], solved[2][2], size = 0, terms = 0;  // solved: F B^-1
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) f[a][b] = sums.net[a][b].value();
  for (int a = 0; a < 2; ++a) {
    solved[a][0] = (f[a][0] * yy - f[a][1] * xy) / determinant;
    solved[a][1] = (f[a][1] * xx - f[a][0] * xy) / determinant;
    size += std::abs(solved[a][0]) + std::abs(solved[a][1]);
    const double x = std::abs(f[a][0]), y = std::abs(f[a][1]);
    terms += ((x * yy + y * std::abs(xy)) + (y * xx + x * std::abs(xy))) / determinant;
  }
  const auto form = [&](int a, int b) { return solved[a][0] * f[b][0] + solved[a][1] * f[b][1]; };
  const double flows = std::abs(f[0][0]) + std::abs(f[0][1]) + std::abs(f[1][0]) + std::abs(f[1][1]);
  const double relative = 32 * epsilon * xx * yy / determinant;
  const double loss = 4 * error * size + 32 * epsilon * terms * flows + relative * (std::abs(form(0, 0)) + std::abs(form(1, 1)));
  return {form(0, 0) - loss, form(0, 1), form(1, 1) - loss};
}

}  // namespace

Tensor dirichlet(const Grid& grid, const std::vector<double>& gap, const Paths& paths, const Potentials& potentials) {
  Sum xx, xy, yy;
  const auto open = [&](std::int64_t i) { return paths.on(i) ? gap[static_cast<std::size_t>(i)] : 0.0; };
  each_edge(grid, open, [&](const Edge& edge) {
    const double x = of(potentials[0], edge.from) - of(potentials[0], edge.to) + edge.jump_x;
    xx.add(edge.conductance * x * x);
    if (potentials.size() < 2) return;
    const double y = of(potentials[1], edge.from) - of(potentials[1], edge.to) + edge.jump_y;
    xy.add(edge.conductance * x * y);
    yy.add(edge.conductance * y * y);
  });
  return {xx.value() * (1 + term_rounding), xy.value(), yy.value() * (1 + term_rounding)};
}

Tensor thomson(const Grid& grid, const std::vector<double>& gap, const Paths& paths, const Potentials& potentials) {
  if (!paths.any()) return {};
  const std::size_t fields = potentials.size();
  std::vector<Circulation> circulations;
  for (std::size_t b = 0; b < fields; ++b) circulations.emplace_back(potentials[b], b == 1);
  Dissipation sums;
  double flow[2], error[2] = {};
  const auto open = [&](std::int64_t i) { return paths.on(i) ? gap[static_cast<std::size_t>(i)] : 0.0; };
  each_edge(grid, open, [&](const Edge& edge) {
    if (in_tree(paths, edge)) return;
    for (std::size_t b = 0; b < fields; ++b) flow[b] = circulations[b].off_tree(edge);
    sums.add(edge, 1, flow, error, fields);
  });
  for (auto at = paths.order.rbegin(); at != paths.order.rend(); ++at) {
    const Side side = paths.parent[static_cast<std::size_t>(*at)];
    const bool root = side == Side::inlet;
    if (root && grid.cell) continue;  // its balance follows from all others
    double orientation;
    const Edge edge = to_parent(grid, gap, *at, side, orientation);
    for (std::size_t b = 0; b < fields; ++b) flow[b] = circulations[b].on_tree(*at, edge.from, error[b]);
    sums.add(edge, orientation, flow, error, fields);
  }
  if (fields == 2) return lower_form(sums);
  const double net = std::max(0.0, std::abs(sums.net[0][0].value()) - sums.net_error.value());
  const double dissipated = sums.xx.value() * (1 + term_rounding);
  return {dissipated > 0 ? net / dissipated * net * (1 - 4 * epsilon) : 0, 0, 0};
}

}  // namespace rc::flow
