#include "contact/slopes/contact_set_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/chunks.h"
#include "core/conjugate_gradients.h"
#include "core/error.h"
#include "core/rows.h"
#include "core/stall.h"
#include "core/sums.h"

namespace rc {

namespace {

constexpr int steps_of_round_off = 20;  // without a smaller residual, after which round-off is all that is left
constexpr double smaller = 0.9;         // of the smallest residual before

constexpr double single_error = 2e-6;  // of a product in single precision, relative, at most
constexpr double drift = 0.005;        // share of the tolerance that one such product may add to the residual

constexpr double fallback_residual = 1e-10;  // where a form is not found as exactly as wanted

constexpr std::size_t sparse = 8;  // cells of the grid for a point of the set, from which on the trees have the points alone
constexpr std::size_t small_grid = 1 << 13;  // cells; trees over all of them are as fast to set up and apply
constexpr float sharp = 2;          // differences in the finest blocks, over those of haar-cg: no other level counts them
constexpr double heavy = 4;         // the mean, over that of haar-cg: what the trees tell of the longest waves is then less off
constexpr double turned_by = 0.36;  // of the grid's sides, by which the second pair of trees begins elsewhere

rc_status product_of(Operator& op, const double* x, double* y) { return op.apply(x, y); }
rc_status product_of(Operator& op, const float* x, float* y) { return op.apply_float(x, y); }

// An odd number of cells, so that blocks are cut on every level.
std::int64_t turn_of(std::int64_t n) { return static_cast<std::int64_t>(turned_by * static_cast<double>(n)) | 1; }

// Residuals of an iteration over |b|, and what products in single precision may have added to them.
struct Descent {
  double last = 0, drifted = 0;

  // rr: the square of the next residual; single: its product was in single precision.
  double next(double rr, bool single) {
    const double now = std::sqrt(rr);
    if (single) drifted += single_error * (last + now);
    return last = now;
  }
};

}  // namespace

// Periodic trees see no neighbours across the grid's sides: a second pair, whose sides lie elsewhere, does. Over few points it
// costs little.
ContactSetSolve::ContactSetSolve(Operator& op, std::span<const std::int64_t> set, const rc_grid& grid, double lowest,
                                 const rc_team& team, const Coefficients& coefficients, const Rows& rows)
    : op_(op), team_(team), rows_(rows), lowest_(lowest) {
  rows.on_all([&] {
    set_.assign(set.begin(), set.end());
    TreeInputs inputs = tree_inputs(grid, grid.nx * grid.ny, coefficients);
    if (inputs.table.mean > 0) {
      mean_ = heavy * inputs.table.mean;
      for (double& value : inputs.table.k) value += mean_ - inputs.table.mean;
      // With couplings in a period answers over nearly all points are off by more than ten times the tolerance.
      inputs.table.nx = inputs.table.ny = 0;
      lowest_ = std::min(lowest, mean_ * static_cast<double>(grid.nx * grid.ny));
    }
    trees_.push_back(trees_at(inputs, 0, 0));
    pieces_ = {0, set_.size()};
    if (rows.shared()) {
      const Chunks pieces = Chunks::of(rows, grid.nx);
      const std::int64_t points = op.trial().n;
      pieces_ = {0};
      for (std::int64_t k = 1; k <= pieces.count(points); ++k)
        pieces_.push_back(static_cast<std::size_t>(std::lower_bound(set_.begin(), set_.end(), k * pieces.values) - set_.begin()));
      std::get<Vectors<float>>(vectors_).resize(op.trial());
      std::get<Vectors<double>>(vectors_).resize(op.trial());
      return;
    }
    const bool scattered = trees_.front().place.size() == trees_.front().active.size();
    if (mean_ > 0 || scattered) trees_.push_back(trees_at(inputs, turn_of(inputs.cells.mx), turn_of(inputs.cells.my)));
  });
  for (Trees& trees : trees_) trees.pair.set_up(trees.active.data() + trees.before, 0, team_);
}

// inputs: of the whole grid. x, y: where its first cell comes to lie; what is periodic comes back on the other side.
ContactSetSolve::Trees ContactSetSolve::trees_at(const TreeInputs& inputs, std::int64_t x, std::int64_t y) const {
  const bool around = inputs.table.mean > 0;
  const std::int64_t nx = inputs.cells.mx, ny = inputs.cells.my, width = around ? nx : nx + x, height = around ? ny : ny + y;
  const bool every_cell = rows_.shared();
  const std::size_t before = every_cell ? static_cast<std::size_t>(nx) : 0;
  std::vector<std::size_t> place;
  for (const std::int64_t position : set_) {
    const std::int64_t point = op_.trial().point(position);
    place.push_back(before + static_cast<std::size_t>((point / nx + y) % height * width + (point % nx + x) % width));
  }
  Cells cells{width, height, {}, {}};
  const std::size_t all = before + static_cast<std::size_t>(width * rows_.own(height));
  std::vector<std::uint8_t> active(every_cell || all < sparse * place.size() || all <= small_grid ? all : 0);
  if (!every_cell && active.empty()) {
    std::vector<std::size_t> sorted = place;
    std::sort(sorted.begin(), sorted.end());
    for (const std::size_t at : sorted) {
      cells.x.push_back(static_cast<std::int32_t>(at % static_cast<std::size_t>(width)));
      cells.y.push_back(static_cast<std::int32_t>(at / static_cast<std::size_t>(width)));
    }
    for (std::size_t& at : place)
      at = static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), at) - sorted.begin());
    active.resize(place.size());
  }
  for (const std::size_t at : place) active[at] = 1;
  const std::vector<float> none(active.size());
  Trees trees{HaarTreePair(std::move(cells), inputs.table, sharp, rows_),
              std::move(place),
              std::move(active),
              none,
              none,
              before,
              nullptr};
  trees.memory.reset(new std::byte[trees.pair.bytes()]);
  trees.pair.place(trees.memory.get());
  return trees;
}

template <class... Terms> std::array<double, sizeof...(Terms)> ContactSetSolve::sums(const Terms&... terms) const {
  struct Part {
    std::array<double, sizeof...(Terms)> sum;
    Part operator+(const Part& other) const {
      Part result = *this;
      for (std::size_t i = 0; i < sum.size(); ++i) result.sum[i] += other.sum[i];
      return result;
    }
  };
  return total<Part>(rows_, pieces_.size() - 1,
                     [&](std::size_t k) {
                       const std::size_t begin = pieces_[k], count = pieces_[k + 1] - begin;
                       return Part{{sum_of(count, [&](std::size_t i) { return terms(begin + i); })...}};
                     })
      .sum;
}

double ContactSetSolve::dot(std::span<const double> a, std::span<const double> b) const {
  return sums([&](std::size_t i) { return a[i] * b[i]; })[0];
}

// q = A t
template <class Real> rc_status ContactSetSolve::multiply(std::span<const double> t, std::span<double> q) {
  std::get<Vectors<Real>>(vectors_).resize(op_.trial());
  auto& [spread, product] = std::get<Vectors<Real>>(vectors_);
  for (std::size_t k = 0; k < t.size(); ++k) spread[static_cast<std::size_t>(set_[k])] = static_cast<Real>(t[k]);
  const rc_status status = product_of(op_, spread.data(), product.data());
  const double shift = mean_ > 0 ? mean_ * sums([&](std::size_t k) { return t[k]; })[0] : 0;
  for (std::size_t k = 0; k < t.size(); ++k) q[k] = static_cast<double>(product[static_cast<std::size_t>(set_[k])]) + shift;
  return status;
}

// z = M r / unit, M the sum of all trees
void ContactSetSolve::precondition(std::span<const double> r, double unit, std::span<double> z) {
  std::fill(z.begin(), z.end(), 0.0);
  for (Trees& trees : trees_) {
    for (std::size_t i = 0; i < r.size(); ++i) trees.g[trees.place[i]] = static_cast<float>(r[i] / unit);
    trees.pair.apply<float>(trees.g.data() + trees.before, trees.active.data() + trees.before, trees.p.data() + trees.before,
                            nullptr, nullptr, team_);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] += static_cast<double>(trees.p[trees.place[i]]);
  }
}

rc_status ContactSetSolve::operator()(std::span<const double> b, double tol, std::span<double> x,
                                      std::span<ContactSetBound> bounds) {
  const std::size_t n = set_.size();
  for (std::size_t k = 0; k < bounds.size(); ++k)
    if (const rc_status status = solve(b.subspan(k * n, n), tol, x.subspan(k * n, n), bounds[k]); status != RC_OK) return status;
  return RC_OK;
}

// Until enough(step, |r|^2 / size^2). single: whether the next product is in single precision, which enough() may change. z:
// scratch. beta comes from the product, not from norms: the trees work in single precision, so each step is made conjugate to the
// last only.
template <class Enough>
ConjugateGradientsEnd ContactSetSolve::descend(std::span<double> x, std::vector<double>& r, std::vector<double>& z, double size,
                                               const bool& single, const Enough& enough) {
  std::vector<double> first, second;
  rows_.on_all([&] {
    first.assign(r.size(), 0.0);
    second.resize(r.size());
  });
  const auto turn = [&](int step, double, double curvature, const std::vector<double>& q, std::vector<double>& t) {
    precondition(r, size, z);
    const auto [along_z, along_t, turned] =
        sums([&](std::size_t i) { return r[i] * z[i]; }, [&](std::size_t i) { return r[i] * t[i]; },
             [&](std::size_t i) { return z[i] * q[i]; });
    const double beta = step > 0 ? -turned / curvature : 0;
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = z[i] + beta * t[i];
    return (along_z + beta * along_t) / size;
  };
  const auto multiply_by = [&](const std::vector<double>& t, std::vector<double>& q) {
    return single ? multiply<float>(t, q) : multiply<double>(t, q);
  };
  const auto sum = [&](std::size_t, const auto& term) { return sums(term)[0]; };
  return conjugate_gradients(x, r, size, first, second, sum, multiply_by, enough, turn);
}

double ContactSetSolve::largest_of(std::span<const double> x) const {
  struct Largest {
    double size = 0;
    Largest operator+(const Largest& b) const { return {std::max(size, b.size)}; }
  } largest;
  for (const double value : x) largest.size = std::max(largest.size, std::abs(value));
  return rows_.united(largest).size;
}

// The multiple of x nearest to A^-1 b in the norm of the energy, and its residual.
rc_status ContactSetSolve::rough_start(std::span<const double> b, std::span<double> x, std::span<double> r) {
  std::copy(b.begin(), b.end(), r.begin());
  const double largest = largest_of(x);
  if (!std::isnormal(largest)) {
    std::fill(x.begin(), x.end(), 0.0);
    return RC_OK;
  }
  for (double& value : x) value /= largest;
  std::vector<double> product;
  rows_.on_all([&] { product.resize(x.size()); });
  const rc_status status = (op_.capabilities() & RC_CAP_FLOAT) != 0 ? multiply<float>(x, product) : multiply<double>(x, product);
  if (status != RC_OK) return status;
  const double along = dot(b, x), curvature = dot(x, product), length = along > 0 && curvature > 0 ? along / curvature : 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] *= length;
    r[i] -= length * product[i];
  }
  return RC_OK;
}

// Products in single precision bring x near, one in double precision tells how near. What single precision adds to the residual
// is found by that; the iteration then continues from the true residual.
rc_status ContactSetSolve::form(std::span<const double> b, double tol, double mean, std::span<double> x, ContactSetBound& bound) {
  const double size = std::sqrt(dot(b, b));
  std::vector<double> r, z;
  rows_.on_all([&] {
    r.resize(b.size());
    z.resize(b.size());
  });
  bound = {};
  if (const rc_status status = rough_start(b, x, r); status != RC_OK || size == 0) return status;
  const bool single = (op_.capabilities() & RC_CAP_FLOAT) != 0;
  const auto tell = [&](double residual) {
    bound.residual = residual + product_rounding * size;
    bound.form = dot(b, x) + dot(r, x);
    bound.error = bound.residual * bound.residual / lowest_ + product_rounding * size * std::sqrt(dot(x, x));
    return bound.settles(tol, mean);
  };
  for (double before = std::numeric_limits<double>::infinity();;) {
    Descent residual;
    Stall stalls(smaller, steps_of_round_off);
    const auto enough = [&](int, double rr) {
      const double now = residual.next(rr, single);
      return tell(size * now) || now < 2 * residual.drifted || stalls(now);
    };
    const ConjugateGradientsEnd end = descend(x, r, z, size, single, enough);
    if (end.status != 0) return end.status;
    if (!end.definite()) break;
    if (const rc_status status = multiply<double>(x, z); status != RC_OK) return status;
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = b[i] - z[i];
    const double now = std::sqrt(dot(r, r)) / size;
    if (tell(size * now)) return RC_OK;
    if (!(now < 0.3 * before)) break;
    before = now;
  }
  return solve(b, fallback_residual, x, bound);
}

rc_status ContactSetSolve::solve(std::span<const double> b, double tol, std::span<double> x, ContactSetBound& bound) {
  const double size = std::sqrt(dot(b, b));
  std::vector<double> r, z;
  rows_.on_all([&] {
    r.assign(b.begin(), b.end());
    z.resize(b.size());
  });
  bound = {};
  if (largest_of(x) > 0) {
    if (const rc_status status = multiply<double>(x, z); status != RC_OK) return status;
    for (std::size_t i = 0; i < r.size(); ++i) r[i] -= z[i];
    if (!(dot(r, r) < size * size)) {  // no better than nothing
      std::copy(b.begin(), b.end(), r.begin());
      std::fill(x.begin(), x.end(), 0.0);
    }
  }
  if (size == 0) return RC_OK;
  // All residuals are over |b|. Products in single precision are relative to what is left of it: the later, the less they add.
  const bool has_single = (op_.capabilities() & RC_CAP_FLOAT) != 0;
  bool single = false, stalled = false;
  Descent residual;
  const double& drifted = residual.drifted;
  Stall stalls(smaller, steps_of_round_off);
  const auto enough = [&](int, double rr) {
    const double now = residual.next(rr, single);
    single = has_single && single_error * now <= drift * tol && drifted <= 10 * drift * tol;
    bound.residual = size * (now + drifted + product_rounding);
    if (now + drifted + product_rounding <= tol) return true;
    return stalled = now < product_rounding || stalls(now);
  };
  const ConjugateGradientsEnd end = descend(x, r, z, size, single, enough);
  if (end.status != 0) return end.status;
  if (!end.definite())
    fail(RC_ERR_NUMERIC, "the operator is not positive definite: t'Ht = ", end.curvature, " on the contact set");
  // 2 b'x - x'A x = b'A^-1 b - e'A e, e the error of x; and e'A e = r'A^-1 r <= r'r / lowest.
  bound.form = dot(b, x) + dot(r, x);
  bound.error = bound.residual * bound.residual / lowest_ + (drifted + product_rounding) * size * std::sqrt(dot(x, x));
  return stalled ? RC_STOP_STALLED : RC_OK;
}

}  // namespace rc
