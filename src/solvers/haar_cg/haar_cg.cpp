// Projected flexible conjugate gradients on the contact set, preconditioned by two averaged multilevel trees that cut the surface
// at different places. Bounds are enforced every second step; a merit that rises, or a residual that stalls, makes the steps
// between longer and the admission of new points stricter.
//
// Products are in single precision where the backend has them; the residual is replaced by one of a product in double precision
// once it has lost the digits that single precision can tell, and before it is believed.
//
// In load control the approach follows by Newton's method at the same time: the tree gives the slope of the load, and the load
// that the present gap still calls for. So it does in displacement control of a periodic surface, once the energy has risen: for
// the deflection that the mean adds, see docs/decisions.md.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "solvers/haar_cg/nested_start.h"
#include "solvers/haar_cg/threads/passes.h"
#include "solvers/haar_cg/tree_inputs.h"
#include "solvers/haar_cg/tree_pair.h"
#include "solvers/solver.h"

namespace rc {

namespace {

constexpr int first_interval = 2, longest_interval = 16;
constexpr double first_admission = 0.1, strictest_admission = 0.9, admission_step = 0.2;
constexpr int patience = 10;  // bounded steps without half the residual before the safeguard acts
// Of the load's slope over the trees', or of theirs over it: more where cells or sides are elongated.
constexpr double usual_excess = 2, elongated_excess = 10;
constexpr double caution = 0.7;  // in lengthening the datum's steps
constexpr double damping = 1.2;
constexpr double overloaded = 10;  // times the load: then the approach may fall by more than half
constexpr double most_fall = 0.5, most_fall_overloaded = 0.95;
// Of what the datum's slope is multiplied by, and of the slope itself, in displacement control.
constexpr double least_stiffening = 1e-2, most_stiffening = 4, least_slope = 1e-4;
constexpr double most_share = 0.99;  // of the deflection under a load that adding its mean may make up
constexpr int tolerated_stalls = 2;  // of the datum's search in displacement control before it is given up
constexpr double little = 1e-4;      // of the energy that the first step of an interval gains
constexpr double settled = 5e-2;     // residual below which the contact set changes little
constexpr int refresh_every = 12;    // bounded steps between fresh products that wash out drift
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

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
    elongated_ = on.elongated;
    return {on.cells, on.table};
  }

  // The operator with the trees' mean: it only shifts the datum by a multiple of the load, and without it the load of a periodic
  // contact would have little curvature, in full contact none.
  template <class Value> void product(const Value* x, Value* y) const {
    problem_.apply(x, y);
    if (mean_ == 0) return;
    raise(s_.n, mean_ * total(s_.n, x, team_), y, team_);
  }
  double most_excess() const { return elongated_ ? elongated_excess : usual_excess; }
  bool load_control() const { return problem_.load_control(); }
  // The datum follows a load: the one prescribed, or the one whose mean deflection was added to the operator.
  bool follows() const { return load_control() || mean_ > 0; }
  double scale() const {
    return load_control() ? std::max({datum_ - mean_ * problem_.load() + highest_, problem_.least_scale(), 1e-300}) : 1.0;
  }
  double imbalance() const {
    return load_control() ? std::abs(now_.load / problem_.load() - 1) : std::abs(mean_ * now_.load - datum_);
  }
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
    if (elongated_) missing_ = unknown;
    if (load_control()) datum_ = (d_ > 0 ? d_ : 0.5) + mean_ * problem_.load();
    if (!given.warm) {
      now_ = replace_and_measure(s_, nullptr, datum_, team_);
      exact_ = worst();
    } else {
      refresh();
      reduce();
    }
    choose(0);
  }

  // Pressures that are worse than none become their best multiple.
  void reduce() {
    const double work = now_.moment - 2 * now_.merit + datum_ * now_.load;
    const double curved = now_.moment + work;
    if (0.5 * curved > work) {
      multiply(s_, curved > 0 ? std::max(0.0, work / curved) : 0, team_);
      refresh();
    }
  }

  // A periodic operator does not resist a change of the mean, and steps may raise the load without end. With the mean in the
  // operator they cannot: then the datum stands for the deflection that it adds, and is found together with the load.
  void add_mean() {
    refresh();
    reduce();
    mean_ = periodic_mean_;
    datum_ = mean_ * now_.load;
    conjugate_ = prepared_ = false;
    excess_ = missing_ = 0;
    mean_tried_ = true;
  }

  // Where nearly all points touch, the load grows so fast with the deflection that it is hard to find.
  void drop_mean() {
    mean_ = datum_ = 0;
    conjugate_ = prepared_ = false;
    refresh();
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
    // Long intervals end where a step gains little beside the first: what is left waits for the contact set.
    if (phase_ == 1) first_gain_ = slope * slope / curvature_;
    if (phase_ > first_interval && slope * slope / curvature_ < little * first_gain_) phase_ = interval_;
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
    return energy > 0 ? std::clamp(sum / energy, 1 / most_excess(), most_excess()) : 1;
  }

  // Newton's step of the approach on the load.
  void balance() {
    choose(0);
    const double pending = precondition(nullptr, s_.w);
    const double sum = total<Real>(s_.n, s_.first_spare(), team_);
    if (!(sum > 0)) return;
    // The mean deflects by less than the whole: where the trees tell more they have come to overrate the slope.
    if (excess_ == 0 || (!load_control() && mean_ * excess_ * sum > most_share)) excess_ = measured_excess(sum);
    if (!load_control()) return deflect(pending, sum);
    const double depth = scale(), missing = problem_.load() - now_.load + excess_ * pending;
    // What the last step left of the missing load tells the true slope: at once where the step was too long.
    const double left = missing / missing_;
    if (last_ < settled && left < 1)
      excess_ = std::clamp(excess_ * (1 - (left < 0 ? std::max(left, -1.0) : caution * left)), 1 / most_excess(), most_excess());
    else if (left < -1)  // steps that swing ever wider
      excess_ = std::min(excess_ * damping, most_excess());
    const double wanted = missing / (excess_ * sum);
    const bool far = imbalance() > overloaded;
    const double change =
        std::clamp(wanted, (far ? -most_fall_overloaded : -most_fall) * depth, std::max(depth, mean_ * problem_.load()));
    missing_ = change == wanted ? missing : far || elongated_ ? unknown : 0;
    lower(change);
  }

  // Newton's step of the datum on the deflection that the mean of the load adds to it.
  void deflect(double pending, double sum) {
    const double missing = mean_ * (now_.load - excess_ * pending) - datum_;
    const double left = missing / missing_;
    if (left < 0 ? last_ < settled : left < 1)
      stiffening_ *= 1 - (left < 0 ? std::max(left, -1.0) : caution * left);
    else if (left < -1)
      stiffening_ *= damping;
    stiffening_ = std::clamp(stiffening_, least_stiffening, most_stiffening);
    const double wanted = missing / (stiffening_ * std::max(1 - mean_ * excess_ * sum, least_slope)), depth = 1 + datum_;
    const double change = std::clamp(wanted, -0.5 * depth, depth);
    missing_ = change == wanted ? missing : unknown;
    lower(change);
  }

  // The exact load, a product in double precision, and the approach that makes the mean of the gap, weighted by the pressures,
  // vanish.
  void settle() {
    if (!load_control()) {
      refresh();
      if (mean_ > 0) {
        lower(mean_ * now_.load - datum_);
        exact_ = worst();
      }
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
      bool rose = !follows() && now_.merit > merit_before + merit_noise<Real> * std::abs(now_.merit);
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
      if (rose) ++rises;
      if (rose && rises > tolerated_stalls && mean_ > 0 && !load_control()) {
        drop_mean();
        best = last_ = worst();
      } else if (rose && rises > 1 && periodic_mean_ > 0 && !follows() && !mean_tried_) {
        rises = 0;
        add_mean();
      } else if (rose && rises > 1) {
        interval_ = std::min(longest_interval, 2 * interval_);
        admission_ = std::min(strictest_admission, admission_ + admission_step);
        conjugate_ = false;
      }
      if (follows())
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
  bool elongated_ = false, mean_tried_ = false;
  HaarTrees trees_;
  HaarState<Real> s_;
  HaarMeasure now_;
  double highest_ = 0;               // largest u
  double exact_ = 1;                 // residual of the last product in double precision
  double datum_ = 0;                 // w = H p - u - datum
  double excess_ = 0, missing_ = 0;  // of the slope; load that the last step of the approach should have added
  double stiffening_ = 1;            // of the datum's slope in displacement control
  double first_gain_ = 0;            // of energy, times two, in the first step of an interval
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
