// The method haar-cg, written once for every machine. README.md has it in pseudo-code and explains the constants. The iteration
// never reads a vector's values: all its decisions follow from sums.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solvers/haar_cg/known_loads.h"
#include "solvers/haar_cg/machine.h"
#include "solvers/haar_cg/task.h"

namespace rc {

template <Machine M> class HaarIteration {
 public:
  HaarIteration(M& machine, const HaarTask& task) : m_(machine), task_(task), mean_(task.by_load ? task.periodic_mean : 0) {}

  // Starts from the machine's pressures and, by load, from the approach given; 0: none is known.
  HaarOutcome run(double approach) {
    start(approach);
    const HaarEnding ending = iterate();
    return {ending, datum_ - mean_ * now_.load};  // without the deflection that the added mean causes
  }

 private:
  using Real = typename M::Real;
  using Vector = typename M::Vector;
  using Wide = typename M::Wide;

  // Interval: steps between two bounds. Admission: a point at an end of its pressures enters the free set where it violates its
  // condition by more than this share of the residual.
  static constexpr int first_interval = 2, longest_interval = 16;
  static constexpr double first_admission = 0.1, strictest_admission = 0.9, admission_step = 0.2;
  // The same where points are at the cap; added after a bound at which the violation rose, taken off after any other.
  static constexpr double capped_admission = 0.3, capped_rise = 0.3, capped_relief = 0.2;
  static constexpr double little = 1e-4;    // of the energy that an interval's first step gains: a step that gains less ends it
  static constexpr int refresh_every = 12;  // bounds between two refreshes, which remove drift

  // The safeguard acts after `patience` bounds in which the residual has not halved, or after a rise of the merit.
  static constexpr int patience = 10;
  static constexpr double progress = 0.5;

  // Newton's method on the load or, where a mean was added to a periodic operator, on the deflection that this mean causes.
  static constexpr double usual_excess = 2, elongated_excess = 10;       // largest correction of the trees' slope, either way
  static constexpr double caution = 0.7, damping = 1.2;                  // lengthens steps less; shortens diverging ones
  static constexpr double settled = 5e-2;                                // residual below which the free set changes little
  static constexpr double overloaded = 10;                               // relative imbalance: the approach may then fall by more
  static constexpr double most_fall = 0.5, most_fall_overloaded = 0.95;  // of the compenetration in a step
  static constexpr double least_stiffening = 1e-2, most_stiffening = 4, least_slope = 1e-4;
  static constexpr double most_share = 0.99;  // of the deflection under a load: the added mean makes up less
  static constexpr double few = 2;            // points whose caps make up the missing load: then the nearest one is released
  static constexpr double blur = 1e-5;        // of the compenetration: error of such a state's datum
  static constexpr int tolerated_rises = 2;   // troubles before the search with the added mean is given up

  static constexpr bool single = sizeof(Real) < sizeof(double);
  static constexpr double drop = single ? 1e-4 : 0;             // fall of the residual up to which single precision is reliable
  static constexpr double merit_noise = single ? 1e-6 : 1e-10;  // relative rise of the merit that rounding explains
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  // The present state.

  double most_excess() const { return task_.elongated ? elongated_excess : usual_excess; }
  // Whether Newton's method moves the datum: by load, or with an added mean.
  bool follows() const { return task_.by_load || mean_ > 0; }
  double scale() const {
    return task_.by_load ? std::max({datum_ - mean_ * task_.load + highest_, task_.least_scale, 1e-300}) : 1.0;
  }
  bool capped() const { return now_.free_load < now_.load; }  // some point is at the cap
  double imbalance() const { return task_.by_load ? std::abs(now_.load / task_.load - 1) : std::abs(mean_ * now_.load - datum_); }
  double worst() const { return std::max(now_.largest / scale(), imbalance()); }
  // Single precision is reliable for a few digits below the residual of the last product in double precision.
  bool blurred() const { return single && worst() <= drop * exact_; }

  // Operator, preconditioner, free set.

  // to = (H + mean 11') from. By load the added mean only shifts the datum by a multiple of the load. Without it the energy of a
  // periodic contact would hardly depend on the mean pressure, and in full contact not at all.
  template <class Handle> void product(Handle from, Handle to) {
    m_.product(from, to);
    if (mean_ != 0) m_.raise(to, mean_ * m_.total(from));
  }

  // z = M g on the free set; without g: z = M 1. Returns (z, q), where q is given.
  double precondition(Vector g, Vector q) {
    if (!prepared_) m_.set_up_trees(task_.periodic_mean - mean_);
    prepared_ = true;
    return m_.apply_trees(g, q);
  }

  // A point at an end of its pressures enters the free set where it violates its condition by more than this.
  double threshold() const {
    if (capped()) return std::max(admission_, capped_admission) * now_.largest;
    return follows() ? 0 : admission_ * last_ * scale();
  }

  void choose(double threshold) {
    if (m_.choose_set(threshold)) prepared_ = false;
  }

  // Computes w anew, from a product in double precision.
  void refresh() {
    prepared_ = false;
    product(m_.p(), m_.wide_spare());
    now_ = m_.replace_and_measure(m_.wide_spare(), datum_);
    since_refresh_ = 0;
    exact_ = worst();
  }

  // Start.

  void start(double approach) {
    const HaarStart given = m_.begin();
    highest_ = given.highest;
    if (task_.elongated) missing_ = unknown;
    if (task_.by_load) datum_ = (approach > 0 ? approach : 0.5) + mean_ * task_.load;
    if (!given.warm) {
      now_ = m_.replace_and_measure(Wide(nullptr), datum_);
      exact_ = worst();
    } else {
      refresh();
      reduce();
      if (capped()) admission_ = strictest_admission;
    }
    choose(0);
  }

  // Replaces pressures that have more energy than p = 0 by their multiple of least energy.
  void reduce() {
    const double work = now_.moment - 2 * now_.merit + datum_ * now_.load;
    const double curved = now_.moment + work;
    if (0.5 * curved > work) {
      m_.multiply(curved > 0 ? std::max(0.0, work / curved) : 0, false);
      refresh();
    }
  }

  // One step, and the bound after an interval of steps.

  // One step along a conjugate direction. Pressures may become negative until the next bound. False where the product is not
  // finite.
  bool step() {
    const double zq = precondition(m_.w(), conjugate_ ? m_.q() : Vector(nullptr));
    const double beta = conjugate_ && curvature_ > 0 ? std::max(0.0, -zq / curvature_) : 0;
    const double slope = m_.turn(beta);
    product(m_.t(), m_.q());
    curvature_ = m_.inner(m_.t(), m_.q());
    if (std::isnan(curvature_)) return false;
    conjugate_ = curvature_ > 0;
    // A long interval ends where a step gains little beside the first: a better free set then gains more than further steps.
    ++phase_;
    if (phase_ == 1) first_gain_ = slope * slope / curvature_;
    if (phase_ > first_interval && slope * slope / curvature_ < little * first_gain_) phase_ = planned_;
    const bool last = phase_ >= planned_ || !conjugate_;
    if (!conjugate_) phase_ = planned_;
    cut_any_ = m_.advance(conjugate_ ? slope / curvature_ : 0, last);
    return true;
  }

  // Adds to w the product of what the cut added to the pressures.
  void bound() {
    phase_ = 0;
    add_cut();
    planned_ = capped() && cut_any_ ? interval_ / 2 : interval_;
  }

  void add_cut() {
    if (++since_refresh_ >= refresh_every) return refresh();
    if (cut_any_) {
      prepared_ = false;
      product(m_.z(), m_.y());
    }
    now_ = m_.add_and_measure(cut_any_ ? m_.y() : Vector(nullptr), 0);
  }

  // The load.

  void lower(double change) {
    datum_ += change;
    now_ = m_.add_and_measure(Vector(nullptr), change);
  }

  // The same for the next step alone, which needs no measure.
  void raise(double change) {
    datum_ += change;
    m_.raise(m_.w(), -change);
  }

  // The slope of the load over the trees' slope, sum = 1'z with z = M 1. The multiple of z that has the least energy is
  // 1'z / z'Hz, with an error of second order in that of M.
  double measured_excess(double sum) {
    prepared_ = false;
    product(m_.z(), m_.y());
    const double energy = m_.inner(m_.z(), m_.y());
    return energy > 0 ? std::clamp(sum / energy, 1 / most_excess(), most_excess()) : 1;
  }

  // Every point is at an end of its pressures and should be: the load is exactly that of the present datum. Moves the datum at
  // least to where the first point leaves its end.
  void release() {
    if (!task_.by_load) return raise(mean_ * now_.load - datum_);
    const double missing = task_.load - now_.load, nearest = m_.nearest(missing > 0) + 1e-3 * task_.tol * scale();
    if (nearest == infinite) return;
    raise(loads_.leave(datum_, blur * scale(), now_.load, missing, nearest, std::abs(missing) <= few * task_.cap));
  }

  // Newton's step of the approach. The missing load is what remains to be added once the present gap is closed.
  void balance() {
    choose(threshold());
    double pending = precondition(Vector(nullptr), m_.w()), sum = m_.total(m_.z());
    if (!(sum > 0)) {
      release();
      choose(0);
      pending = precondition(Vector(nullptr), m_.w());
      sum = m_.total(m_.z());
      if (!(sum > 0)) return;
    }
    // The added mean causes less than the whole deflection. Where the trees contradict that, they overrate the slope.
    if (excess_ == 0 || (!task_.by_load && mean_ * excess_ * sum > most_share)) excess_ = measured_excess(sum);
    if (!task_.by_load) return deflect(pending, sum);
    const double depth = scale(), missing = task_.load - now_.load + excess_ * pending;
    // The share of the missing load that the last step left corrects the slope: in full where the step was too long.
    const double left = missing / missing_;
    if (last_ < settled && left < 1)
      excess_ = std::clamp(excess_ * (1 - (left < 0 ? std::max(left, -1.0) : caution * left)), 1 / most_excess(), most_excess());
    else if (left < -1)  // the steps diverge
      excess_ = std::min(excess_ * damping, most_excess());
    const double wanted = missing / (excess_ * sum);
    const bool far = imbalance() > overloaded;
    const double change = loads_.between(
        datum_, std::clamp(wanted, (far ? -most_fall_overloaded : -most_fall) * depth, std::max(depth, mean_ * task_.load)));
    missing_ = change == wanted ? missing : far || task_.elongated ? unknown : 0;
    raise(change);
  }

  // Newton's step of the datum in displacement control: the datum must become the deflection that the added mean causes.
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
    raise(change);
  }

  // Every point is at an end. Lowers the datum until a point at the cap would leave it: first to a little above, so that the rest
  // keeps its digits in w.
  void descend() {
    if (const double fall = m_.nearest(false) - blur * scale(); fall > 0) {
      datum_ -= fall;
      refresh();
    }
    lower(-m_.nearest(false));
  }

  // Confirms a residual that looks small enough, by a product in double precision. By load the pressures are scaled to exactly
  // that load, and the approach becomes the one at which the mean of the gap, weighted by the pressures below the cap, vanishes.
  // Where there are none it becomes the least at which no point at the cap has a gap.
  void settle() {
    const double at_cap = now_.load - now_.free_load;
    if (task_.by_load) m_.multiply(now_.free_load > 0 ? std::max(0.0, task_.load - at_cap) / now_.free_load : 1, true);
    refresh();
    if (task_.by_load) {
      if (now_.free_load > 0)
        lower(now_.free_moment / now_.free_load);
      else if (capped())
        descend();
    } else if (mean_ > 0) {
      lower(mean_ * now_.load - datum_);
    }
    exact_ = worst();
  }

  // Safeguards.

  // After a bound, where points are at the cap. A point that leaves one end drives its neighbours to the other, so fewer may
  // leave their ends at once where that makes things worse.
  void adapt_admission() {
    const double violation = now_.largest / scale();
    if (capped())
      admission_ =
          std::clamp(admission_ + (violation > violation_ ? capped_rise : -capped_relief), first_admission, strictest_admission);
    violation_ = violation;
  }

  // Worse than no pressure at all: on a periodic surface steps raise the load without end.
  bool runs_away() const { return now_.merit > 0 && task_.periodic_mean > 0 && !follows() && !mean_tried_; }

  // After a bound: whether the merit rose, or the residual has not halved for `patience` bounds.
  bool in_trouble() {
    bool trouble = runs_away() || (!follows() && now_.merit > merit_before_ + merit_noise * std::abs(now_.merit));
    merit_before_ = now_.merit;
    ++since_best_;
    ++stalled_;
    if (last_ < progress * best_) {
      best_ = last_;
      since_best_ = stalled_ = 0;
    }
    if (since_best_ >= patience) {
      trouble = true;
      since_best_ = 0;
    }
    return trouble;
  }

  // The first trouble is tolerated.
  void safeguard() {
    ++rises_;
    if (rises_ > tolerated_rises && mean_ > 0 && !task_.by_load) return drop_mean();
    if (runs_away()) return add_mean();
    if (rises_ <= 1) return;
    if (task_.periodic_mean > 0 && !follows() && !mean_tried_) return add_mean();
    interval_ = std::min(longest_interval, 2 * interval_);
    admission_ = std::min(strictest_admission, admission_ + admission_step);
    conjugate_ = false;
  }

  // A periodic operator does not resist a uniform pressure, so steps may raise the load without end. With a mean added to the
  // operator they cannot. The datum is then the deflection that this mean causes, and is found together with the load.
  void add_mean() {
    refresh();
    reduce();
    mean_ = task_.periodic_mean;
    datum_ = mean_ * now_.load;
    conjugate_ = prepared_ = false;
    excess_ = missing_ = 0;
    mean_tried_ = true;
    rises_ = 0;
  }

  // Gives that search up: where nearly all points touch, the load grows too fast with the datum to be found.
  void drop_mean() {
    mean_ = datum_ = 0;
    conjugate_ = prepared_ = false;
    refresh();
    best_ = last_ = worst();
  }

  HaarEnding iterate() {
    for (std::int64_t steps = 1;; ++steps) {
      if (!step()) return HaarEnding::not_finite;
      if (phase_ > 0 && phase_ < planned_) {
        task_.poll(steps, last_);
        continue;
      }
      bound();
      if (worst() <= task_.tol)
        settle();
      else if (blurred())
        refresh();
      last_ = worst();
      if (last_ <= task_.tol && since_refresh_ == 0) return HaarEnding::solved;
      task_.poll(steps, last_);
      adapt_admission();
      const bool trouble = in_trouble();
      if (stalled_ > task_.patience) return HaarEnding::stalled;
      if (trouble) safeguard();
      if (follows())
        balance();
      else
        choose(threshold());
    }
  }

  M& m_;
  const HaarTask& task_;
  double mean_;             // what is added to every entry of the operator
  double datum_ = 0;        // w = H p - u - datum
  double highest_ = 0;      // largest u
  HaarMeasure now_;         // of the present p and w
  double last_ = infinite;  // residual after the last bound
  double exact_ = 1;        // residual of the last product in double precision
  int since_refresh_ = 0;   // bounds since then

  double curvature_ = 0;                      // (t, q) of the last step
  double first_gain_ = 0;                     // twice the energy gained by the first step of the interval
  int interval_ = first_interval;             // steps of an interval
  int planned_ = first_interval, phase_ = 0;  // steps of this interval; how many were made
  bool conjugate_ = false;                    // the next direction is made conjugate to t
  bool cut_any_ = false;                      // the last bound cut pressures off
  bool prepared_ = false;                     // the trees are set up for the present free set
  double admission_ = first_admission;
  double violation_ = infinite;  // at the last bound, relative to the largest compenetration

  KnownLoads loads_;
  double excess_ = 0;      // slope of the load over the trees' slope; 0: not measured yet
  double missing_ = 0;     // load, or deflection, that the last Newton's step was to make up; NaN: not known
  double stiffening_ = 1;  // correction of the datum's slope in displacement control

  double best_ = infinite, merit_before_ = infinite;
  int since_best_ = 0, stalled_ = 0,
      rises_ = 0;  // bounds since the residual halved or patience ran out; since it halved; troubles
  bool mean_tried_ = false;
};

}  // namespace rc
