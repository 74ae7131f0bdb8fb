#include "contact/slopes/derivatives.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "contact/operators.h"
#include "contact/slopes/subset_solve.h"
#include "core/error.h"
#include "core/grid.h"
#include "core/sums.h"

namespace rc {

namespace {

using Field = std::vector<double>;

constexpr double looser =
    300;  // residuals of the solves over the tolerance: derivatives are of use to fewer digits than pressures
constexpr double least_residual = 1e-11, most_residual = 1e-4;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double total(const Field& x) {
  return sum_of(x.size(), [&](std::size_t k) { return x[k]; });
}
double dot(const Field& x, const Field& y) {
  return sum_of(x.size(), [&](std::size_t k) { return x[k] * y[k]; });
}
double euclidean(const Field& x) { return std::sqrt(dot(x, x)); }

void check_finite(double value, const char* name) {
  if (!std::isfinite(value)) fail(RC_ERR_ARGUMENT, name, " = ", value, " is not finite");
}

// The loaded points, and C: those in contact below the hardness, whose pressures change; those of the other loaded points stay.
class ContactSet {
 public:
  ContactSet(const GridProblem& problem, const CertifiedStep& last) : loaded_(last.pressures.positive(problem.team())) {
    const double depth = last.approach - problem.surface.lowest();
    for (std::size_t k = 0; k < loaded_.p.size(); ++k) {
      if (loaded_.p[k] >= problem.system.hardness) continue;
      points_.push_back(loaded_.on.index[k]);
      among_loaded_.push_back(k);
      u_.push_back(depth - problem.surface.height(point(n() - 1)));
    }
  }

  const Pressures& loaded() const { return loaded_; }
  std::size_t n() const { return points_.size(); }
  const std::vector<std::int64_t>& points() const { return points_; }
  std::size_t point(std::size_t k) const { return static_cast<std::size_t>(points_[k]); }
  std::size_t among_loaded(std::size_t k) const { return among_loaded_[k]; }
  const Field& u() const { return u_; }  // [length]

 private:
  const Pressures loaded_;
  std::vector<std::int64_t> points_;
  std::vector<std::size_t> among_loaded_;
  Field u_;
};

// One equation's answer: A x = b.
struct Solution {
  Field x;
  double sum = 0;
  double residual = 0;  // |b - A x| is at most that; NaN: not known
};

// Bounds of the errors of solutions. flat: the one for b = 1.
struct SolutionErrors {
  std::size_t n = 0;
  double lowest = 0;  // eigenvalue of A, from below; 0: none is known

  double of(const Solution& x) const { return n == 0 ? 0 : lowest > 0 ? x.residual / lowest : unknown; }
  double of_sum(const Solution& x, const Solution& flat) const {
    return lowest > 0 ? x.residual * std::sqrt(flat.sum / lowest) : unknown;
  }
  // Likewise of x + part flat.x, where `part` is off by up to `doubt`.
  double of(const Solution& x, double part, double doubt, const Solution& flat) const {
    return of(x) + std::abs(part) * of(flat) + euclidean(flat.x) * doubt;
  }
};

// The step whose derivatives are asked for. Lengths and pressures are the caller's; solutions of A x = b, A = H[C,C] + mean 11',
// have the units of b: H is dimensionless where the operator applies it.
class Linearised {
 public:
  Linearised(const GridProblem& problem, const Memory& memory, const Monitor& monitor)
      : problem_(problem),
        last_(memory.outcome),
        monitor_(monitor),
        before_(problem.operators().spent().products),
        set_(problem, memory.last) {
    if (last_.certified == 0)
      fail(
          RC_ERR_ARGUMENT,
          "only a certified step has derivatives: solve one first that returns RC_OK on the given grid (contacts that were just ",
          "made, reset or restored have none)");
    if (by_load() && set_.loaded().empty())
      fail(RC_ERR_ARGUMENT, "the load is 0: no point carries pressure, so that the approach has no derivative; give a load > 0");
    if (by_load() && set_.n() == 0)
      fail(RC_ERR_ARGUMENT, "all ", set_.loaded().p.size(), " points in contact carry the hardness ", system().hardness,
           ": the load does not determine the approach, which has no derivative; give a smaller load");
  }

  bool by_load() const { return last_.certified == RC_CONTROL_LOAD; }
  const System& system() const { return problem_.system; }
  const ContactSet& set() const { return set_; }
  bool included(std::size_t i) const { return problem_.surface.included(i); }
  double unit() const { return system().length_per_pressure; }
  std::int64_t undecided() const { return last_.undecided; }
  std::int64_t products() const { return problem_.operators().spent().products - before_; }

  // Values given for all points: NaN counts where no mask excludes the point.
  void check(const double* values, const char* name) const {
    for (std::size_t i = 0; values && i < static_cast<std::size_t>(system().points()); ++i)
      if (included(i) && !std::isfinite(values[i]))
        fail(RC_ERR_ARGUMENT, name, "[", i, "] = ", values[i], " is not finite (",
             place(static_cast<std::int64_t>(i), system().given.nx), ")");
  }

  // H x / unit() at the loaded points, for x on all points, 0 at excluded ones.
  rc_status multiplied(const double* x, Field& out) {
    TrialSet trial;
    const std::vector<std::int64_t>& loaded = set_.loaded().on.index;
    std::size_t k = 0;
    for (std::int64_t i = 0; i < system().points(); ++i) {
      const bool touches = k < loaded.size() && loaded[k] == i;
      k += touches;
      if (touches || (included(static_cast<std::size_t>(i)) && x[i] != 0)) trial.index.push_back(i);
    }
    trial = all_if_full(std::move(trial.index));
    // This product may need another backend than the step.
    const Choice choice = choose_for(problem_, trial, last_.certified, last_.failed, false);
    Operator& op = problem_.operators().bound(*choice.backend, trial);
    const Operator::Watch watch(op, [this] { return monitor_.ask(); });
    Field spread(static_cast<std::size_t>(trial.n)), product(spread.size());
    for (std::size_t i = 0; i < spread.size(); ++i) {
      const std::int64_t at = trial.point(static_cast<std::int64_t>(i));
      spread[i] = included(static_cast<std::size_t>(at)) ? x[at] : 0;
    }
    const rc_status status = op.apply(spread.data(), product.data());
    raise_if_failed(status, "a product for the derivatives");
    const std::vector<std::int64_t> positions = *positions_in(trial, loaded);
    for (std::size_t i = 0; i < out.size() && status == RC_OK; ++i) out[i] = product[static_cast<std::size_t>(positions[i])];
    return status;
  }

  // H x on all points, for x on the loaded points [length]. No solve may follow.
  void deflection(const Field& x, Field& everywhere) {
    Operator& op = on(set_.loaded().on.index);
    op.field(x, everywhere);
    const double datum = op.trial().zero_mode / static_cast<double>(system().points()) * total(x);
    for (double& value : everywhere) value = (value - datum) * unit();
  }

  rc_status solve(const Field& b, Solution& out) {
    Operator& op = on(set_.points());
    if (!solve_) solve_.emplace(problem_, op, all_positions());
    const Operator::Watch watch(op, [this] { return monitor_.ask(); });
    double size = 0;
    for (const double value : b) size = std::max(size, std::abs(value));
    out = {Field(set_.n()), 0, 0};
    if (size == 0) return RC_OK;
    Field scaled = b;
    for (double& value : scaled) value /= size;
    ContactSetBound bound;
    const double tol = std::clamp(looser * problem_.options.real(RC_OPT_TOL), least_residual, most_residual);
    rc_status status = (*solve_)(scaled, tol, out.x, bound);
    if (status == RC_OK || status == RC_STOP_STALLED)
      if (const rc_status proof = solve_->prove(scaled, out.x, bound); proof != RC_OK) status = proof;
    if (status == RC_STOP_STALLED && std::ranges::all_of(out.x, [](double value) { return value == 0; }))
      fail(RC_ERR_NUMERIC, "the solve on the ", set_.n(),
           " points in contact ended where it began: conjugate gradients lowered no ",
           "residual; give H as a matrix (RC_OPERATOR_DENSE), which is factored");
    for (double& value : out.x) value *= size;
    out.sum = total(out.x);
    out.residual = bound.residual * size;
    stalled_ = stalled_ || status == RC_STOP_STALLED;
    return status == RC_STOP_STALLED ? RC_OK : status;
  }
  double mean() const { return solve_ ? solve_->mean() : 0; }
  rc_status status() const { return stalled_ ? RC_STOP_STALLED : RC_OK; }

  SolutionErrors errors() const { return {set_.n(), solve_ ? solve_->lowest() : 0}; }

 private:
  TrialSet all_if_full(std::vector<std::int64_t> points) const {
    const auto size = static_cast<std::int64_t>(points.size());
    return size == system().points() ? TrialSet{size, {}} : TrialSet{size, std::move(points)};
  }
  std::vector<std::int64_t> all_positions() const {
    std::vector<std::int64_t> positions(set_.n());
    std::iota(positions.begin(), positions.end(), std::int64_t{0});
    return positions;
  }
  // The step's operator, bound to these points. Factors of a periodic H exist in full contact only with a mean.
  Operator& on(const std::vector<std::int64_t>& points) {
    const rc_backend& backend = *last_.choice.backend;
    TrialSet trial = all_if_full(points);
    if (system().periodic() && backend.subset) trial.zero_mode = system().bounds.lambda_most;
    return problem_.operators().bound(backend, trial);
  }

  const GridProblem& problem_;
  const StepOutcome& last_;
  const Monitor& monitor_;
  const std::int64_t before_;
  const ContactSet set_;
  std::optional<SubsetSolve> solve_;
  bool stalled_ = false;
};

// The multiple of s that turns A^-1 b into H_CC^-1 b (Sherman & Morrison 1950).
double without_mean(double mean, const Solution& x, const Solution& flat) {
  return mean == 0 ? 0 : mean * x.sum / (1 - mean * flat.sum);
}

// The change of the pressures on the contact set, where x solves A x = b: x + part flat has the sum that the load prescribes, or
// is free of the mean.
struct Change {
  Field p;
  double error = 0;  // of p, Euclidean; NaN: not known
  double sum = 0, flat_sum = 0, mean = 0, part = 0;
};

// uniform: all values of b are the same. sum: of the change, in load control.
rc_status change(Linearised& step, const Field& b, bool uniform, double sum, Change& out) {
  const std::size_t n = step.set().n();
  Solution x, flat;
  if (n > 0 && (uniform || step.by_load() || step.system().periodic()))
    if (const rc_status status = step.solve(Field(n, 1.0), flat); status != RC_OK) return status;
  if (uniform && n > 0) {
    x = {flat.x, flat.sum * b[0], flat.residual * std::abs(b[0])};
    for (double& value : x.x) value *= b[0];
  } else if (n > 0) {
    if (const rc_status status = step.solve(b, x); status != RC_OK) return status;
  }
  const SolutionErrors errors = step.errors();
  const double mean = step.mean(), part = step.by_load() ? (sum - x.sum) / flat.sum : without_mean(mean, x, flat);
  const double doubt_of_sum = errors.of_sum(x, flat) + std::abs(part) * errors.of_sum(flat, flat);
  const double doubt = step.by_load() ? doubt_of_sum / flat.sum : mean != 0 ? mean / (1 - mean * flat.sum) * doubt_of_sum : 0;
  out = {x.x, part == 0 ? errors.of(x) : errors.of(x, part, doubt, flat), x.sum, flat.sum, mean, part};
  for (std::size_t k = 0; k < n && part != 0; ++k) out.p[k] += part * flat.x[k];
  return RC_OK;
}

}  // namespace

rc_status differentiate(const GridProblem& problem, const Memory& memory, const Monitor& monitor, rc_gradient& request) {
  Linearised step(problem, memory, monitor);
  const System& system = step.system();
  const ContactSet& set = step.set();
  const double area = system.cell_area();
  const double *const dJ_dp = values_of<double>(request.dJ_dp), *const dJ_dgap = values_of<double>(request.dJ_dgap);
  step.check(dJ_dp, "rc_gradient.dJ_dp");
  step.check(dJ_dgap, "rc_gradient.dJ_dgap");
  check_finite(request.dJ_dload, "rc_gradient.dJ_dload");
  check_finite(request.dJ_dapproach, "rc_gradient.dJ_dapproach");
  const bool nothing = !dJ_dp && !dJ_dgap && request.dJ_dload == 0 && request.dJ_dapproach == 0;
  const double by_load = nothing && !step.by_load() ? 1 : request.dJ_dload;
  double direct = nothing && step.by_load() ? 1 : request.dJ_dapproach;  // dJ/dd while p stays
  const std::size_t all = static_cast<std::size_t>(system.points());
  const auto by_gap = [&](std::size_t i) { return dJ_dgap && step.included(i) ? dJ_dgap[i] : 0; };
  direct -= sum_of(all, by_gap);

  // b = (dJ/dp + H dJ/dg)_C / unit. It is a multiple of 1 if J depends on load and approach alone.
  Field product(set.loaded().p.size()), b(set.n());
  if (dJ_dgap && !product.empty())
    if (const rc_status status = step.multiplied(dJ_dgap, product); status != RC_OK) return status;
  for (std::size_t k = 0; k < b.size(); ++k) {
    const double by_p = (dJ_dp ? dJ_dp[set.point(k)] : 0) + by_load * area;
    b[k] = by_p / step.unit() + product[set.among_loaded(k)];
  }
  const bool uniform = !dJ_dp && !dJ_dgap;
  Change w;
  if (const rc_status status = change(step, b, uniform, -direct, w); status != RC_OK) return status;
  request.dJ_dtarget = step.by_load() ? (w.sum + direct * (1 - w.mean * w.flat_sum)) * step.unit() / (area * w.flat_sum)
                                      : w.sum + w.part * w.flat_sum + direct;
  request.error = w.error;
  request.dJ_dmodulus =
      system.halfspace() ? (dot(w.p, set.u()) - step.unit() * dot(product, set.loaded().p)) / system.given.modulus : unknown;
  request.undecided = step.undecided();
  request.products = step.products();
  if (double* const out = values_of<double>(request.dJ_dundeformed_gap)) {
    for (std::size_t i = 0; i < all; ++i) out[i] = by_gap(i);
    for (std::size_t k = 0; k < w.p.size(); ++k) out[set.point(k)] -= w.p[k];
  }
  return step.status();
}

rc_status differentiate(const GridProblem& problem, const Memory& memory, const Monitor& monitor, rc_tangent& request) {
  Linearised step(problem, memory, monitor);
  const System& system = step.system();
  const ContactSet& set = step.set();
  const double area = system.cell_area();
  const double* const change_of_gap = values_of<double>(request.dundeformed_gap);
  step.check(change_of_gap, "rc_tangent.dundeformed_gap");
  check_finite(request.dtarget, "rc_tangent.dtarget");
  check_finite(request.dmodulus, "rc_tangent.dmodulus");
  if (!system.halfspace() && request.dmodulus != 0)
    fail(RC_ERR_ARGUMENT, "rc_tangent.dmodulus = ", request.dmodulus, " but the system is no half-space: it has no modulus");
  const double softer = system.halfspace() ? request.dmodulus / system.given.modulus : 0;
  const auto dh = [&](std::size_t i) { return change_of_gap && step.included(i) ? change_of_gap[i] : 0; };
  double dd = step.by_load() ? 0 : request.dtarget;

  const bool uniform = !change_of_gap && softer == 0;
  Field r(set.n());
  for (std::size_t k = 0; k < r.size(); ++k) r[k] = (dd - dh(set.point(k)) + softer * set.u()[k]) / step.unit();
  const double force = request.dtarget / area;
  Change changed;
  if (const rc_status status = change(step, r, uniform, force, changed); status != RC_OK) return status;
  if (step.by_load()) dd = step.unit() * (changed.part - changed.mean * force);
  const Field& dp = changed.p;

  const std::size_t all = static_cast<std::size_t>(system.points());
  if (double* const dgap = values_of<double>(request.dgap)) {
    Field moved(all);
    Field stiffened = set.loaded().p;
    for (double& value : stiffened) value *= -softer;
    for (std::size_t k = 0; k < dp.size(); ++k) stiffened[set.among_loaded(k)] += dp[k];
    if (!stiffened.empty()) step.deflection(stiffened, moved);
    for (std::size_t i = 0; i < all; ++i) dgap[i] = step.included(i) ? moved[i] - (dd - dh(i)) : 0;
    for (std::size_t k = 0; k < dp.size(); ++k) dgap[set.point(k)] = 0;
  }
  if (double* const out = values_of<double>(request.dp)) {
    std::fill_n(out, all, 0.0);
    for (std::size_t k = 0; k < dp.size(); ++k) out[set.point(k)] = dp[k];
  }
  request.dload = step.by_load() ? request.dtarget : total(dp) * area;
  request.dapproach = dd;
  request.error = changed.error;
  request.undecided = step.undecided();
  request.products = step.products();
  return step.status();
}

}  // namespace rc
