// The intervals against dense solves in quadruple precision: none of the exact flows lies outside.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "flows.h"
#include "support/cmocka.hpp"

using namespace flow_tests;

namespace {

__extension__ typedef __float128 Quad;

// Small networks, written out: a matrix over the cells, and the cells that the inlet reaches.
class Network {
 public:
  Network(const Field& field, const std::vector<double>& gap, bool cell, bool sides) : field_(field), gap_(gap), n_(gap.size()) {
    const Quad along = Quad(field.hy) / Quad(field.hx), across = Quad(field.hx) / Quad(field.hy);
    for (std::int64_t y = 0; y < field.ny; ++y)
      for (std::int64_t x = 0; x < field.nx; ++x) {
        const std::size_t i = at(x, y);
        if (!(gap[i] > 0)) continue;
        if (!cell && x == 0) edges_.push_back({n_, i, 2 * k(i) * along, 1, 0});
        if (!cell && x + 1 == field.nx) edges_.push_back({i, n_, 2 * k(i) * along, 0, 0});
        if (cell || x + 1 < field.nx) join(i, at((x + 1) % field.nx, y), along, x + 1 == field.nx, 0);
        if (sides || y + 1 < field.ny) join(i, at(x, (y + 1) % field.ny), across, 0, y + 1 == field.ny);
      }
  }

  // The energy of the potentials of least energy for drops along a and b.
  Quad conductance(int a, int b) const {
    const std::vector<Quad> phi = solve(a), psi = solve(b);
    Quad sum = 0;
    for (const Edge& e : edges_) sum += e.c * (phi[e.from] - phi[e.to] + e.jump[a]) * (psi[e.from] - psi[e.to] + e.jump[b]);
    return sum;
  }

 private:
  struct Edge {
    std::size_t from, to;
    Quad c;
    int jump[2];
    Edge(std::size_t i, std::size_t j, Quad conductance, int x, int y) : from(i), to(j), c(conductance), jump{x, y} {}
  };

  std::size_t at(std::int64_t x, std::int64_t y) const { return static_cast<std::size_t>(y * field_.nx + x); }
  Quad k(std::size_t i) const { return Quad(gap_[i]) * Quad(gap_[i]) * Quad(gap_[i]); }
  void join(std::size_t i, std::size_t j, Quad factor, int x, int y) {
    if (gap_[j] > 0) edges_.push_back({i, j, 2 * k(i) * k(j) / (k(i) + k(j)) * factor, x, y});
  }

  // Gauss without pivoting. Node n is inlet and outlet, at 0; the last cell of a part that is not tied to it is at 0 as well.
  std::vector<Quad> solve(int axis) const {
    std::vector<std::vector<Quad>> m(n_, std::vector<Quad>(n_ + 1));
    for (const Edge& e : edges_) {
      if (e.from < n_) m[e.from][e.from] += e.c, m[e.from][n_] -= e.c * e.jump[axis];
      if (e.to < n_) m[e.to][e.to] += e.c, m[e.to][n_] += e.c * e.jump[axis];
      if (e.from < n_ && e.to < n_) m[e.from][e.to] -= e.c, m[e.to][e.from] -= e.c;
    }
    std::vector<Quad> diagonal(n_);
    for (std::size_t i = 0; i < n_; ++i) diagonal[i] = m[i][i];
    for (std::size_t p = 0; p < n_; ++p) {
      if (!(m[p][p] > diagonal[p] * 1e-26)) {
        for (std::size_t j = p; j <= n_; ++j) m[p][j] = 0;
        m[p][p] = 1;
        for (std::size_t i = p + 1; i < n_; ++i) m[i][p] = 0;
        continue;
      }
      for (std::size_t i = p + 1; i < n_; ++i) {
        const Quad factor = m[i][p] / m[p][p];
        if (factor == 0) continue;
        for (std::size_t j = p; j <= n_; ++j) m[i][j] -= factor * m[p][j];
      }
    }
    std::vector<Quad> x(n_ + 1);
    for (std::size_t p = n_; p-- > 0;) {
      Quad sum = m[p][n_];
      for (std::size_t j = p + 1; j < n_; ++j) sum -= m[p][j] * x[j];
      x[p] = sum / m[p][p];
    }
    return x;
  }

  const Field& field_;
  const std::vector<double>& gap_;
  std::size_t n_;
  std::vector<Edge> edges_;
};

// A gap of random heights over a range of decades, with closed cells; and one that lies within its errors.
struct Case {
  Field field;
  std::vector<double> exact;
};

Case random_case(Random& random) {
  Case made;
  made.field = uniform(1 + random.below(6), 1 + random.below(6), 0);
  made.field.hx = 0.5 + random.next();
  made.field.hy = 0.5 + random.next();
  const double decades = 4 * random.next(), closed = 0.4 * random.next();
  const double error = random.next() < 0.5 ? 0 : std::pow(10, -5 * random.next());
  for (double& g : made.field.g) g = random.next() < closed ? 0 : std::pow(10, -decades * random.next());
  made.exact = made.field.g;
  if (error == 0) return made;
  made.field.error.resize(made.field.g.size());
  for (std::size_t i = 0; i < made.exact.size(); ++i) {
    const double g = made.field.g[i];
    if (g == 0 && random.next() < 0.7) continue;
    const double e = made.field.error[i] = error * (g > 0 && random.next() < 0.8 ? g : 0.1) * (0.2 + random.next());
    const double low = std::max(0.0, g - e), part = random.next();
    made.exact[i] = part < 0.2 ? low : part > 0.8 ? g + e : low + (g + e - low) * random.next();
    made.exact[i] = std::clamp(made.exact[i], low, g + e);
  }
  return made;
}

bool quick() { return std::getenv("RC_TEST_QUICK") != nullptr; }

void no_exact_flow_lies_outside_of_its_interval(void**) {
  Random random(20260101);
  const int cases = quick() ? 4000 : 20000;
  int open = 0, narrow = 0;
  for (int k = 0; k < cases; ++k) {
    const Case made = random_case(random);
    const bool sides = random.next() < 0.5;
    const rc_flow_result found = flow(made.field, RC_FLOW_X, sides ? RC_FLOW_PERIODIC : RC_FLOW_CLOSED);
    const Quad exact = Network(made.field, made.exact, false, sides).conductance(0, 0);
    open += found.lower > 0;
    narrow += found.upper - found.lower <= 1e-6 * found.upper;
    if (!(Quad(found.lower) <= exact * (1 + 1e-28) && exact * (1 - 1e-28) <= Quad(found.upper) + 1e-40))
      fail_msg("case %d: %.17g is not in %.17g .. %.17g", k, static_cast<double>(exact), found.lower, found.upper);
  }
  print_message("%d cases, %d proven open, %d intervals within 1e-6\n", cases, open, narrow);
  assert_true(open > cases / 4 && narrow > cases / 4);
}

void no_exact_tensor_lies_outside_of_its_intervals(void**) {
  Random random(20260102);
  const int cases = quick() ? 1000 : 5000;
  int open = 0;
  for (int k = 0; k < cases; ++k) {
    const Case made = random_case(random);
    const Field& field = made.field;
    const rc_flow_factors found = factors(field);
    const Network network(field, made.exact, true, true);
    const Quad wide = Quad(field.hx) * static_cast<double>(field.nx), high = Quad(field.hy) * static_cast<double>(field.ny);
    const Quad exact[] = {network.conductance(0, 0) * wide / high, network.conductance(0, 1),
                          network.conductance(1, 1) * high / wide};
    const double lower[] = {found.xx_lower, found.xy_lower, found.yy_lower},
                 upper[] = {found.xx_upper, found.xy_upper, found.yy_upper};
    open += found.xx_lower > 0;
    for (int entry = 0; entry < 3; ++entry) {
      const Quad slack = 1e-27 * (exact[0] + exact[2]) + 1e-40;
      if (!(Quad(lower[entry]) <= exact[entry] + slack && exact[entry] - slack <= Quad(upper[entry])))
        fail_msg("case %d, entry %d: %.17g is not in %.17g .. %.17g", k, entry, static_cast<double>(exact[entry]), lower[entry],
                 upper[entry]);
    }
  }
  print_message("%d cases, %d proven open along x\n", cases, open);
  assert_true(open > cases / 8);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(no_exact_flow_lies_outside_of_its_interval),
      cmocka_unit_test(no_exact_tensor_lies_outside_of_its_intervals),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
