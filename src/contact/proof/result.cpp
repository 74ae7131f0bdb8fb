#include "contact/proof/result.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <span>

#include "contact/proof/bounds.h"
#include "contact/proof/certificate.h"
#include "contact/proof/plausibility.h"
#include "contact/proof/survey.h"
#include "contact/slopes/punch_stiffness.h"
#include "contact/slopes/stiffness.h"
#include "contact/step/target.h"
#include "contact/step/trial_set.h"
#include "contact/surface/output_array.h"
#include "core/certificate_terms.h"
#include "core/error.h"
#include "core/large_memory.h"
#include "core/limits.h"

namespace rc {

namespace {

template <std::size_t size> void copy_text(char (&to)[size], const char* text) { std::snprintf(to, size, "%s", text); }

std::string explain(rc_status status, const rc_result& result, double tol, const std::vector<std::string>& remarks) {
  std::string whole;
  for (const std::string& remark : remarks) whole += "; " + remark;
  return join(rc_status_text(status), ": kkt_primal ", result.kkt_primal, ", kkt_dual ", result.kkt_dual,
              ", kkt_complementarity ", result.kkt_complementarity, ", kkt_control ", result.kkt_control, ", tol ", tol,
              ", after ", result.iterations, " iterations", whole);
}

// Whole remarks only, the gravest first.
void write_note(Workspace& work, double compression, const Rim& rim, rc_result& result) {
  const System& system = work.system;
  std::vector<std::string> all;
  std::string edges;
  if (system.halfspace() && result.contacts > 0) {
    if (!work.facts.tilt) work.facts.tilt = plane_share(work.surface, system.given.nx, system.given.ny, system.periodic());
    all = doubts(system, result, compression, *work.facts.tilt);
    edges = edge_effects(result, rim, *work.facts.tilt);
  }
  if (std::isinf(result.load_upper)) all.emplace_back("no upper bound of the load is proven");
  all.insert(all.end(), work.record.remarks.begin(), work.record.remarks.end());
  if (!edges.empty()) all.push_back(edges);
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

Stiffness wanted_stiffness(Workspace& work, const Answer& answer) {
  return work.options.integer(RC_OPT_STIFFNESS) != 0 ? stiffness(work, answer) : Stiffness{};
}

// The operator whose products certify, for the trial set of the one that solved.
Operator& certifying(Workspace& work, Operator& solving) {
  const std::string& name = work.options.text(RC_OPT_CERTIFY_BACKEND);
  return name.empty() ? solving : work.bound_operator(certifying_backend(name, work.options, work.system), solving.trial());
}

// For the interval of the stiffness; null if it is proven that nothing touches.
Operator* proving(Workspace& work, const Answer& answer) {
  if (answer.op) return &certifying(work, *answer.op);
  const std::vector<std::int64_t>& possible = work.record.proven->possible;
  TrialSet trial{static_cast<std::int64_t>(possible.size()), possible};
  if (work.surface.united(trial.n) == 0) return nullptr;
  if (work.ranks() || trial.n == work.system.points()) trial = {work.own_points(), {}};
  return &certifying(work, work.bound_operator(*prepared(trial, RC_CONTROL_APPROACH, 1, work).choice.backend, trial));
}

// Where no entry of H and no pressure is negative, points whose gap is no smaller than the approach cannot overlap.
bool only_unknowns_matter(const Workspace& work, const Answer& answer) {
  return answer.op && work.system.positive && answer.status == RC_OK && answer.compression <= answer.limit &&
         std::all_of(answer.p.begin(), answer.p.end(), [](double p) { return p >= 0; });
}

// Writes the result, its message and the caller's arrays. rate: the stiffness, where the answer has given its pressures away.
void finish(Workspace& work, const rc_step& step, const Answer& answer, const Deflected& found, double depth,
            std::optional<Stiffness> rate, const Monitor& monitor, rc_result& result) {
  result.modelled = answer.op ? answer.op->modelled() : 0;
  name_components(work, answer, result);
  if (!rate) rate = wanted_stiffness(work, answer);
  const rc_status checked = certify_and_fill(work, step, found, depth, rate->value, result);
  if (work.record.proven) prove_interval(work, proving(work, answer), *rate);
  result.stiffness = rate->value;
  result.stiffness_lower = rate->lower;
  result.stiffness_upper = rate->upper;
  result.status = checked == RC_OK || answer.status == RC_OK ? checked : answer.status;
  count_work(work, monitor, result);
  if (result.status != RC_OK)
    set_message(explain(result.status, result, work.options.real(RC_OPT_TOL), work.record.remarks).c_str());
  write_arrays(work, found, depth, result);
}

}  // namespace

void name_components(Workspace& work, const Answer& answer, rc_result& result) {
  copy_text(result.kernel, work.system.kernel.c_str());
  copy_text(result.solver, answer.choice.solver ? answer.choice.solver->name : "none");
  copy_text(result.backend, answer.choice.backend ? answer.choice.backend->name : "none");
  const std::uint64_t needs = answer.choice.solver ? answer.choice.solver->needs : 0;
  const auto replaced = [&](std::uint64_t operation, const char* systems) {
    if (answer.op && !(answer.op->capabilities() & operation))
      work.record.remarks.push_back(join(systems, " by conjugate gradients: backend \"", answer.op->name(), "\" cannot factor"));
  };
  if (answer.handed_over)
    work.record.remarks.emplace_back("load control of the solver stalled: iteration on the approach instead");
  if (answer.handed_over || (needs & RC_CAP_SUBSET)) replaced(RC_CAP_SUBSET, "systems on subsets");
  if (needs & RC_CAP_SHIFTED) replaced(RC_CAP_SHIFTED, "shifted systems");
  const System& system = work.system;
  if (system.halfspace() && !system.influence->built_in() && (system.periodic() ? system.lambda_wave : system.lambda_min) == 0 &&
      work.options.integer(RC_OPT_BOUNDS) != 0 && work.goal.error == 0)
    work.record.remarks.push_back(join("bounds: kernel \"", system.kernel, "\" promises no lowest eigenvalue"));
}

namespace {

struct Totals {
  double sum = 0, energy = 0, overlap = 0, max_pressure = 0, largest_p = 0, largest_product = 0, on_rim = 0, largest_on_rim = 0;
  std::int64_t contacts = 0, capped = 0;

  Totals operator+(const Totals& b) const {
    return {sum + b.sum,
            energy + b.energy,
            overlap + b.overlap,
            std::max(max_pressure, b.max_pressure),
            std::max(largest_p, b.largest_p),
            std::max(largest_product, b.largest_product),
            on_rim + b.on_rim,
            std::max(largest_on_rim, b.largest_on_rim),
            contacts + b.contacts,
            capped + b.capped};
  }
};

}  // namespace

double mean_gap(const Workspace& work, const Survey& everywhere, double overlap) {
  return (everywhere.sum_of_gaps + overlap) / static_cast<double>(work.surface.included_points());
}

rc_status certify_and_fill(Workspace& work, const rc_step& step, const Deflected& answer, double compression, double stiffness,
                           rc_result& result) {
  const System& system = work.system;
  const StepSurface& surface = work.surface;
  const std::span<const double> p = answer.p();
  const RimPoints rim(system.given, surface.first_row());
  double curved = 0;
  const Survey found = survey(surface, compression, answer);
  const auto add = [&](Totals& part, std::size_t k) {
    if (p[k] == 0 && std::isfinite(answer.product[k])) return;
    const std::size_t i = answer.point(k);
    if (!surface.included(i)) return;
    part.sum += p[k];
    part.contacts += p[k] > 0;
    if (p[k] >= system.hardness) {
      ++part.capped;
      part.overlap += std::max(0.0, compression - surface.height(i) - answer.product[k]);
    }
    part.energy += (0.5 * answer.product[k] - (compression - surface.height(i))) * p[k];
    part.max_pressure = std::max(part.max_pressure, p[k]);
    part.largest_p = std::max(part.largest_p, std::abs(p[k]));
    if (rim.holds(i)) {
      part.on_rim += p[k];
      part.largest_on_rim = std::max(part.largest_on_rim, p[k]);
    }
    part.largest_product = std::max(part.largest_product, std::abs(answer.product[k]));
  };
  const auto [sum, energy, overlap, max_pressure, largest_p, largest_product, on_rim, largest_on_rim, contacts, capped] =
      surface.sum_over<Totals>(std::span<const std::size_t>(found.touching), add);
  if (!system.halfspace() && largest_p > 0) {
    // Scaled, so that the products do not underflow.
    if (largest_product > 0)
      for (const std::size_t k : found.touching) curved += p[k] / largest_p * (answer.product[k] / largest_product);
    if (curved <= 0)
      fail(RC_ERR_NUMERIC, system.given.op == RC_OPERATOR_DENSE ? "the dense matrix" : "the caller's apply function",
           " is not positive definite: p'Hp = ", curved * largest_p * largest_product, " for the pressures p found, must be > 0");
  }
  const double area = system.cell_area();
  Bounds bounds;
  // With an accuracy goal there are too few digits for proofs.
  if (work.options.integer(RC_OPT_BOUNDS) != 0 && work.goal.error == 0) {
    std::optional<Spectrum>& spectrum = work.facts.spectrum;
    if (!spectrum) spectrum = spectrum_of(system);
    ProvenSets sets;
    const bool asked = work.options.integer(RC_OPT_STIFFNESS) == 2;
    bounds = prove_bounds(system, *spectrum, surface, compression, answer, found, asked ? &sets : nullptr);
    work.record.proven = asked && bounds.undecided >= 0 && sets.listed ? std::optional(std::move(sets)) : std::nullopt;
  }
  Certificate certificate =
      certify(surface, compression, answer, found, residual_scale(step, work, compression), system.hardness);
  if (step.control == RC_CONTROL_LOAD) certificate.control = load_imbalance(sum * area, step.target);
  if (std::isnan(certificate.dual) || !std::isfinite(sum * area) || !std::isfinite(energy * area))
    fail(RC_ERR_NUMERIC,
         "the answer is not finite: the operator returned values that are not finite, or the units are such that ",
         "pressures, load or energy exceed double precision");

  result.reserved = 0;
  result.points = system.points();
  result.contacts = contacts;
  result.load = sum * area;
  const bool given = step.control == RC_CONTROL_APPROACH;
  const double limit = given ? step.target : surface.limit_of(compression);
  result.candidates = system.positive ? surface.extent_below(limit).n : surface.included_points();
  result.approach = given ? step.target : surface.included_points() > 0 ? surface.lowest() + compression : 0;
  result.mean_pressure = sum / static_cast<double>(system.points());
  result.capped = capped;
  result.plastic_volume = overlap * area;
  result.area_fraction = static_cast<double>(contacts) / static_cast<double>(system.points());
  result.max_pressure = max_pressure;
  result.mean_gap = static_cast<std::int64_t>(answer.size()) == work.own_points() ? mean_gap(work, found, overlap) : nan;
  result.contact_area = static_cast<double>(contacts) * area;
  result.energy = energy * area;
  result.kkt_primal = certificate.primal;
  result.kkt_dual = certificate.dual;
  result.kkt_complementarity = certificate.complementarity;
  result.kkt_control = certificate.control;
  result.tolerance = work.options.real(RC_OPT_TOL);
  const double estimate = work.goal.error > 0 ? 0 : nan;
  work.record.accuracy = {sizeof(rc_accuracy), system.given.nx, system.given.ny, estimate, estimate, 0};
  result.stiffness = stiffness;
  if (!std::isnan(stiffness) && !work.facts.punch) work.facts.punch = punch_stiffness(system);
  result.punch_stiffness = std::isnan(stiffness) ? nan : *work.facts.punch;
  bounds.write(result);
  write_note(work, compression, {rim.share(), sum > 0 ? on_rim / sum : 0, largest_on_rim > 0 && largest_on_rim == largest_p},
             result);
  return certificate.within(work.options.real(RC_OPT_TOL)) ? RC_OK : RC_UNCERTIFIED;
}

void count_work(const Workspace& work, const Monitor& monitor, rc_result& result) {
  result.iterations = monitor.iterations();
  result.levels = work.solver_grids.current();
  result.products = work.products() - work.record.products_before;
  result.setup_seconds = work.record.setup_seconds;
  result.seconds = std::max(0.0, monitor.seconds() - result.setup_seconds);
}

void write_arrays(const Workspace& work, const Deflected& answer, double compression, const rc_result& result) {
  answer.pressures.write(pressures_of(result), work.own_points(), work.team());
  const OutputArray gap = gap_of(result);
  if (!gap.wanted()) return;
  each_chunk(static_cast<std::int64_t>(answer.size()), work.team(), [&](std::int64_t begin, std::int64_t count) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(begin + count); ++i)
      gap.put(i, answer.product[i] - (compression - work.surface.height(i)));
  });
}

namespace {

// From the dimensionless product to lengths.
void take_units(const Answer& answer, const Workspace& work, std::vector<double>& product) {
  each_chunk(static_cast<std::int64_t>(product.size()), work.team(), [&](std::int64_t begin, std::int64_t count) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(begin + count); ++i)
      product[i] = product[i] * answer.length_unit - answer.datum_shift;
  });
}

}  // namespace

Deflected deflected(Workspace& work, Answer& answer, bool everywhere) {
  if (answer.checked && (!everywhere || answer.checked->on().n == work.own_points())) return std::move(*answer.checked);
  Deflected result;
  if (!answer.op) {
    result.pressures.on.n = work.own_points();
    on_all(work.ranks(), [&] {
      result.pressures.p.assign(static_cast<std::size_t>(work.own_points()), 0.0);
      result.product.assign(result.size(), 0.0);
    });
    return result;
  }
  Operator& op = certifying(work, *answer.op);
  if (!everywhere && !work.ranks() && only_unknowns_matter(work, answer)) {
    result.product = large_vector<double>(answer.p.size(), work.team());
    raise_if_failed(op.apply(answer.p.data(), result.product.data()), "the certificate's product");
    take_units(answer, work, result.product);
    result.pressures = answer.take_pressures(work.team());
    return result;
  }
  on_all(work.ranks(), [&] { result.product = large_vector<double>(static_cast<std::size_t>(work.own_points()), work.team()); });
  op.field(answer.p, result.product);
  take_units(answer, work, result.product);
  result.pressures.on.n = work.own_points();
  Pressures own = answer.take_pressures(work.team());
  if (own.on.index.empty()) {
    result.pressures.p = std::move(own.p);
  } else {
    result.pressures.p = large_vector<double>(result.product.size(), work.team());
    own.write(result.pressures.p.data(), work.own_points(), work.team());
  }
  return result;
}

double fitting_compression(const Workspace& work, const Deflected& answer) {
  struct Part {
    double sum = 0, moment = 0, least = -infinite;
    Part operator+(const Part& b) const { return {sum + b.sum, moment + b.moment, std::max(least, b.least)}; }
  };
  const auto add = [&](Part& part, std::size_t k) {
    const double p = answer.p()[k];
    if (p == 0) return;
    const double fits = answer.product[k] + work.surface.height(answer.point(k));
    if (p >= work.system.hardness) {
      part.least = std::max(part.least, fits);
      return;
    }
    part.sum += p;
    part.moment += p * fits;
  };
  const auto [sum, moment, least] = work.surface.sum_over<Part>(
      answer.size(), [](std::size_t k) { return k; }, add);
  return sum > 0 ? moment / sum : least > -infinite ? least : 0;
}

namespace {

Overlap overlap_of(const Workspace& work, const Deflected& found, double compression) {
  Overlap result;
  if (!work.system.capped()) return result;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::size_t i = found.point(k);
    if (!(found.p()[k] >= work.system.hardness) || !work.surface.included(i)) continue;
    const double depth = compression - work.surface.height(i) - found.product[k];
    if (!(depth > 0)) continue;
    result.point.push_back(static_cast<std::int64_t>(i));
    result.depth.push_back(depth);
  }
  return result;
}

}  // namespace

Finished certified_result(Workspace& work, const rc_step& step, Answer&& answer, const Monitor& monitor, rc_result& result) {
  Stiffness rate = wanted_stiffness(work, answer);
  Deflected found = deflected(work, answer, gap_of(result).wanted());
  // After a stop the approach is made to fit the pressures, but not where points were screened: that holds for one approach.
  const bool by_load = step.control == RC_CONTROL_LOAD, stopped = by_load && answer.status != RC_OK && !answer.checked;
  const double without = by_load ? 0 : compression_of(step, work);
  const double depth = !answer.op ? without : stopped ? fitting_compression(work, found) : answer.compression;
  Overlap overlap = overlap_of(work, found, depth);
  finish(work, step, answer, found, depth, std::move(rate), monitor, result);
  return {result.status, std::move(found.pressures), std::move(overlap), std::move(answer.history.own)};
}

Finished certify_given(Workspace& work, const rc_step& step, const Monitor& monitor, rc_result& result,
                       std::optional<double> compression) {
  const System& system = work.system;
  std::vector<double> p;
  TrialSet trial;
  Deflected given;
  std::vector<double>& product = given.product;
  on_all(work.ranks(), [&] {
    p.resize(static_cast<std::size_t>(work.own_points()));
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = given_pressure(result, i);
    for (std::size_t i = 0; i < p.size(); ++i)
      if (p[i] != 0) trial.index.push_back(static_cast<std::int64_t>(i));
    trial.n = static_cast<std::int64_t>(trial.index.size());
    given.pressures.on.n = work.own_points();
    product.assign(p.size(), 0.0);
  });
  const bool loaded = work.ranks() ? work.ranks()->any(trial.n > 0) : trial.n > 0;
  if (trial.n == work.own_points() || work.ranks()) trial = {work.own_points(), {}};
  Answer answer;
  if (loaded) {
    answer = prepared(trial, RC_CONTROL_APPROACH, 1, work);
    const std::string& certifier = work.options.text(RC_OPT_CERTIFY_BACKEND);
    if (!certifier.empty()) answer.choice.backend = &certifying_backend(certifier, work.options, system);
    answer.op = &work.bound_operator(*answer.choice.backend, trial);
    for (std::int64_t i = 0; i < trial.n; ++i) answer.p.push_back(p[static_cast<std::size_t>(trial.point(i))]);
    answer.op->field(answer.p, product);
    for (double& value : product) value *= system.length_per_pressure;
  }
  given.pressures.p = std::move(p);
  const double depth = step.control != RC_CONTROL_LOAD ? compression_of(step, work)
                       : compression                   ? *compression
                                                       : fitting_compression(work, given);
  finish(work, step, answer, given, depth, std::nullopt, monitor, result);
  copy_text(result.solver, "none");
  return {.status = result.status, .overlap = overlap_of(work, given, depth)};
}

}  // namespace rc
