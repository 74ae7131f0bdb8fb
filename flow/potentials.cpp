#include "potentials.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <optional>

#include "cholmod/failure.h"
#include "cholmod/one_thread.h"
#include "cholmod/session.h"
#include "platform/memory.h"

namespace rc::flow {

namespace {

using rc_cholmod::Session;
using Vector = Eigen::VectorXd;

// The equations A phi = b of least energy, scaled to ones on the diagonal.
class Equations {
 public:
  Equations(const Grid& grid, const std::vector<double>& gap, const Paths& paths)
      : grid_(grid), gap_(gap), paths_(paths), number_(gap.size(), -1) {
    for (std::size_t i = 0; i < gap.size(); ++i)
      if (paths.parent[i] != Side::none) number_[i] = unknowns_++;
    scale_ = Vector::Zero(unknowns_);
    edges([&](const Edge& edge) {
      for (const std::int64_t end : {edge.from, edge.to})
        if (end != outside) scale_[of(end)] += edge.conductance;
      if (edge.from != outside && edge.to != outside && edge.from != edge.to) ++off_diagonal_;
    });
    if (grid.cell)  // potentials of a part that repeats are determined up to a constant: its root is tied to 0
      for (const std::int32_t i : paths.order)
        if (paths.parent[static_cast<std::size_t>(i)] == Side::inlet) scale_[of(i)] *= 2;
    scale_ = scale_.cwiseSqrt().cwiseInverse();
  }

  std::int32_t unknowns() const { return unknowns_; }
  // Diagonal ones, then a(row, column, value) with row > column; entries of a pair may come twice.
  template <class Entry> void entries(const Entry& entry) const {
    for (std::int32_t j = 0; j < unknowns_; ++j) entry(j, j, 1.0);
    edges([&](const Edge& edge) {
      if (edge.from == outside || edge.to == outside) return;
      const std::int32_t a = of(edge.from), b = of(edge.to);
      if (a == b)
        entry(a, a, -2 * edge.conductance * scale_[a] * scale_[a]);
      else
        entry(std::max(a, b), std::min(a, b), -edge.conductance * scale_[a] * scale_[b]);
    });
  }
  std::size_t count() const { return off_diagonal_ + 2 * static_cast<std::size_t>(unknowns_); }

  // The divergence that the flows of a potential have in each cell, scaled.
  Vector residual(const std::vector<double>& potential, bool along_y) const {
    Vector r = Vector::Zero(unknowns_);
    const auto value = [&](std::int64_t i) { return i == outside ? 0 : potential[static_cast<std::size_t>(i)]; };
    edges([&](const Edge& edge) {
      const double flow = edge.conductance * (value(edge.from) - value(edge.to) + (along_y ? edge.jump_y : edge.jump_x));
      if (edge.from != outside) r[of(edge.from)] -= flow;
      if (edge.to != outside) r[of(edge.to)] += flow;
    });
    return r.cwiseProduct(scale_);
  }
  void add(const Vector& correction, std::vector<double>& potential) const {
    for (std::size_t i = 0; i < number_.size(); ++i)
      if (number_[i] >= 0) potential[i] += scale_[number_[i]] * correction[number_[i]];
  }

 private:
  std::int32_t of(std::int64_t i) const { return number_[static_cast<std::size_t>(i)]; }
  template <class Visit> void edges(const Visit& visit) const {
    each_edge(
        grid_, [&](std::int64_t i) { return paths_.on(i) ? gap_[static_cast<std::size_t>(i)] : 0.0; }, visit);
  }

  const Grid& grid_;
  const std::vector<double>& gap_;
  const Paths& paths_;
  std::vector<std::int32_t> number_;  // of the unknown; -1: on no path
  std::int32_t unknowns_ = 0;
  std::size_t off_diagonal_ = 0;
  Vector scale_;
};

// CHOLMOD's factor of the equations.
class Factor {
 public:
  explicit Factor(const Equations& equations) : matrix_(matrix_of(equations)) {
    session_.order(false);
    // Operations per entry above which supernodes are faster than columns: measured 160 to 200; CHOLMOD has 40.
    session_.common()->supernodal_switch = 160;
    factor_ = session_.analyze(*matrix_);
  }
  double bytes() {
    return factor_->is_super ? 8.0 * static_cast<double>(factor_->xsize) + 4.0 * static_cast<double>(factor_->ssize)
                             : 12.0 * session_.common()->lnz;
  }
  void factorize() {
    // Round-off may spoil the pivots of wide pools between narrow channels. A shift of the ones on the diagonal keeps them
    // positive, and refinement takes out what it does.
    for (const double shift : {0.0, 1e-14, 1e-12, 1e-10, 1e-8})
      if (session_.factorize(*matrix_, shift, *factor_)) {
        steps = shift > 0 ? 4 : 2;
        return;
      }
    fail(RC_ERR_NUMERIC, "the network's equations have no factor");
  }
  Vector solve(Vector b) {
    cholmod_common* const common = session_.common();
    cholmod_dense right = {};
    right.nrow = right.nzmax = right.d = factor_->n;
    right.ncol = 1;
    right.x = b.data();
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    const rc_cholmod::OneThread one;
    // It does not check whether it gets its workspace, so that is given.
    cholmod_dense *x = nullptr, *y = nullptr;
    cholmod_dense* work = cholmod_allocate_dense(1, std::max<std::size_t>(factor_->maxesize, 1), 1, CHOLMOD_REAL, common);
    if (work) cholmod_solve2(CHOLMOD_A, factor_.get(), &right, nullptr, &x, nullptr, &y, &work, common);
    const Session::Dense answer(x, {common}), part(y, {common}), workspace(work, {common});
    session_.check();
    std::copy_n(static_cast<const double*>(answer->x), factor_->n, b.data());
    return b;
  }

  int steps = 2;  // of refinement

 private:
  Session::Sparse matrix_of(const Equations& equations) {
    const auto n = static_cast<std::size_t>(equations.unknowns());
    const double entries = static_cast<double>(equations.count());
    if (entries > std::numeric_limits<int>::max())
      fail(RC_ERR_MEMORY, "a matrix of ", entries, " entries is too large for CHOLMOD");
    cholmod_common* const common = session_.common();
    using Triplet = std::unique_ptr<cholmod_triplet, Session::Release<cholmod_triplet, cholmod_free_triplet>>;
    const Triplet triplet(cholmod_allocate_triplet(n, n, equations.count(), -1, CHOLMOD_REAL, common), {common});
    session_.check();
    auto *row = static_cast<int*>(triplet->i), *column = static_cast<int*>(triplet->j);
    auto* const value = static_cast<double*>(triplet->x);
    std::size_t at = 0;
    equations.entries([&](std::int32_t i, std::int32_t j, double entry) {
      row[at] = i;
      column[at] = j;
      value[at++] = entry;
    });
    triplet->nnz = at;
    Session::Sparse matrix(cholmod_triplet_to_sparse(triplet.get(), at, common), {common});
    session_.check();
    return matrix;
  }

  Session session_;
  Session::Sparse matrix_;
  Session::Factor factor_;
};

// Conjugate gradients with an incomplete factor.
class Iteration {
 public:
  explicit Iteration(const Equations& equations) : matrix_(equations.unknowns(), equations.unknowns()) {
    const double bytes = 250.0 * equations.unknowns();
    if (bytes > rc_platform::machine_bytes())
      fail(RC_ERR_MEMORY, "the flow through ", equations.unknowns(), " open cells needs about ", bytes,
           " bytes, more than this machine has; use a coarser grid");
    std::vector<Eigen::Triplet<double, std::int32_t>> triplets;
    triplets.reserve(equations.count());
    equations.entries([&](std::int32_t i, std::int32_t j, double entry) { triplets.emplace_back(i, j, entry); });
    matrix_.setFromTriplets(triplets.begin(), triplets.end());
    triplets = {};
    solver_.setMaxIterations(at_once);
    solver_.setTolerance(1e-12);
    solver_.compute(matrix_);
  }
  Vector solve(const Vector& b, std::int32_t& iterations) {
    Vector x = Vector::Zero(b.size());
    for (double before = 1; iterations < most;) {
      stop_if_asked();
      x = solver_.solveWithGuess(b, x);
      iterations += static_cast<std::int32_t>(solver_.iterations());
      if (solver_.info() == Eigen::Success || !(solver_.error() < 0.9 * before)) break;
      before = solver_.error();
    }
    return x;
  }

 private:
  static constexpr std::int32_t at_once = 500, most = 20000;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower,
                           Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>>>
      solver_;
};

}  // namespace

Solved solve_potentials(const Grid& grid, const std::vector<double>& gap, const Paths& paths, std::size_t fields, double memory) {
  const Equations equations(grid, gap, paths);
  Solved solved;
  solved.potentials.assign(fields, std::vector<double>(gap.size()));
  std::optional<Factor> factor;
  const double most = memory > 0 ? memory : 0.8 * rc_platform::machine_bytes();
  try {
    factor.emplace(equations);
    if (factor->bytes() > most)
      factor.reset();
    else
      factor->factorize();
  } catch (const roughcontact::Failure& failure) {
    if (failure.code != RC_ERR_MEMORY) fail(failure.code, failure.message);
    factor.reset();  // more entries than its integers count
  }
  if (factor) {
    for (std::size_t k = 0; k < fields; ++k) {
      double small = -1;
      for (int step = 0; step <= factor->steps; ++step) {
        stop_if_asked();
        Vector residual = equations.residual(solved.potentials[k], k == 1);
        if (residual.norm() <= small) break;
        if (step == 0) small = 1e-13 * residual.norm();
        equations.add(factor->solve(std::move(residual)), solved.potentials[k]);
      }
    }
    return solved;
  }
  Iteration iteration(equations);
  for (std::size_t k = 0; k < fields; ++k)
    equations.add(iteration.solve(equations.residual(solved.potentials[k], k == 1), solved.iterations), solved.potentials[k]);
  return solved;
}

}  // namespace rc::flow
