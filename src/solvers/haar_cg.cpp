// Projected flexible conjugate gradients on the contact set, preconditioned by two averaged multilevel trees that cut the surface
// at different places. Bounds are enforced every second step; a merit that rises, or a residual that stalls, makes the steps
// between longer and the admission of new points stricter.
//
// Products are in single precision where the backend has them; the residual is replaced by one of a product in double precision
// once it has lost the digits that single precision can tell, and before it is believed.
//
// In load control the approach follows by Newton's method at the same time: the tree gives the slope of the load, and the load
// that the present gap still calls for.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "solvers/haar_nested.h"
#include "solvers/haar_passes.h"
#include "solvers/haar_planting.h"
#include "solvers/haar_trees.h"
#include "solvers/solver.h"

namespace rc {

namespace {

constexpr int first_interval = 2, longest_interval = 16;
constexpr double first_admission = 0.1, strictest_admission = 0.9, admission_step = 0.2;
constexpr int patience = 10;  // bounded steps without half the residual before the safeguard acts
constexpr double least_excess = 0.5, most_excess = 2;
constexpr double caution = 0.7;  // in lengthening the datum's steps
constexpr double damping = 1.2;
constexpr double settled = 5e-2;   // residual below which the contact set changes little
constexpr int refresh_every = 12;  // bounded steps between fresh products that wash out drift
constexpr double infinite = std::numeric_limits<double>::infinity();

template <class Real> constexpr bool single = sizeof(Real) < sizeof(double);
// Digits that may be lost before the residual is replaced, and rises of the merit that rounding explains.
template <class Real> constexpr double drop = single<Real> ? 1e-4 : 0;
template <class Real> constexpr double merit_noise = single<Real> ? 1e-6 : 1e-10;

template <class Real> class Iteration {
 public:
  Iteration(const Problem& problem, std::span<double> p, double& d)
      : problem_(problem),
        team_(problem.team()),
        d_(d),
        trees_(planted()),
        s_(problem.size(), {problem.u(), problem.grid(), problem.length_unit()}, p.data(), trees_.bytes(), team_),
        hopeless_(static_cast<int>(problem.option_int("haar-cg.patience"))) {
    trees_.place(s_.tree_spare());
  }

  rc_status run() {
    start();
    const rc_status status = iterate();
    if (load_control()) d_ = datum_ - mean_ * now_.load;  // back to the operator as given
    return status;
  }

 private:
  HaarTrees planted() {
    const Planting on = planting_on(*problem_.grid(), problem_.size(),
                                    [&](std::int64_t mx, std::int64_t my, Vector& out) { problem_.coefficients(mx, my, out); });
    periodic_mean_ = on.mean;
    if (load_control()) mean_ = on.mean;
    return {on.cells, on.table};
  }

  // The operator with the trees' mean: it only shifts the datum by a multiple of the load, and without it the load of a periodic
  // contact would have little curvature, in full contact none.
  template <class Value> void product(const Value* x, Value* y) const {
    problem_.apply(x, y);
    if (mean_ == 0) return;
    raise(s_.n, mean_ * total(s_.n, x, team_), y, team_);
  }
  bool load_control() const { return problem_.load_control(); }
  double scale() const {
    return load_control() ? std::max({datum_ - mean_ * problem_.load() + highest_, problem_.least_scale(), 1e-300}) : 1.0;
  }
  double imbalance() const { return load_control() ? std::abs(now_.load / problem_.load() - 1) : 0.0; }
  double worst() const { return std::max(now_.largest / scale(), imbalance()); }

  void refresh() {
    prepared_ = false;
    product(static_cast<const double*>(s_.p), s_.double_spare());
    now_ = replace_and_measure(s_, s_.double_spare(), datum_, team_);
    since_refresh_ = 0;
    exact_ = worst();
  }

  void start() {
    const HaarStart given = begin(s_, team_);
    highest_ = given.highest;
    if (load_control()) datum_ = (d_ > 0 ? d_ : 0.5) + mean_ * problem_.load();
    if (!given.warm) {
      now_ = replace_and_measure(s_, nullptr, datum_, team_);
      exact_ = worst();
    } else {
      refresh();
      // A start that is worse than no pressure is reduced to its best multiple.
      const double work = now_.moment - 2 * now_.merit + datum_ * now_.load;
      const double curved = now_.moment + work;
      if (0.5 * curved > work) {
        multiply(s_, curved > 0 ? std::max(0.0, work / curved) : 0, team_);
        refresh();
      }
    }
    choose(0);
  }

  void choose(double threshold) {
    if (choose_set(s_, threshold, team_)) prepared_ = false;
  }

  // z = M g on the contact set, 0 elsewhere, z = first spare; g null: of ones. Returns (z, q) where wanted. The trees share
  // their memory with the other spares.
  double precondition(const Real* g, const Real* q) {
    if (!prepared_) trees_.set_up(s_.active, static_cast<float>(periodic_mean_ - mean_), team_);
    prepared_ = true;
    return trees_.apply(g, s_.active, s_.first_spare(), q, team_);
  }

  // One step along a conjugate direction; pressures may become negative until the next bound.
  void step() {
    const double zq = precondition(s_.w, conjugate_ ? s_.q : nullptr);
    const double beta = conjugate_ && curvature_ > 0 ? std::max(0.0, -zq / curvature_) : 0;
    const double slope = turn(s_, s_.first_spare(), static_cast<Real>(beta), team_);
    product(static_cast<const Real*>(s_.t), s_.q);
    conjugate_ = true;
    curvature_ = inner<Real>(s_, s_.t, s_.q, team_);
    if (std::isnan(curvature_)) problem_.fail("haar-cg: the operator returned values that are not finite");
    ++phase_;
    const bool last = phase_ >= interval_ || !(curvature_ > 0);
    double length = 0;
    if (curvature_ > 0) {
      length = slope / curvature_;
    } else {
      conjugate_ = false;
      phase_ = interval_;
    }
    cut_any_ = advance(s_, length, last ? s_.first_spare() : nullptr, team_);
  }

  // What the pressures that were cut off had deflected.
  void bound() {
    phase_ = 0;
    if (++since_refresh_ >= refresh_every) return refresh();
    if (cut_any_) {
      prepared_ = false;
      product(static_cast<const Real*>(s_.first_spare()), s_.second_spare());
    }
    now_ = add_and_measure(s_, cut_any_ ? s_.second_spare() : nullptr, 0.0, team_);
  }

  void lower(double change) {
    datum_ += change;
    now_ = add_and_measure(s_, static_cast<const Real*>(nullptr), change, team_);
  }

  // Of the multiples of z = M 1 that of least energy is 1'z / z'Hz: its error is of second order in that of M.
  double measured_excess(double sum) {
    prepared_ = false;
    const Real* const z = s_.first_spare();
    product(z, s_.second_spare());
    const double energy = inner<Real>(s_, z, s_.second_spare(), team_);
    return energy > 0 ? std::clamp(sum / energy, least_excess, most_excess) : 1;
  }

  // Newton's step of the approach on the load.
  void balance() {
    choose(0);
    const double pending = precondition(nullptr, s_.w);
    const double sum = total<Real>(s_.n, s_.first_spare(), team_);
    if (!(sum > 0)) return;
    if (excess_ == 0) excess_ = measured_excess(sum);
    const double depth = scale(), missing = problem_.load() - now_.load + excess_ * pending;
    // What the last step left of the missing load tells the true slope: at once where the step was too long.
    const double left = missing / missing_;
    if (last_ < settled && left < 1)
      excess_ = std::clamp(excess_ * (1 - (left < 0 ? std::max(left, -1.0) : caution * left)), least_excess, most_excess);
    else if (left < -1)  // steps that swing ever wider
      excess_ = std::min(excess_ * damping, most_excess);
    const double wanted = missing / (excess_ * sum);
    const double change = std::clamp(wanted, -0.5 * depth, std::max(depth, mean_ * problem_.load()));
    missing_ = change == wanted ? missing : 0;
    lower(change);
  }

  // The exact load, a product in double precision, and the approach that makes the mean of the gap, weighted by the pressures,
  // vanish.
  void settle() {
    if (!load_control()) {
      refresh();
      return;
    }
    const double factor = now_.load > 0 ? problem_.load() / now_.load : 1;
    multiply(s_, factor, team_);
    refresh();
    if (now_.load > 0) lower(now_.moment / now_.load);
    exact_ = worst();
  }

  // Single precision tells a few digits below the last product in double precision.
  bool blurred() const { return single<Real> && worst() <= drop<Real> * exact_; }

  rc_status iterate() {
    double best = infinite, merit_before = infinite;
    int since_best = 0, rises = 0, stalled = 0;
    for (std::int64_t iteration = 1;; ++iteration) {
      step();
      if (phase_ > 0 && phase_ < interval_) {
        problem_.poll(iteration, last_);
        continue;
      }
      bound();
      if (worst() <= problem_.tol())
        settle();
      else if (blurred())
        refresh();
      last_ = worst();
      if (last_ <= problem_.tol() && since_refresh_ == 0) return RC_OK;
      problem_.poll(iteration, last_);

      bool rose = !load_control() && now_.merit > merit_before + merit_noise<Real> * std::abs(now_.merit);
      merit_before = now_.merit;
      if (last_ < 0.5 * best) {
        best = last_;
        since_best = stalled = 0;
      } else {
        ++since_best;
        ++stalled;
      }
      if (stalled > hopeless_) return RC_STOP_STALLED;
      if (since_best >= patience) {
        rose = true;
        since_best = 0;
      }
      if (rose && ++rises > 1) {
        interval_ = std::min(longest_interval, 2 * interval_);
        admission_ = std::min(strictest_admission, admission_ + admission_step);
        conjugate_ = false;
      }
      if (load_control())
        balance();
      else
        choose(admission_ * last_ * scale());
    }
  }

  const Problem& problem_;
  const rc_team& team_;
  double& d_;                 // approach, in load control
  double periodic_mean_ = 0;  // what the trees' operator adds to every coefficient
  double mean_ = 0;           // that mean where it is added to the operator
  HaarTrees trees_;
  HaarState<Real> s_;
  HaarMeasure now_;
  double highest_ = 0;               // largest u
  double exact_ = 1;                 // residual of the last product in double precision
  double datum_ = 0;                 // w = H p - u - datum
  double excess_ = 0, missing_ = 0;  // of the slope; load that the last step of the approach should have added
  double curvature_ = 0, admission_ = first_admission, last_ = infinite;
  int interval_ = first_interval, phase_ = 0, since_refresh_ = 0;
  const int hopeless_;  // bounded steps without half the residual before the solver gives up
  bool conjugate_ = false, cut_any_ = false, prepared_ = false;
};

constexpr rc_option_spec products =
    text_option("haar-cg.products", "mixed", "mixed|double", "mixed: single precision, corrected by some in double precision");
constexpr rc_option_spec nested = int_option("haar-cg.nested", "1", 0, 1, "1: without a start, begin on coarser grids");
constexpr rc_option_spec hopeless =
    int_option("haar-cg.patience", "120", 0, 1e6, "bounded steps without half the residual before the exact fallback takes over");
const rc_option_spec* const specs[] = {&products, &nested, &hopeless};

rc_status solve(const Problem& problem, std::span<double> p, double& d) {
  if (problem.has_float() && problem.option_text("haar-cg.products") == "mixed") return Iteration<float>(problem, p, d).run();
  return Iteration<double>(problem, p, d).run();
}

}  // namespace

const Options haar_cg_options = listed(specs);

rc_status haar_cg(const Problem& problem, std::span<double> p, double& d) {
  if (problem.option_int("haar-cg.nested") != 0 && !any_positive(problem.size(), p.data(), problem.team()))
    start_nested(problem, p, d);
  const rc_status status = solve(problem, p, d);
  if (status != RC_STOP_STALLED || problem.load_control() || !problem.has_subset()) return status;
  // Pivoting is finite whatever the surface.
  problem.note("haar-cg: stalled; nnls finished");
  Positions all(p.size());
  std::iota(all.begin(), all.end(), std::int64_t{0});
  const rc_status finished = problem.inner("nnls", all, problem.tol(), p.data(), nullptr);
  if (finished < 0) throw Leave{finished};
  return finished;
}

}  // namespace rc
