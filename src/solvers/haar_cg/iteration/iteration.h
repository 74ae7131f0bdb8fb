// The method haar-cg, written once for every machine. README.md has it in pseudo-code, constants.md its numbers. The iteration
// never reads a vector's values: all its decisions follow from sums. What it consists of is constexpr, so that compilers for
// devices take it as code of theirs as well.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/by_value.h"
#include "solvers/haar_cg/iteration/interval.h"
#include "solvers/haar_cg/iteration/machine.h"
#include "solvers/haar_cg/iteration/newton_datum.h"
#include "solvers/haar_cg/iteration/pace.h"
#include "solvers/haar_cg/iteration/precision.h"
#include "solvers/haar_cg/iteration/progress.h"
#include "solvers/haar_cg/iteration/sought_load.h"
#include "solvers/haar_cg/iteration/task.h"

namespace rc {

// poll(steps, residual): called after every step with the number of steps and the last residual; whether to go on. It may leave
// by an exception instead.
template <Machine M, class Poll> class HaarIteration {
 public:
  constexpr HaarIteration(M& machine, const HaarTask& task, const Poll& poll)
      : m_(machine),
        task_(task),
        poll_(poll),
        kept_load_(task.load),
        mean_(task.by_load ? task.periodic_mean : 0),
        newton_(task.elongated) {}

  // Starts from the machine's pressures and, by load where there are none, from the approach given; 0: none is known.
  constexpr HaarOutcome run(double approach) {
    start(approach);
    const HaarEnding ending = precision_.fresh() && worst() <= task_.tol ? HaarEnding::solved : iterate();
    return {ending, datum_ - mean_ * now_.load};  // without the deflection that the added mean causes
  }

 private:
  using Real = typename M::Real;
  using Vector = typename M::Vector;
  using Wide = typename M::Wide;
  static constexpr int tolerated_rises = 2, most_rises = 8;  // troubles until the mean is dropped; until the load is sought
  static constexpr int most_descents = 4;  // to the least datum; each leaves a small share of the scale before it
  static constexpr double sharp = 1e4;     // of the tolerance: single precision knows a w of this size to a thousandth of it
  static constexpr double drift = 0.1;     // of the tolerance: error of a kept load that is put right without a cut
  static constexpr double most_swing = 6;  // of the limit: by how much the datum of the trees may raise it
  static constexpr double known = 0.5;     // residual over the datum below which the datum of a load that is sought is known
  static constexpr double most_stretch = 0.01, least_stretch = 0.05;  // of the pressures; of the residual
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  // Whether Newton's method moves the datum: by load, or with an added mean.
  constexpr bool follows() const { return !keeps_load_ && (task_.by_load || mean_ > 0); }
  constexpr double scale() const {
    return task_.by_load ? larger_of(larger_of(datum_ - mean_ * task_.load + highest_, task_.least_scale), 1e-300) : 1.0;
  }
  constexpr bool capped() const { return now_.free_load < now_.load; }  // some point is at the cap
  constexpr double imbalance() const {
    return task_.by_load ? std::abs(now_.load / task_.load - 1) : std::abs(mean_ * now_.load - datum_);
  }
  constexpr double worst() const { return larger_of(now_.largest / scale(), imbalance()); }

  // to = (H + mean 11') from. The mean makes the energy of a periodic contact depend on the mean pressure, also in full contact.
  template <class Handle> constexpr void product(Handle from, Handle to) {
    m_.product(from, to);
    if (mean_ != 0) m_.raise(to, mean_ * m_.total(from));
  }

  // z = M g on the free set; without g: z = M 1. Where steps keep the load the sum of z is 0. Returns (z, q), where q is given.
  constexpr double precondition(Vector g, Vector q) {
    if (!prepared_) m_.set_up_trees(keeps_load_ ? 0 : task_.periodic_mean - mean_);
    prepared_ = true;
    return m_.apply_trees(g, q, keeps_load_ ? &level_ : nullptr);
  }

  // A point at an end of its pressures enters the free set where it violates its condition by more than this.
  constexpr double threshold() const {
    if (capped()) return pace_.admission(true) * now_.largest;
    if (keeps_load_) {
      // Measured from the datum at which the mean of w, weighted by p, vanishes. That of the trees swings about it, and sets with
      // it.
      const double limit = pace_.admission(false) * now_.largest;
      return limit - within(now_.moment / now_.load, -(task_.elongated ? 1 : most_swing) * limit, limit);
    }
    return follows() ? 0 : pace_.admission(false) * last_ * scale();
  }

  constexpr void choose(double threshold) {
    if (m_.choose_set(threshold)) prepared_ = false;
  }

  // Computes w anew, from a product in double precision.
  constexpr void refresh() {
    prepared_ = false;
    product(m_.p(), m_.wide_spare());
    measure_at(datum_);
    precision_.refreshed();
  }
  constexpr void measure_at(double datum) {
    datum_ = datum;
    now_ = m_.replace_and_measure(m_.wide_spare(), datum_);
    precision_.found(worst());
  }

  constexpr void start(double approach) {
    const HaarStart given = m_.begin();
    highest_ = given.highest;
    keeps_load_ = task_.by_load && given.warm;
    if (keeps_load_) mean_ = 0;
    if (task_.by_load) datum_ = (approach > 0 ? approach : 0.5) + mean_ * task_.load;
    if (keeps_load_) {
      m_.multiply(task_.load / m_.total(m_.p()), true);
      refresh();
      if (capped()) {
        pace_.begin_at_cap();
        free_load();
      } else {
        measure_at(datum_ + now_.moment / now_.load);  // not lower(), by which w in single precision would lose its digits
      }
    } else if (!given.warm) {
      now_ = m_.replace_and_measure(Wide(nullptr), datum_);
      precision_.found(worst());
    } else {
      refresh();
      reduce();
      if (capped()) pace_.begin_at_cap();
    }
    choose(0);
  }

  // Replaces pressures that have more energy than p = 0 by their multiple of least energy.
  constexpr void reduce() {
    const double work = now_.moment - 2 * now_.merit + datum_ * now_.load, curved = now_.moment + work;
    if (0.5 * curved > work) {
      m_.multiply(curved > 0 ? larger_of(0.0, work / curved) : 0, false);
      refresh();
    }
  }

  // Along a conjugate direction; pressures may become negative until the next bound. False if the product is not finite.
  constexpr bool step() {
    const double zq = precondition(m_.w(), conjugate_ ? m_.q() : Vector(nullptr));
    const double beta = conjugate_ && curvature_ > 0 ? larger_of(0.0, -zq / curvature_) : 0;
    const double slope = m_.turn(beta);
    const bool needless = interval_.needless(slope);
    if (!needless) product(m_.t(), m_.q());
    curvature_ = needless ? 0 : m_.inner(m_.t(), m_.q());
    if (std::isnan(curvature_)) return false;
    conjugate_ = curvature_ > 0;
    interval_.add(slope, curvature_);
    cut_any_ = m_.advance(conjugate_ ? slope / curvature_ : 0, interval_.over(), !task_.elongated);
    return true;
  }

  // Adds to w the product of what the cut added to the pressures.
  constexpr void bound() {
    add_cut();
    interval_.begin(capped() && cut_any_ ? pace_.interval() / 2 : pace_.interval());
  }

  // If steps keep the load, the load that the cut added is removed by scaling, and the trees' level is added to the datum.
  constexpr void add_cut() {
    if (keeps_load_) {
      const double factor = kept_load_ / m_.total(m_.p());
      if (cut_any_ || std::abs(factor - 1) > drift * task_.tol) {
        m_.scale(factor, cut_any_);
        cut_any_ = true;
      }
      datum_ += level_;
    }
    // If the residual will need a product in double precision, that product includes the cut.
    if (precision_.refresh_due() || (cut_any_ && precision_.blurred(last_ * fall_))) return refresh();
    if (cut_any_) {
      prepared_ = false;
      product(m_.z(), m_.y());
    }
    now_ = m_.add_and_measure(cut_any_ ? m_.y() : Vector(nullptr), keeps_load_ ? level_ : 0);
    stretch();
  }

  // Replaces the pressures by their multiple of least energy, whose product is known. By approach the steps find that
  // multiple last. Without a cut it would spoil conjugate directions.
  constexpr void stretch() {
    if (!cut_any_ || task_.by_load || keeps_load_ || task_.periodic_mean > 0 || capped()) return;
    const double share = -now_.moment / (2 * (now_.moment - now_.merit));  // p'Hp = 2 (moment - merit)
    if (!(std::abs(share) < most_stretch) || std::abs(share) <= least_stretch * worst()) return;
    m_.multiply(1 + share, false);
    now_ = m_.grow_and_measure(share);
  }

  constexpr void lower(double change) {
    datum_ += change;
    now_ = m_.add_and_measure(Vector(nullptr), change);
  }

  // The same for the next step alone, which needs no measure.
  constexpr void raise(double change) {
    datum_ += change;
    m_.raise(m_.w(), -change);
  }

  // Every point is at an end of its pressures and should be. Before a point leaves its end, its w is as large as the change of
  // the datum. The rounding error of its w is relative to that.
  constexpr void release(const NewtonDatum::State& now) {
    double change = mean_ * now.load - datum_;
    if (task_.by_load) {
      const double missing = task_.load - now.load, nearest = m_.nearest(missing > 0) + 1e-3 * task_.tol * now.depth;
      change = nearest < infinite ? newton_.release(now, missing, nearest, task_.cap) : 0;
    }
    raise(change);
    precision_.moved(std::abs(change) / scale());
  }

  // Newton's step of the datum.
  constexpr void balance() {
    choose(threshold());
    NewtonDatum::State now{datum_, now_.load, scale(), 0, 0, last_};
    const auto slope = [&] {
      now.pending = precondition(Vector(nullptr), m_.w());
      now.slope = m_.total(m_.z());
      return now.slope > 0;
    };
    if (!slope()) {
      release(now);
      now.datum = datum_;
      now.depth = scale();
      choose(0);
      if (!slope()) return;
    }
    if (newton_.unmeasured(mean_, now.slope, task_.by_load)) {
      prepared_ = false;
      product(m_.z(), m_.y());
      newton_.measured(now.slope, m_.inner(m_.z(), m_.y()));
    }
    raise(task_.by_load ? newton_.to_load(now, task_.load, imbalance(), mean_) : newton_.to_deflection(now, mean_));
  }

  // Approach control by the load: the next load to keep, once the datum of the present one is known.
  constexpr void seek() {
    if (now_.largest > known * std::abs(datum_)) return;
    kept_load_ = sought_.next(datum_, kept_load_);
    progress_.restart();
  }

  // Some point is at the cap: from here on Newton's method moves the datum.
  constexpr void free_load() {
    keeps_load_ = conjugate_ = prepared_ = false;
    mean_ = task_.periodic_mean;
    datum_ += mean_ * now_.load;
  }

  // Every point is at an end. Lowers the datum until a point at the cap would leave it: first to a little above, so that the rest
  // keeps its digits in w. Little is relative to the scale, which falls with the datum.
  constexpr void descend() {
    const double little = smaller_of(NewtonDatum::blur, sharp * task_.tol);
    double nearest = m_.nearest(false), most = little;
    for (int passes = 0; passes < most_descents && nearest > most * scale(); ++passes, most = 2 * little) {
      datum_ -= nearest - little * scale();
      refresh();
      nearest = m_.nearest(false);
    }
    lower(-nearest);
  }

  // The pressures' factor to exactly the prescribed load.
  constexpr double to_load() const {
    const double at_cap = now_.load - now_.free_load;
    return task_.by_load && now_.free_load > 0 ? larger_of(0.0, task_.load - at_cap) / now_.free_load : 1;
  }

  // Whether a product in double precision would not be more accurate than w.
  constexpr bool exact() const {
    return mean_ == 0 && !task_.elongated && (now_.free_load > 0 || !capped()) && precision_.known(worst(), task_.tol) &&
           std::abs(to_load() - 1) <= drift * task_.tol;
  }

  // Confirms a residual that looks small enough, by a product in double precision where w is not exact. By load the pressures
  // are scaled to exactly that load, and the approach becomes the one at which the mean of the gap, weighted by the pressures
  // below the cap, vanishes. Where there are none it becomes the least at which no point at the cap has a gap. Whether the
  // residual is within the tolerance.
  constexpr bool settle() {
    bool known_well = exact();
    if (task_.by_load) m_.multiply(to_load(), true);
    if (!task_.by_load) datum_ = mean_ * now_.load;
    for (;; known_well = false) {
      if (!known_well) refresh();
      if (task_.by_load && now_.free_load > 0)
        lower(now_.free_moment / now_.free_load);
      else if (task_.by_load && capped())
        descend();
      if (!known_well) precision_.found(worst());
      if (!known_well || precision_.known(worst(), task_.tol)) return worst() <= task_.tol;
    }
  }

  // Worse than no pressure at all: a periodic operator does not resist a uniform one, so steps raise the load without end.
  constexpr bool runs_away() const { return now_.merit > 0 && may_run_away(); }
  constexpr bool may_run_away() const { return task_.periodic_mean > 0 && !task_.by_load && !mean_tried_; }

  // The function that the solution minimises, in load control among pressures of one load.
  constexpr double merit() const { return now_.merit + 0.5 * datum_ * now_.load; }

  // After the first trouble fewer points enter the free set and a steepest step is made. After the others bounds also become
  // rarer.
  constexpr void safeguard() {
    ++rises_;
    if (rises_ > tolerated_rises && mean_ > 0 && !task_.by_load) return drop_mean();
    if (rises_ > most_rises && mean_tried_ && !keeps_load_) return keep_load();
    if (runs_away()) return add_mean();
    pace_.admit_fewer();
    conjugate_ = false;
    if (rises_ <= 1) return;
    if (may_run_away()) return add_mean();
    pace_.make_more_steps();
  }

  // Without a mean in the operator steps may raise the load without end. The datum is then the deflection that it causes.
  constexpr void add_mean() {
    restart();
    mean_ = task_.periodic_mean;
    datum_ = mean_ * now_.load;
    newton_.begin_deflection();
    mean_tried_ = true;
  }

  // If nearly all points touch, the load grows too fast with the datum to be found.
  constexpr void drop_mean() {
    mean_ = datum_ = 0;
    conjugate_ = false;
    refresh();
  }

  // From here on steps keep the load, and the load is sought.
  constexpr void keep_load() {
    restart();
    keeps_load_ = true;
    kept_load_ = now_.load;
    progress_.forget_merit();
  }

  constexpr void restart() {
    refresh();
    reduce();
    conjugate_ = prepared_ = false;
    rises_ = 0;
  }

  constexpr HaarEnding iterate() {
    for (std::int64_t steps = 1;; ++steps) {
      if (!step()) return HaarEnding::not_finite;
      if (!interval_.over()) {
        if (!poll_(steps, last_)) return HaarEnding::stopped;
        continue;
      }
      bound();
      const bool solved = worst() <= task_.tol && settle();
      if (!solved && precision_.blurred(worst())) refresh();
      fall_ = last_ < infinite ? worst() / last_ : 1;
      last_ = worst();
      if (solved || (last_ <= task_.tol && precision_.fresh())) return HaarEnding::solved;
      if (!poll_(steps, last_)) return HaarEnding::stopped;
      const bool trouble = progress_.in_trouble(last_, merit(), HaarPrecision<Real>::merit_noise, !follows()) || runs_away();
      if (progress_.stalled() > task_.patience) return HaarEnding::stalled;
      const bool rose = now_.largest / scale() > violation_;
      violation_ = now_.largest / scale();
      if (capped()) pace_.adapt(rose);
      if (capped() && task_.by_load && keeps_load_) free_load();
      if (trouble)
        safeguard();
      else if (!capped())
        pace_.relieve(rose);
      if (follows()) {
        balance();
      } else {
        choose(threshold());
        if (keeps_load_ && !task_.by_load) seek();
      }
    }
  }

  M& m_;
  const HaarTask& task_;
  const Poll& poll_;
  bool keeps_load_ = false;  // steps and bounds leave the load as it is
  double kept_load_;         // that load
  double level_ = 0;         // of w, from the trees: less it, a step changes no load
  double mean_;              // what is added to every entry of the operator
  double datum_ = 0;         // w = H p - u - datum
  double highest_ = 0;       // largest u
  HaarMeasure now_;          // of the present p and w
  double last_ = infinite;   // residual after the last bound
  double fall_ = 1;          // that over the one before
  HaarPrecision<Real> precision_;
  double curvature_ = 0;  // (t, q) of the last step
  HaarPace pace_;
  HaarInterval interval_;
  bool conjugate_ = false;       // the next direction is made conjugate to t
  bool cut_any_ = false;         // the last bound cut pressures off
  bool prepared_ = false;        // the trees are set up for the present free set
  double violation_ = infinite;  // at the last bound, relative to the largest penetration
  NewtonDatum newton_;
  SoughtLoad sought_;
  HaarProgress progress_;
  int rises_ = 0;  // troubles
  bool mean_tried_ = false;
};

}  // namespace rc
