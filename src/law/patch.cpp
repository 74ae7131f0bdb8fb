#include "law/patch.h"

#include <roughcontact/analysis.h>
#include <roughcontact/derivatives.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/array.h"
#include "core/error.h"
#include "law/nesting.h"

namespace rc {

namespace {

constexpr double least_rate = 1e-3;  // of the overclosure with the approach: below, the patch is closed

void must(rc_status status) {
  if (status < 0 || status == RC_STOP_CANCELLED) fail(status, rc_last_error());
  if (status > 0) fail(RC_ERR_NUMERIC, "a node was not certified: ", rc_last_error());
}

std::int32_t bulk_of(const rc_system& system, const rc_law_spec& spec) {
  if (spec.bulk != RC_LAW_BULK_AUTO) return spec.bulk;
  return takes_mean_gap(system) ? RC_LAW_BULK_MEAN : RC_LAW_BULK_NONE;
}

}  // namespace

bool takes_mean_gap(const rc_system& system) {
  return system.op == RC_OPERATOR_HALFSPACE && system.boundary != RC_BOUNDARY_PERIODIC;
}

LawPatch::LawPatch(const rc_system& system, const rc_options* options, const rc_law_spec& spec)
    : system_(system), spec_(spec), bulk_(bulk_of(system, spec)) {
  set_options(options);
  rc_contact* made = nullptr;
  must(rc_contact_create(&system, options_.get(), &made));
  contact_.reset(made);
  must(rc_contact_on_progress(made, spec.progress, spec.user, 1));
  n_ = system.nx * system.ny;
  area_ = spec.area > 0 ? spec.area : static_cast<double>(n_) * system.hx * system.hy;
  const double* const gap = values_of<double>(spec.undeformed_gap);
  double sum = 0, lowest = std::numeric_limits<double>::infinity();
  for (std::int64_t i = 0; i < n_; ++i)
    if (included(i)) lowest = std::min(lowest, gap[i]), ++open_;
  if (open_ == 0) fail(RC_ERR_ARGUMENT, "all points are masked");
  if (const double least = static_cast<double>(open_) * system.hx * system.hy; area_ < least * (1 - 1e-12))
    fail(RC_ERR_ARGUMENT, "rc_law_spec.area = ", area_, " is smaller than the points that are not masked, ", least);
  from_touch_.resize(static_cast<std::size_t>(n_));
  for (std::int64_t i = 0; i < n_; ++i) {
    from_touch_[static_cast<std::size_t>(i)] = gap[i] - lowest;
    if (included(i)) sum += from_touch_[static_cast<std::size_t>(i)];
  }
  mean_gap_ = sum / static_cast<double>(open_);
  index_.resize(static_cast<std::size_t>(n_));
  p_.resize(static_cast<std::size_t>(n_));
  if (bulk_ != RC_LAW_BULK_MEAN) return;
  gap_.resize(static_cast<std::size_t>(n_));
  flat_ = pressed_flat();
  if (!std::isfinite(flat_))
    fail(RC_ERR_NUMERIC,
         "1'H1 hx hy, twice the energy of the pressure 1 on a flat gap, is beyond double precision: choose a larger "
         "unit of length");
}

void LawPatch::set_options(const rc_options* given) {
  rc_options* made = nullptr;
  must(given ? rc_options_copy(given, &made) : rc_options_create(nullptr, &made));
  options_.reset(made);
  double tol = 0;
  must(rc_options_get_number(made, RC_OPT_TOL, &tol));
  must(rc_options_set_number(made, RC_OPT_TOL, std::min({tol, 1e-8, 1e-3 * spec_.tolerance})));
  must(rc_options_set_number(made, RC_OPT_STIFFNESS, 2));
  must(rc_options_set_number(made, RC_OPT_BOUNDS, 1));
  must(rc_options_set_number(made, RC_OPT_ACCURACY, 0));
}

bool LawPatch::included(std::int64_t i) const {
  const std::uint8_t* const mask = values_of<std::uint8_t>(spec_.mask);
  return !mask || mask[i] != 0;
}

bool LawPatch::plastic() const { return system_.hardness > 0 && std::isfinite(system_.hardness); }

LawSample LawPatch::origin() const { return {.contacts = LawPoints(n_), .capped = LawPoints(n_)}; }

// The functional at the constant pressure p on a flat gap is (p^2/2 1'H1 - d p n) hx hy.
double LawPatch::pressed_flat() {
  const double unit = system_.modulus > 0 ? system_.modulus : 1, cell = system_.hx * system_.hy;
  const double pressure = plastic() ? std::min(unit, system_.hardness) / 2 : unit,
               approach = std::sqrt(cell * static_cast<double>(n_));
  const std::vector<double> flat(static_cast<std::size_t>(n_), 0.0);
  for (std::int64_t i = 0; i < n_; ++i) p_[static_cast<std::size_t>(i)] = included(i) ? pressure : 0;
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.target = approach;
  step.undeformed_gap = RC_IN(flat.data());
  step.mask = spec_.mask;
  rc_result result = RC_RESULT_INIT;
  result.p = RC_OUT(p_.data());
  if (const rc_status status = rc_contact_certify(contact_.get(), &step, &result); status < 0) fail(status, rc_last_error());
  return 2 * (result.energy / pressure + approach * cell * static_cast<double>(open_)) / pressure;
}

LawSample LawPatch::solve(std::int32_t control, double target) {
  if (plastic()) {  // each node presses the surface as it was before
    must(rc_contact_reset(contact_.get()));
    placed_ = false;
  }
  rc_step step = RC_STEP_INIT;
  step.control = control;
  step.target = target;
  if (!placed_) {
    step.undeformed_gap = RC_IN(from_touch_.data());
    step.mask = spec_.mask;
  }
  rc_result result = RC_RESULT_INIT;
  if (!gap_.empty()) result.gap = RC_OUT(gap_.data());
  must(rc_contact_solve(contact_.get(), &step, &result));
  placed_ = true;
  homogeneous_ = result.homogeneous == 1;
  ++solves_;

  LawSample sample = origin();
  std::int64_t count = 0;
  must(rc_contact_points(contact_.get(), n_, RC_OUT(index_.data()), RC_OUT(p_.data()), &count));
  for (std::int64_t i = 0; i < count; ++i) {
    sample.contacts.add(index_[static_cast<std::size_t>(i)]);
    if (plastic() && p_[static_cast<std::size_t>(i)] >= system_.hardness) sample.capped.add(index_[static_cast<std::size_t>(i)]);
  }
  sample.approach = result.approach;
  if (count > 0 && sample.contacts.within(sample.capped) && control == RC_CONTROL_LOAD && bulk_ == RC_LAW_BULK_MEAN)
    return solve(RC_CONTROL_APPROACH, result.approach);  // the load has no derivative
  sample.proven = std::isfinite(result.load_lower) && std::isfinite(result.load_upper) && std::isfinite(result.stiffness_lower) &&
                  std::isfinite(result.stiffness_upper);
  if (!sample.proven) {
    result.load_lower = result.load_upper = result.load;
    result.stiffness_lower = result.stiffness_upper = result.stiffness;
  }
  const Yield yields = yield(control, result, sample);
  check_yield(result, yields);
  rc_law_point& node = sample.node;
  node.x = yields.x;
  node.p = result.load / area_;
  node.slope = result.stiffness / area_ / yields.rate;
  node.slope_lower = std::min(node.slope, result.stiffness_lower / area_ / yields.rate_upper);
  node.slope_upper = std::max(node.slope, result.stiffness_upper / area_ / yields.rate_lower);
  node.p_lower = std::min(node.p, result.load_lower / area_ - node.slope_upper * yields.error);
  node.p_upper = std::max(node.p, result.load_upper / area_ + node.slope_upper * yields.error);
  node.area_fraction = result.contact_area / area_;
  const auto area = [&](double proven) { return std::isfinite(proven) ? proven / area_ : node.area_fraction; };
  node.area_lower = area(result.area_lower);
  node.area_upper = area(result.area_upper);
  node.energy = -result.energy / area_;
  if (bulk_ == RC_LAW_BULK_GIVEN) node.energy -= node.p * result.load / (2 * spec_.bulk_stiffness);
  if (bulk_ == RC_LAW_BULK_MEAN)
    node.energy -= node.p * (result.approach - node.x) / 2;  // as if in proportion to p: for the first
  sample.proven = sample.proven && sets_grow();
  return sample;
}

void LawPatch::check_yield(const rc_result& result, const Yield& yields) const {
  const double p = result.load / area_;
  if (std::isfinite(result.stiffness_upper) && yields.rate_lower > least_rate) return;
  if (bulk_ == RC_LAW_BULK_MEAN && result.capped == open_)
    fail(RC_ERR_INFEASIBLE, "at p = ", p, " all ", open_, " points carry the hardness ", system_.hardness,
         ": the mean gap does not change any more; lower p_upper");
  if (bulk_ == RC_LAW_BULK_GIVEN && std::isfinite(result.stiffness_upper))
    fail(RC_ERR_INFEASIBLE, "at p = ", p, " the stiffness of the patch, ", result.stiffness,
         ", is not below that of the bulk, rc_law_spec.bulk_stiffness = ", spec_.bulk_stiffness, "; lower p_upper");
  fail(RC_ERR_INFEASIBLE, "at p = ", p, " the patch is closed: it yields as a whole; lower p_upper");
}

// The kernels of half-spaces are assumed to have the property; a callback's nodes are never proven.
bool LawPatch::sets_grow() {
  if (!sets_grow_) sets_grow_ = system_.op != RC_OPERATOR_DENSE || rc::sets_grow(system_, values_of<std::uint8_t>(spec_.mask));
  return *sets_grow_;
}

std::optional<LawPatch::Slopes> LawPatch::slopes(const LawPoints& least, const LawPoints& most) const {
  if (bulk_ == RC_LAW_BULK_MEAN) return {};  // how the mean gap follows between two sets is not known
  std::vector<std::uint8_t> points(static_cast<std::size_t>(n_));
  const auto punch = [&](const LawPoints& set, bool upper) {
    for (std::int64_t i = 0; i < n_; ++i) points[static_cast<std::size_t>(i)] = set.has(i);
    double value = 0, bounds[2] = {};
    const rc_status status = rc_punch_stiffness(&system_, RC_IN(points.data()), options_.get(), &value, &bounds[0], &bounds[1]);
    if (status != RC_STOP_STALLED) must(status);
    const double stiffness = bounds[upper ? 1 : 0];
    return stiffness / area_ / (bulk_ == RC_LAW_BULK_GIVEN ? 1 - stiffness / spec_.bulk_stiffness : 1);
  };
  const Slopes found{punch(least, false), punch(most, true)};
  if (!(found.lower >= 0 && found.upper >= found.lower && std::isfinite(found.upper))) return {};
  return found;
}

LawPatch::Yield LawPatch::yield(std::int32_t control, const rc_result& result, const LawSample& sample) {
  if (bulk_ == RC_LAW_BULK_NONE) return {result.approach, 1, 1, 1, 0};
  if (bulk_ == RC_LAW_BULK_MEAN) return mean_yield(control, result, sample);
  const double k = spec_.bulk_stiffness;
  return {result.approach - result.load / k, 1 - result.stiffness / k, 1 - result.stiffness_upper / k,
          1 - result.stiffness_lower / k, (result.load_upper - result.load_lower) / k};
}

// The mean displacement m = 1'Hp / n. In the norm of H the pressures are within sqrt(2 duality gap) of the exact ones, and their
// rate on the contact set within sqrt(stiffness_upper - stiffness_lower), since rates on nested sets are projections of each
// other; so both means are uncertain by at most |1|_H / n times that.
LawPatch::Yield LawPatch::mean_yield(std::int32_t control, const rc_result& result, const LawSample& sample) {
  const double share = 1 / static_cast<double>(open_);
  for (std::int64_t i = 0; i < n_; ++i) p_[static_cast<std::size_t>(i)] = sample.capped.has(i) ? 0 : share;
  rc_gradient gradient = RC_GRADIENT_INIT;
  gradient.dJ_dgap = RC_IN(p_.data());
  const rc_status status = rc_contact_gradient(contact_.get(), &gradient);
  if (status != RC_STOP_STALLED) must(status);
  const double rate = -gradient.dJ_dtarget * (control == RC_CONTROL_LOAD ? result.stiffness : 1);
  const double norm = std::sqrt(flat_) * share / std::sqrt(system_.hx * system_.hy);
  const double cells = 1 / std::sqrt(system_.hx * system_.hy);
  const double wide = norm * cells * std::sqrt(std::max(0.0, result.stiffness_upper - result.stiffness_lower));
  const double error = std::isfinite(result.duality_gap) ? norm * cells * std::sqrt(2 * std::max(0.0, result.duality_gap)) : 0;
  return {mean_gap_ - result.mean_gap, rate, rate - wide, std::min(1.0, rate + wide), error};
}

}  // namespace rc
