// Projected flexible conjugate gradients on the contact set, preconditioned by two averaged multilevel trees that cut the surface
// at different places. Bounds are enforced every second step; a merit that rises, or a residual that stalls, makes the steps
// between longer and the admission of new points stricter.
//
// In load control the approach follows by Newton's method at the same time: the tree gives the slope of the load, and the load
// that the present gap still calls for.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solvers/haar_tree.h"
#include "solvers/solver.h"
#include "solvers/vector_math.h"

namespace rc {

namespace {

constexpr std::int64_t table_side = 64;  // couplings are averaged from this many offsets, and extrapolated beyond
constexpr int first_interval = 2, longest_interval = 16;
constexpr double first_admission = 0.1, strictest_admission = 0.9, admission_step = 0.2;
constexpr int patience = 10;           // bounded steps without half the residual before the safeguard acts
constexpr int hopeless = 60;           // and before the solver gives up
constexpr double slope_excess = 1.06;  // of the tree's slope of the load over the true one
constexpr int refresh_every = 8;       // bounded steps between fresh products that wash out drift
constexpr double infinite = std::numeric_limits<double>::infinity();

class Iteration {
 public:
  Iteration(const Problem& problem, Vector& p, double& d)
      : problem_(problem),
        n_(p.size()),
        p_(p),
        d_(d),
        u_(problem.u(), problem.u() + n_),
        w_(n_),
        t_(n_, 0.0),
        q_(n_),
        z_(n_),
        hz_(n_) {
    for (double& value : p_) value = std::max(value, 0.0);
    highest_ = *std::max_element(u_.begin(), u_.end());
    place();
  }

  rc_status run() {
    start();
    const rc_status status = iterate();
    d_ -= mean_ * load();  // back to the operator as given
    return status;
  }

 private:
  // The unknowns in their bounding box, and the trees over it.
  void place() {
    const rc_grid& grid = *problem_.grid();
    const auto point = [&](std::size_t i) { return grid.index ? grid.index[i] : static_cast<std::int64_t>(i); };
    std::int64_t left = grid.nx, right = -1;
    const std::int64_t low = point(0) / grid.nx, high = point(n_ - 1) / grid.nx;
    for (std::size_t i = 0; i < n_; ++i) {
      left = std::min(left, point(i) % grid.nx);
      right = std::max(right, point(i) % grid.nx);
    }
    const std::int64_t mx = right - left + 1, my = high - low + 1;
    cell_.resize(n_);
    for (std::size_t i = 0; i < n_; ++i)
      cell_[i] = static_cast<std::size_t>((point(i) / grid.nx - low) * mx + point(i) % grid.nx - left);
    const auto cells = static_cast<std::size_t>(mx * my);
    active_.assign(cells, 0);
    g_.assign(cells, 0.0);
    y_.assign(cells, 0.0);
    CouplingTable table{std::min(grid.nx, table_side), std::min(grid.ny, table_side), {}, grid.hx, grid.hy};
    problem_.coefficients(table.mx, table.my, table.k);
    if (grid.boundary == RC_BOUNDARY_PERIODIC) {
      // The mean of the periodic operator counts as its longest wave, so that the couplings are positive.
      const double unit = std::sqrt(grid.hx * grid.hy);
      const double longest = std::max(grid.hx * static_cast<double>(grid.nx), grid.hy * static_cast<double>(grid.ny)) / unit;
      const double mean = longest / std::numbers::pi / static_cast<double>(grid.nx * grid.ny);
      for (double& value : table.k) value += mean;
      if (load_control()) mean_ = mean;
    }
    trees_.emplace_back(mx, my, table, false);
    trees_.emplace_back(mx, my, table, true);
  }

  // The operator with the trees' mean: while the load is prescribed that only shifts the approach, and without it the load of a
  // periodic contact would have no curvature.
  void apply(const Vector& x, Vector& y) const {
    problem_.apply(x, y);
    if (mean_ == 0) return;
    const double mean = mean_ * sum_of(n_, [&](std::size_t i) { return x[i]; });
    for (double& value : y) value += mean;
  }
  bool load_control() const { return problem_.load_control(); }
  double scale() const {
    return load_control() ? std::max({d_ - mean_ * problem_.load() + highest_, problem_.least_scale(), 1e-300}) : 1.0;
  }

  void refresh() {
    apply(p_, w_);
    for (std::size_t i = 0; i < n_; ++i) w_[i] -= u_[i] + shift();
    since_refresh_ = 0;
  }
  double shift() const { return load_control() ? d_ : 0.0; }

  void start() {
    const bool warm = std::any_of(p_.begin(), p_.end(), [](double value) { return value > 0; });
    if (load_control() && !(d_ > 0)) d_ = 0.5;
    if (load_control()) d_ += mean_ * problem_.load();
    if (!warm) {
      for (std::size_t i = 0; i < n_; ++i) w_[i] = -(u_[i] + shift());
    } else {
      refresh();
      // A start that is worse than no pressure is reduced to its best multiple.
      const double curvature = sum_of(n_, [&](std::size_t i) { return p_[i] * (w_[i] + u_[i] + shift()); });
      const double work = sum_of(n_, [&](std::size_t i) { return p_[i] * (u_[i] + shift()); });
      if (0.5 * curvature > work) {
        const double factor = curvature > 0 ? std::max(0.0, work / curvature) : 0;
        for (std::size_t i = 0; i < n_; ++i) {
          w_[i] = factor * (w_[i] + u_[i] + shift()) - u_[i] - shift();
          p_[i] *= factor;
        }
      }
    }
    choose_set(0);
  }

  // Contact set: points with pressure, and those that overlap by more than the threshold.
  void choose_set(double threshold) {
    bool changed = set_.empty();
    set_.resize(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      const char in = p_[i] > 0 || w_[i] < -threshold;
      changed = changed || in != set_[i];
      set_[i] = in;
    }
    if (!changed) return;
    for (std::size_t i = 0; i < n_; ++i) active_[cell_[i]] = set_[i];
    for (HaarTree& tree : trees_) tree.set_up(active_);
  }

  // z = M v on the contact set
  template <class Value> void precondition(const Value& v, Vector& z) {
    for (std::size_t i = 0; i < n_; ++i) g_[cell_[i]] = set_[i] ? v(i) : 0.0;
    std::fill(y_.begin(), y_.end(), 0.0);
    for (HaarTree& tree : trees_) tree.apply_add(g_, 0.5, y_);
    for (std::size_t i = 0; i < n_; ++i) z[i] = set_[i] ? y_[cell_[i]] : 0.0;
  }

  double residual() const {
    double largest = 0;
    for (std::size_t i = 0; i < n_; ++i) largest = std::max(largest, p_[i] > 0 ? std::abs(w_[i]) : -w_[i]);
    return largest / scale();
  }
  double load() const {
    return sum_of(n_, [&](std::size_t i) { return p_[i]; });
  }
  double imbalance() const { return load_control() ? std::abs(load() / problem_.load() - 1) : 0.0; }

  double on_set(const Vector& a, const Vector& b) const {
    return sum_of(n_, [&](std::size_t i) { return set_[i] ? a[i] * b[i] : 0.0; });
  }

  // One step along a conjugate direction; pressures may become negative until the next bound.
  void step() {
    precondition([&](std::size_t i) { return w_[i]; }, z_);
    double beta = 0;
    if (conjugate_) {
      const double tq = on_set(t_, q_);
      beta = tq > 0 ? std::max(0.0, -on_set(z_, q_) / tq) : 0;
    }
    for (std::size_t i = 0; i < n_; ++i) t_[i] = set_[i] ? z_[i] + beta * t_[i] : 0.0;
    apply(t_, q_);
    conjugate_ = true;
    const double curvature = on_set(t_, q_), slope = on_set(w_, t_);
    if (std::isnan(curvature)) problem_.fail("haar-cg: the operator returned values that are not finite");
    if (!(curvature > 0)) {
      conjugate_ = false;
      phase_ = interval_;
      return;
    }
    const double length = slope / curvature;
    for (std::size_t i = 0; i < n_; ++i) {
      p_[i] -= length * t_[i];
      w_[i] -= length * q_[i];
    }
    ++phase_;
  }

  // Cuts negative pressures off.
  void bound() {
    phase_ = 0;
    bool any = false;
    for (std::size_t i = 0; i < n_; ++i) {
      z_[i] = std::max(-p_[i], 0.0);
      any = any || z_[i] > 0;
      p_[i] += z_[i];
    }
    if (++since_refresh_ >= refresh_every) return refresh();
    if (!any) return;
    apply(z_, hz_);
    for (std::size_t i = 0; i < n_; ++i) w_[i] += hz_[i];
  }

  // Newton's step of the approach on the load.
  void balance() {
    choose_set(0);
    precondition([](std::size_t) { return 1.0; }, z_);
    const double sum = sum_of(n_, [&](std::size_t i) { return z_[i]; });
    const double pending = sum_of(n_, [&](std::size_t i) { return z_[i] * w_[i]; });
    if (!(sum > 0)) return;
    const double depth = scale();
    const double change = std::clamp((problem_.load() - load() + slope_excess * pending) / (slope_excess * sum), -0.5 * depth,
                                     std::max(depth, mean_ * problem_.load()));
    d_ += change;
    for (double& value : w_) value -= change;
  }

  // The exact load, a fresh product, and the approach that makes the mean of the gap, weighted by the pressures, vanish.
  void settle() {
    if (!load_control()) {
      if (since_refresh_ > 0) refresh();
      return;
    }
    const double sum = load(), factor = sum > 0 ? problem_.load() / sum : 1;
    for (double& value : p_) value *= factor;
    refresh();
    const double moment = sum_of(n_, [&](std::size_t i) { return p_[i] * w_[i]; });
    const double change = sum > 0 ? moment / (factor * sum) : 0;
    d_ += change;
    for (double& value : w_) value -= change;
  }

  rc_status iterate() {
    last_ = residual();
    double best = infinite, merit_before = infinite;
    int since_best = 0, rises = 0;
    for (std::int64_t iteration = 1;; ++iteration) {
      step();
      if (phase_ < interval_) {
        problem_.poll(iteration, last_);
        continue;
      }
      bound();
      last_ = std::max(residual(), imbalance());
      if (last_ <= problem_.tol()) {
        settle();
        last_ = std::max(residual(), imbalance());
      }
      if (last_ <= problem_.tol()) return RC_OK;
      problem_.poll(iteration, last_);

      const double merit = sum_of(n_, [&](std::size_t i) { return 0.5 * p_[i] * (w_[i] - u_[i]); });
      bool rose = !load_control() && merit > merit_before + 1e-10 * std::abs(merit);
      merit_before = merit;
      if (last_ < 0.5 * best) {
        best = last_;
        since_best = stalled_ = 0;
      } else {
        ++since_best;
        ++stalled_;
      }
      if (stalled_ > hopeless) return RC_STOP_STALLED;
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
        choose_set(admission_ * last_ * scale());
    }
  }

  const Problem& problem_;
  const std::size_t n_;
  Vector& p_;
  double& d_;  // approach, in load control
  const Vector u_;
  Vector w_, t_, q_, z_, hz_;       // H p - u, direction, H t, preconditioned residual or what was cut off, its product
  double mean_ = 0;                 // what the trees' operator adds to every coefficient, in periodic load control
  double highest_ = 0;              // largest u
  std::vector<std::size_t> cell_;   // of each unknown in the box
  std::vector<char> set_, active_;  // contact set: of the unknowns, of the cells
  std::vector<double> g_, y_;       // over the box
  std::vector<HaarTree> trees_;
  int interval_ = first_interval, phase_ = 0, since_refresh_ = 0, stalled_ = 0;
  double admission_ = first_admission, last_ = infinite;
  bool conjugate_ = false;
};

}  // namespace

const Options haar_cg_options{};

rc_status haar_cg(const Problem& problem, Vector& p, double& d) { return Iteration(problem, p, d).run(); }

}  // namespace rc
