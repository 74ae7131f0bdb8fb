// From an answer on a trial set to a certified result.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "contact/bounds.h"
#include "contact/contact.h"
#include "contact/contact_set_solve.h"
#include "contact/plausibility.h"
#include "core/error.h"

namespace rc {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double stiffness_error = 1e-10;  // relative, where it is found by iteration
constexpr double subset_tol = 1e-12;       // residual without a preconditioner or a bound: the error is quadratic in it

template <std::size_t size> void copy_text(char (&to)[size], const char* text) { std::snprintf(to, size, "%s", text); }

std::string explain(rc_status status, const rc_result& result, double tol, const std::vector<std::string>& remarks) {
  std::string whole;
  for (const std::string& remark : remarks) whole += "; " + remark;
  return join(rc_status_text(status), ": kkt_primal ", result.kkt_primal, ", kkt_dual ", result.kkt_dual,
              ", kkt_complementarity ", result.kkt_complementarity, ", kkt_control ", result.kkt_control, ", tol ", tol,
              ", after ", result.iterations, " iterations", whole);
}

}  // namespace

void Contact::name_components(const Answer& answer, rc_result& result) {
  copy_text(result.kernel, system_.kernel.c_str());
  copy_text(result.solver, answer.choice.solver ? answer.choice.solver->name : "none");
  copy_text(result.backend, answer.choice.backend ? answer.choice.backend->name : "none");
  const std::uint64_t needs = answer.choice.solver ? answer.choice.solver->needs : 0;
  const auto replaced = [&](std::uint64_t operation, const char* systems) {
    if (answer.op && !(answer.op->capabilities() & operation))
      remarks_.push_back(join(systems, " by conjugate gradients: backend \"", answer.op->name(), "\" cannot factor"));
  };
  if (answer.handed_over) remarks_.push_back("load control of the solver stalled: iteration on the approach instead");
  if (answer.handed_over || (needs & RC_CAP_SUBSET)) replaced(RC_CAP_SUBSET, "systems on subsets");
  if (needs & RC_CAP_SHIFTED) replaced(RC_CAP_SHIFTED, "shifted systems");
}

// Whole remarks only, the gravest first.
void Contact::write_note(double compression, rc_result& result) {
  std::vector<std::string> all;
  if (system_.halfspace() && result.contacts > 0) {
    if (!tilt_) tilt_ = system_.periodic() ? 0 : plane_share(surface_, system_.given.nx, system_.given.ny);
    all = doubts(system_, result, compression, *tilt_);
  }
  if (std::isinf(result.load_upper)) all.emplace_back("no upper bound of the load is proven");
  all.insert(all.end(), remarks_.begin(), remarks_.end());
  std::string note;
  for (const std::string& remark : all) {
    if (note.size() + remark.size() + 6 > sizeof result.note) {
      note += note.empty() ? remark : "; ...";
      break;
    }
    note += (note.empty() ? "" : "; ") + remark;
  }
  copy_text(result.note, note.c_str());
}

// The problem's own: an answer must not set the scale that it is judged by. Periodic boundaries: in full contact the compression
// may vanish under any load, and a quarter of what the mean pressure does to one cell serves, which is less than any kernel gives
// for cells up to 100 times as long as wide; an approach leaves the load open if gaps under pressure may be as large as the mean
// gap, so they are held to half of it.
double Contact::residual_scale(const rc_step& step, double compression) const {
  if (!system_.periodic()) return compression;
  if (step.control == RC_CONTROL_LOAD) {
    const double mean_pressure = step.target / system_.cell_area() / static_cast<double>(system_.points());
    return std::max(compression, 0.25 * system_.length_per_pressure * mean_pressure);
  }
  if (!surface_.whole()) return compression;
  return std::min(compression, (surface_.mean_height() - compression) / (2 * options_.real(RC_OPT_TOL)));
}

// dW/dd = hx hy 1' H_CC^-1 1 on the contact set C.
double Contact::stiffness(const Answer& answer) {
  if (!answer.op) return 0;
  std::vector<std::int64_t> contact;
  for (std::size_t i = 0; i < answer.p.size(); ++i)
    if (answer.p[i] > 0) contact.push_back(static_cast<std::int64_t>(i));
  if (contact.empty()) return 0;
  const bool full = static_cast<std::int64_t>(contact.size()) == system_.points();
  if (system_.periodic() && full) return std::numeric_limits<double>::infinity();
  const std::vector<double> ones(contact.size(), 1.0);
  std::vector<double> rate(contact.size());
  double sum = 0, mean = answer.op->trial().zero_mode / static_cast<double>(system_.points());
  rc_status status = RC_OK;
  if (const double lowest = system_.periodic() ? system_.lambda_wave : system_.lambda_min;
      system_.halfspace() && !answer.op->has_subset() && lowest > 0) {
    ContactSetSolve solve(*answer.op, contact, grid(), lowest, *team_, [this](std::int64_t mx, std::int64_t my, auto& out) {
      out.resize(static_cast<std::size_t>(mx * my));
      raise_if_failed(coefficients(mx, my, out.data()), "the stiffness");
    });
    mean += solve.mean();
    // The division below multiplies the relative error by 1 / (1 - mean sum).
    const auto enough = [&](double form, double error) { return error <= stiffness_error * form * (1 - mean * form); };
    status = solve(ones, enough, rate, sum);
  } else {
    status = answer.op->subset(contact, ones.data(), rate.data(), subset_tol);
    for (const double value : rate) sum += value;
  }
  raise_if_failed(status, "the stiffness");
  if (status != RC_OK) return nan;
  // Without the rank-one zero mode (Sherman & Morrison 1950).
  sum /= 1 - mean * sum;
  return sum * system_.cell_area() / system_.length_per_pressure;
}

rc_status Contact::certify_and_fill(const rc_step& step, const Deflected& answer, double compression, rc_result& result) {
  const std::span<const double> p = answer.p();
  double sum = 0, work = 0, curved = 0, largest_p = 0, largest_product = 0;
  std::int64_t contacts = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (p[k] == 0 && std::isfinite(answer.product[k])) continue;
    const std::size_t i = answer.point(k);
    if (!surface_.included(i)) continue;
    sum += p[k];
    contacts += p[k] > 0;
    work += (0.5 * answer.product[k] - (compression - surface_.height(i))) * p[k];
    largest_p = std::max(largest_p, std::abs(p[k]));
    largest_product = std::max(largest_product, std::abs(answer.product[k]));
  }
  if (!system_.halfspace() && largest_p > 0) {
    // In units that cannot underflow.
    for (std::size_t k = 0; k < p.size() && largest_product > 0; ++k)
      curved += p[k] / largest_p * (answer.product[k] / largest_product);
    if (curved <= 0)
      fail(RC_ERR_NUMERIC, system_.given.op == RC_OPERATOR_DENSE ? "the dense matrix" : "the caller's apply function",
           " is not positive definite: p'Hp = ", curved * largest_p * largest_product, " for the pressures p found, must be > 0");
  }
  const double area = system_.cell_area();
  Bounds bounds;
  // Proofs need more digits than a goal of accuracy leaves.
  if (options_.integer(RC_OPT_BOUNDS) != 0 && goal_.error == 0) {
    if (!spectrum_) spectrum_ = spectrum_of(system_);
    bounds = prove_bounds(system_, *spectrum_, surface_, compression, answer);
  }
  Certificate certificate = certify(surface_, compression, answer, residual_scale(step, compression));
  if (step.control == RC_CONTROL_LOAD) certificate.control = load_imbalance(sum * area, step.target);
  if (std::isnan(certificate.dual) || !std::isfinite(sum * area) || !std::isfinite(work * area))
    fail(RC_ERR_NUMERIC,
         "the answer is not finite: the operator returned values that are not finite, or the units are such that ",
         "pressures, load or energy exceed double precision");

  result.reserved = 0;
  result.points = system_.points();
  result.contacts = contacts;
  result.load = sum * area;
  const bool given = step.control == RC_CONTROL_DISPLACEMENT;
  const double limit = given ? step.target : surface_.limit_of(compression);
  result.candidates = system_.positive ? surface_.extent_below(limit).n : surface_.included_points();
  result.displacement = given ? step.target : surface_.included_points() > 0 ? surface_.lowest() + compression : 0;
  result.mean_pressure = sum / static_cast<double>(system_.points());
  result.contact_area = static_cast<double>(contacts) * area;
  result.energy = work * area;
  result.kkt_primal = certificate.primal;
  result.kkt_dual = certificate.dual;
  result.kkt_complementarity = certificate.complementarity;
  result.kkt_control = certificate.control;
  result.tolerance = options_.real(RC_OPT_TOL);
  result.model_nx = system_.given.nx;
  result.model_ny = system_.given.ny;
  result.error_estimate = result.area_estimate = goal_.error > 0 ? 0 : nan;
  result.left_out = 0;
  bounds.write(result);
  write_note(compression, result);
  return certificate.within(options_.real(RC_OPT_TOL)) ? RC_OK : RC_STOP_UNCERTIFIED;
}

void Contact::write_gap(const Deflected& answer, double compression, double* gap) const {
  for (std::size_t i = 0; i < answer.size(); ++i) gap[i] = answer.product[i] - (compression - surface_.height(i));
}

// The caller's arrays are written when nothing can fail any more.
void Contact::deliver(Deflected&& answer, double compression, rc_result& result) {
  if (result.p) answer.pressures.write(result.p, system_.points());
  if (result.gap) write_gap(answer, compression, result.gap);
  if (result.status != RC_OK && result.status != RC_WITHIN_GOAL) return;
  before_ = std::move(last_);
  last_ = {std::move(answer.pressures), result.displacement, result.load, true};
}

std::int64_t Contact::contact_points(std::int64_t room, std::int64_t* index, double* p) const {
  const Pressures& last = last_.pressures;
  std::int64_t count = 0;
  for (std::size_t k = 0; k < last.p.size(); ++k) {
    if (!(last.p[k] > 0)) continue;
    if (count < room && index) index[count] = last.on.point(static_cast<std::int64_t>(k));
    if (count < room && p) p[count] = last.p[k];
    ++count;
  }
  return count;
}

// Where no entry of H and no pressure is negative, points whose gap is no smaller than the approach cannot overlap.
bool Contact::only_unknowns_matter(const Answer& answer) const {
  return answer.op && system_.positive && answer.status == RC_OK && answer.compression <= answer.limit &&
         std::all_of(answer.p.begin(), answer.p.end(), [](double p) { return p >= 0; });
}

// H p by the certifying operator: over all points, or over those that matter.
Deflected Contact::deflected(Answer& answer, bool everywhere) {
  if (answer.checked && !everywhere) return std::move(*answer.checked);
  Deflected result;
  if (!answer.op) {
    result.pressures.on.n = system_.points();
    result.pressures.p.assign(static_cast<std::size_t>(system_.points()), 0.0);
    result.product.assign(result.size(), 0.0);
    return result;
  }
  const std::string& certifier = options_.text(RC_OPT_CERTIFY_BACKEND);
  Operator& op =
      certifier.empty() ? *answer.op : bound_operator(certifying_backend(certifier, options_, system_), answer.op->trial());
  if (!everywhere && only_unknowns_matter(answer)) {
    result.product.resize(answer.p.size());
    raise_if_failed(op.apply(answer.p.data(), result.product.data()), "the certificate's product");
    for (double& value : result.product) value = value * answer.length_unit - answer.datum_shift;
    result.pressures = pressures_of(answer);
    return result;
  }
  result.product.resize(static_cast<std::size_t>(system_.points()));
  op.field(answer.p, result.product);
  for (double& value : result.product) value = value * answer.length_unit - answer.datum_shift;
  result.pressures.on.n = system_.points();
  Pressures own = pressures_of(answer);
  answer.p = {};
  if (own.on.index.empty()) {
    result.pressures.p = std::move(own.p);
  } else {
    result.pressures.p.resize(result.product.size());
    own.write(result.pressures.p.data(), system_.points());
  }
  return result;
}

rc_status Contact::finish(const rc_step& step, Answer&& answer, const Monitor& monitor, rc_result& result) {
  const double rate = options_.integer(RC_OPT_STIFFNESS) != 0 ? stiffness(answer) : nan;
  Deflected found = deflected(answer, result.gap != nullptr);
  double depth = step.control == RC_CONTROL_LOAD ? 0 : compression(step);
  result.modelled = 0;
  if (answer.op) {
    // Screening holds for its own approach alone.
    const bool stopped = step.control == RC_CONTROL_LOAD && answer.status != RC_OK && !answer.checked;
    depth = stopped ? fitting_compression(found) : answer.compression;
    result.modelled = answer.op->modelled();
  }
  name_components(answer, result);
  const rc_status checked = certify_and_fill(step, found, depth, result);
  result.stiffness = rate;
  result.status = checked == RC_OK || answer.status == RC_OK ? checked : answer.status;
  result.iterations = monitor.iterations();
  result.levels = std::count_if(levels_.begin(), levels_.end(), [](const auto& entry) { return entry.second.current; });
  result.applications = applications() - applications_before_;
  result.setup_seconds = setup_seconds_;
  result.seconds = std::max(0.0, monitor.seconds() - setup_seconds_);
  if (result.status != RC_OK) set_message(explain(result.status, result, options_.real(RC_OPT_TOL), remarks_).c_str());
  deliver(std::move(found), depth, result);
  return result.status;
}

// The compression at which the mean of the gap, weighted by the pressures, vanishes.
double Contact::fitting_compression(const Deflected& answer) const {
  double sum = 0, moment = 0;
  for (std::size_t k = 0; k < answer.size(); ++k) {
    const double p = answer.p()[k];
    if (p == 0) continue;
    sum += p;
    moment += p * (answer.product[k] + surface_.height(answer.point(k)));
  }
  return sum > 0 ? moment / sum : 0;
}

rc_status Contact::certify_given(const rc_step& step, rc_result& result) {
  if (!result.p) fail(RC_ERR_ARGUMENT, "rc_result.p is null: the pressures to certify are expected there");
  const std::span<const double> p(result.p, static_cast<std::size_t>(system_.points()));
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!std::isfinite(p[i])) fail(RC_ERR_ARGUMENT, "rc_result.p[", i, "] = ", p[i], " is not finite");
    if (p[i] != 0 && (step.mask ? step.mask[i] == 0 : !step.gap && !surface_.empty() && !surface_.included(i)))
      fail(RC_ERR_ARGUMENT, "rc_result.p[", i, "] = ", p[i], " but this point is excluded by the mask");
  }
  begin(step);
  const Monitor monitor(cancelled_, {}, 0, 1);
  TrialSet trial;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i] == 0) continue;
    trial.index.push_back(static_cast<std::int64_t>(i));
  }
  trial.n = static_cast<std::int64_t>(trial.index.size());
  if (trial.n == system_.points()) trial.index.clear();

  Deflected given;
  given.pressures.on.n = system_.points();
  given.pressures.p.assign(p.begin(), p.end());
  given.product.assign(p.size(), 0.0);
  std::vector<double>& product = given.product;
  Answer answer;
  if (trial.n > 0) {
    answer = prepare(trial, RC_CONTROL_DISPLACEMENT, 1);
    answer.pressure_unit = 1;
    answer.op = &bound_operator(*answer.choice.backend, trial);
    for (std::int64_t i = 0; i < trial.n; ++i) answer.p.push_back(p[static_cast<std::size_t>(trial.point(i))]);
    answer.op->field(answer.p, product);
    for (double& value : product) value *= system_.length_per_pressure;
  }
  const double depth = step.control == RC_CONTROL_LOAD ? fitting_compression(given) : compression(step);
  name_components(answer, result);
  copy_text(result.solver, "none");
  result.modelled = answer.op ? answer.op->modelled() : 0;
  result.status = certify_and_fill(step, given, depth, result);
  result.stiffness = options_.integer(RC_OPT_STIFFNESS) != 0 ? stiffness(answer) : nan;
  result.iterations = 0;
  result.levels = 0;
  result.applications = applications() - applications_before_;
  result.setup_seconds = setup_seconds_;
  result.seconds = std::max(0.0, monitor.seconds() - setup_seconds_);
  if (result.status != RC_OK) set_message(explain(result.status, result, options_.real(RC_OPT_TOL), remarks_).c_str());
  if (result.gap) write_gap(given, depth, result.gap);
  return result.status;
}

}  // namespace rc
