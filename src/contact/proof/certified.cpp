#include "contact/proof/certified.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/operators.h"
#include "contact/proof/plausibility.h"
#include "contact/proof/survey.h"
#include "contact/slopes/punch_stiffness.h"
#include "contact/spectrum.h"
#include "contact/surface/points_below.h"
#include "core/certificate_terms.h"
#include "core/error.h"
#include "core/large_memory.h"
#include "core/limits.h"

namespace rc {

namespace {

std::string explain(const Numbers& numbers, const Remarks& remarks) {
  std::string whole;
  for (const std::string& remark : remarks.all()) whole += "; " + remark;
  const Certificate& found = numbers.certificate;
  return join(rc_status_text(numbers.status), ": kkt_primal ", found.primal, ", kkt_dual ", found.dual, ", kkt_complementarity ",
              found.complementarity, ", kkt_control ", found.control, ", tol ", numbers.tolerance, ", after ",
              numbers.work.iterations, " iterations", whole);
}

std::string note_of(const GridProblem& problem, const Numbers& numbers, double compression, bool isolated, const Rim& rim,
                    const Remarks& remarks) {
  const System& system = problem.system;
  std::vector<std::string> all;
  std::string edges;
  if (system.halfspace() && numbers.totals.contacts > 0) {
    std::optional<double>& tilt = problem.facts.tilt;
    if (!tilt) tilt = plane_share(problem.surface, system.given.nx, system.given.ny, system.periodic());
    const double mean_pressure = numbers.totals.sum / static_cast<double>(system.points());
    all = doubts(system, mean_pressure, numbers.totals.contacts, compression, *tilt);
    edges = edge_effects(numbers.stiffness.value / numbers.punch_stiffness, rim, *tilt);
  }
  if (std::isinf(numbers.bounds.load_upper)) all.emplace_back("no upper bound of the load is proven");
  all.insert(all.end(), remarks.all().begin(), remarks.all().end());
  if (isolated) all.emplace_back("a point without neighbours in contact has the largest pressure: check the map for a spike");
  if (!edges.empty()) all.push_back(edges);
  return note_from(all, sizeof rc_result::note - 1);
}

// Asked before each product of a solve for the stiffness. A time limit does not end that solve.
rc_status cancelled(const GridProblem& problem, const Attempt& attempt) {
  return problem.company().stop().value_or(attempt.monitor.cancelled() ? RC_STOP_CANCELLED : RC_OK);
}

Stiffness wanted_stiffness(const GridProblem& problem, const Answer& answer, const Attempt& attempt) {
  if (problem.options.integer(RC_OPT_STIFFNESS) == 0) return {};
  std::optional<Operator::Watch> watch;
  if (answer.op) watch.emplace(*answer.op, [&] { return cancelled(problem, attempt); });
  return stiffness(problem, answer);
}

// The operator whose products certify, for the trial set of the one that solved.
Operator& certifying(const GridProblem& problem, Operator& solving) {
  const std::string& name = problem.options.text(RC_OPT_CERTIFY_BACKEND);
  if (name.empty()) return solving;
  return problem.operators().bound(certifying_backend(name, problem.options, problem.system), solving.trial());
}

TrialSet all_if_kept(TrialSet trial, const GridProblem& problem) {
  if (problem.rows().shared() || trial.n == problem.own_points()) return {problem.own_points(), {}};
  return trial;
}

// For the interval of the stiffness; null if it is proven that nothing touches.
Operator* proving(const GridProblem& problem, const Answer& answer, const std::vector<std::int64_t>& possible,
                  const Attempt& attempt) {
  if (answer.op) return &certifying(problem, *answer.op);
  TrialSet trial{static_cast<std::int64_t>(possible.size()), possible};
  if (problem.surface.points().rows().united(trial.n) == 0) return nullptr;
  trial = all_if_kept(std::move(trial), problem);
  const Choice choice = choose_for(problem, trial, RC_CONTROL_APPROACH, attempt.failed, false);
  return &certifying(problem, problem.operators().bound(*choice.backend, trial));
}

// If no entry of H and no pressure is negative, points whose gap is at least the approach cannot overlap.
bool only_unknowns_matter(const GridProblem& problem, const Answer& answer) {
  return answer.op && problem.system.positive && answer.status == RC_OK && answer.compression <= answer.limit &&
         std::all_of(answer.p.begin(), answer.p.end(), [](double p) { return p >= 0; });
}

// The remarks name components that "auto" skipped, the solver's own remarks, operations that the core replaced, and promises that
// the kernel does not make.
Remarks remarks_on(const GridProblem& problem, const Answer& answer, const Attempt& attempt) {
  Remarks remarks = attempt.skipped;
  remarks.add(answer.remarks);
  const std::uint64_t needs = answer.choice.solver ? answer.choice.solver->needs : 0;
  const auto replaced = [&](std::uint64_t operation, const char* systems) {
    if (answer.op && !(answer.op->capabilities() & operation))
      remarks.add(join(systems, " by conjugate gradients: backend \"", answer.op->name(), "\" cannot factor"));
  };
  if (answer.handed_over) remarks.add("load control of the solver stalled: iteration on the approach instead");
  if (answer.handed_over || (needs & RC_CAP_SUBSET)) replaced(RC_CAP_SUBSET, "systems on subsets");
  if (needs & RC_CAP_SHIFTED) replaced(RC_CAP_SHIFTED, "shifted systems");
  const System& system = problem.system;
  if (system.halfspace() && !system.kernel.influence->half_space() &&
      (system.periodic() ? system.bounds.lambda_wave : system.bounds.lambda_min) == 0 &&
      problem.options.integer(RC_OPT_BOUNDS) != 0 && problem.goal.error == 0)
    remarks.add(join("bounds: kernel \"", system.kernel.name, "\" promises no lowest eigenvalue"));
  return remarks;
}

// A caller's matrix or product must be positive definite: p'Hp > 0 for the pressures found.
void check_definite(const System& system, const Deflected& answer, const Survey& found, const Totals& totals) {
  if (system.halfspace() || !(totals.largest_p > 0)) return;
  double curved = 0;  // scaled, so that the products do not underflow
  if (totals.largest_product > 0)
    for (const std::size_t k : found.touching)
      curved += answer.p()[k] / totals.largest_p * (answer.product[k] / totals.largest_product);
  if (curved <= 0)
    fail(RC_ERR_NUMERIC, system.given.op == RC_OPERATOR_DENSE ? "the dense matrix" : "the caller's apply function",
         " is not positive definite: p'Hp = ", curved * totals.largest_p * totals.largest_product,
         " for the pressures p found, must be > 0");
}

Totals totals_of(const GridProblem& problem, const Deflected& answer, const Survey& found, const RimPoints& rim,
                 double compression) {
  const System& system = problem.system;
  const StepSurface& surface = problem.surface;
  const std::span<const double> p = answer.p();
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
  return surface.points().sum_over<Totals>(std::span<const std::size_t>(found.touching), add);
}

// All numbers, and the message. rate: the stiffness of the answer, which may have given its pressures away.
Numbers certified(const GridProblem& problem, const Target& target, const Answer& answer, const Deflected& found, double depth,
                  Stiffness rate, const Attempt& attempt) {
  std::optional<ProvenSets> proven;
  Numbers numbers = certified_numbers(problem, target, answer, found, depth, rate.value, attempt, &proven);
  if (proven) {
    Operator* const op = proving(problem, answer, proven->possible, attempt);
    std::optional<Operator::Watch> watch;
    if (op) watch.emplace(*op, [&] { return cancelled(problem, attempt); });
    prove_interval(problem, op, proven->contacts, proven->possible, rate);
  }
  numbers.stiffness = rate;
  if (numbers.status != RC_OK && answer.status != RC_OK) numbers.status = answer.status;
  const bool left_out = problem.options.integer(RC_OPT_STIFFNESS) != 0 && cancelled(problem, attempt) == RC_STOP_CANCELLED;
  if (numbers.status == RC_OK && left_out) numbers.status = RC_STOP_CANCELLED;  // its stiffness
  numbers.work = work_of(problem, attempt.monitor);
  if (numbers.status != RC_OK) set_message(explain(numbers, remarks_on(problem, answer, attempt)).c_str());
  return numbers;
}

}  // namespace

double mean_gap(const GridProblem& problem, const Survey& everywhere, double overlap) {
  return (everywhere.sum_of_gaps + overlap) / static_cast<double>(problem.surface.range().included);
}

Numbers certified_numbers(const GridProblem& problem, const Target& target, const Answer& by, const Deflected& answer,
                          double compression, double stiffness, const Attempt& attempt, std::optional<ProvenSets>* proven) {
  const System& system = problem.system;
  const StepSurface& surface = problem.surface;
  const RimPoints rim(system.given, surface.points().rows().first());
  const Survey found = survey(surface, compression, answer);
  Numbers result;
  const Totals& totals = result.totals = totals_of(problem, answer, found, rim, compression);
  check_definite(system, answer, found, totals);
  // With an accuracy goal there are too few digits for proofs.
  if (problem.options.integer(RC_OPT_BOUNDS) != 0 && problem.goal.error == 0) {
    std::shared_ptr<const Spectrum>& spectrum = problem.facts.spectrum;
    if (!spectrum) spectrum = std::make_shared<const Spectrum>(spectrum_of(system));
    ProvenSets sets;
    const bool asked = proven && problem.options.integer(RC_OPT_STIFFNESS) == 2;
    result.bounds = prove_bounds(system, *spectrum, surface, compression, answer, found, asked ? &sets : nullptr);
    if (asked && result.bounds.undecided >= 0 && sets.listed) *proven = std::move(sets);
  }
  const double scale = residual_scale(problem, target, compression);
  result.certificate = certify(surface, compression, answer, found, scale, system.hardness);
  if (target.by_load()) result.certificate.control = load_imbalance(result.load(system), target.value);
  if (std::isnan(result.certificate.dual) || !std::isfinite(result.load(system)) ||
      !std::isfinite(totals.energy * system.cell_area()))
    fail(RC_ERR_NUMERIC,
         "the answer is not finite: the operator returned values that are not finite, or the units are such that ",
         "pressures, load or energy exceed double precision");

  if (by.choice.solver) copy_text(result.solver, by.choice.solver->name);
  if (by.choice.backend) copy_text(result.backend, by.choice.backend->name);
  result.modelled = by.op ? by.op->modelled() : 0;
  const bool by_load = target.by_load();
  const double limit = by_load ? surface.range().limit_of(compression) : target.value;
  result.candidates = system.positive ? extent_below(limit, surface).n : surface.range().included;
  const double reached = !by_load ? target.value : surface.range().included > 0 ? surface.lowest() + compression : 0;
  result.approach = reached + 0.0;  // never -0
  if (static_cast<std::int64_t>(answer.size()) == problem.own_points())
    result.mean_gap = mean_gap(problem, found, totals.overlap);
  result.tolerance = problem.options.real(RC_OPT_TOL);
  const double estimate = problem.goal.error > 0 ? 0 : nan;
  result.accuracy = {system.given.nx, system.given.ny, estimate, estimate, 0};
  result.stiffness.value = stiffness;
  if (!std::isnan(stiffness)) {
    if (!problem.facts.punch) problem.facts.punch = punch_stiffness(system);
    result.punch_stiffness = *problem.facts.punch;
  }
  const bool largest_there = totals.largest_on_rim > 0 && totals.largest_on_rim == totals.largest_p;
  const Rim on_rim{rim.share(), totals.sum > 0 ? totals.on_rim / totals.sum : 0, largest_there};
  const bool isolated =
      system.halfspace() && totals.contacts > 1 && totals.capped <= 1 && isolated_peak(system, surface, answer, found.touching);
  copy_text(result.note, note_of(problem, result, compression, isolated, on_rim, remarks_on(problem, by, attempt)).c_str());
  result.status = result.certificate.within(result.tolerance) ? RC_OK : RC_UNCERTIFIED;
  return result;
}

Work work_of(const GridProblem& problem, const Monitor& monitor) {
  const Spent spent = problem.operators().spent();
  const double setup_seconds = spent.setup_seconds - monitor.before().setup_seconds;
  return {monitor.iterations(), spent.products - monitor.before().products, 0, std::max(0.0, monitor.seconds() - setup_seconds),
          setup_seconds};
}

void write_arrays(const GridProblem& problem, const Deflected& answer, double compression, const Outputs& outputs) {
  answer.pressures.write(outputs.p, problem.own_points(), problem.team());
  if (!outputs.gap.wanted()) return;
  each_chunk(static_cast<std::int64_t>(answer.size()), problem.team(), [&](std::int64_t begin, std::int64_t count) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(begin + count); ++i)
      outputs.gap.put(i, problem.compliance * (answer.product[i] - (compression - problem.surface.height(i))));
  });
}

namespace {

// From the dimensionless product to lengths.
void take_units(const Answer& answer, const GridProblem& problem, std::vector<double>& product) {
  each_chunk(static_cast<std::int64_t>(product.size()), problem.team(), [&](std::int64_t begin, std::int64_t count) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(begin + count); ++i)
      product[i] = product[i] * answer.units.length - answer.datum_shift;
  });
}

}  // namespace

Deflected deflected(const GridProblem& problem, Answer& answer, bool everywhere) {
  const std::int64_t points = problem.own_points();
  const rc_team& team = problem.team();
  const Rows& rows = problem.rows();
  if (answer.checked && (!everywhere || answer.checked->on().n == points)) return std::move(*answer.checked);
  Deflected result;
  if (!answer.op) {
    result.pressures.on.n = points;
    rows.on_all([&] {
      result.pressures.p.assign(static_cast<std::size_t>(points), 0.0);
      result.product.assign(result.size(), 0.0);
    });
    return result;
  }
  Operator& op = certifying(problem, *answer.op);
  if (!everywhere && !rows.shared() && only_unknowns_matter(problem, answer)) {
    result.product = large_vector<double>(answer.p.size(), team);
    op.check(op.apply(answer.p.data(), result.product.data()), "the certificate's product");
    take_units(answer, problem, result.product);
    result.pressures = answer.take_pressures(team);
    return result;
  }
  rows.on_all([&] { result.product = large_vector<double>(static_cast<std::size_t>(points), team); });
  op.field(answer.p, result.product);
  take_units(answer, problem, result.product);
  result.pressures.on.n = points;
  Pressures own = answer.take_pressures(team);
  if (own.on.index.empty()) {
    result.pressures.p = std::move(own.p);
  } else {
    result.pressures.p = large_vector<double>(result.product.size(), team);
    own.write(result.pressures.p.data(), points, team);
  }
  return result;
}

double fitting_compression(const GridProblem& problem, const Deflected& answer) {
  struct Part {
    double sum = 0, moment = 0, least = -infinite;
    Part operator+(const Part& b) const { return {sum + b.sum, moment + b.moment, std::max(least, b.least)}; }
  };
  const auto add = [&](Part& part, std::size_t k) {
    const double p = answer.p()[k];
    if (p == 0) return;
    const double fits = answer.product[k] + problem.surface.height(answer.point(k));
    if (p >= problem.system.hardness) {
      part.least = std::max(part.least, fits);
      return;
    }
    part.sum += p;
    part.moment += p * fits;
  };
  const auto [sum, moment, least] = problem.surface.points().sum_over<Part>(
      answer.size(), [](std::size_t k) { return k; }, add);
  return sum > 0 ? moment / sum : least > -infinite ? least : 0;
}

namespace {

Overlap overlap_of(const GridProblem& problem, const Deflected& found, double compression) {
  Overlap result;
  if (!problem.system.capped()) return result;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::size_t i = found.point(k);
    if (!(found.p()[k] >= problem.system.hardness) || !problem.surface.included(i)) continue;
    const double depth = plastic_depth(found.product[k], compression, problem.surface.height(i));
    if (!(depth > 0)) continue;
    result.point.push_back(static_cast<std::int64_t>(i));
    result.depth.push_back(problem.compliance * depth);
  }
  return result;
}

}  // namespace

StepResult certify_and_write(const GridProblem& problem, const Target& target, Answer&& answer, const Attempt& attempt,
                             const Outputs& outputs) {
  Stiffness rate = wanted_stiffness(problem, answer, attempt);
  Deflected found = deflected(problem, answer, outputs.gap.wanted() || problem.keeps_deflection());
  // After a stop the approach is made to fit the pressures, but not if points were screened: that holds for one approach.
  const bool by_load = target.by_load(), stopped = by_load && answer.status != RC_OK && !answer.checked;
  const double without = by_load ? 0 : target.compression(problem.surface);
  const double depth = !answer.op ? without : stopped ? fitting_compression(problem, found) : answer.compression;
  Overlap overlap = overlap_of(problem, found, depth);
  Numbers numbers = certified(problem, target, answer, found, depth, std::move(rate), attempt);
  write_arrays(problem, found, depth, outputs);
  std::vector<double> left = problem.keeps_deflection() ? std::move(found.product) : std::vector<double>();
  return {numbers, std::move(found.pressures), std::move(overlap), std::move(left), std::move(answer.history.own), answer.choice};
}

Deflected deflection(const GridProblem& problem, const TrialSet& trial, std::vector<double> p, Answer& by,
                     const Attempt& attempt) {
  by = answer_in(1, choose_for(problem, trial, RC_CONTROL_APPROACH, attempt.failed, false), problem.system);
  const std::string& certifier = problem.options.text(RC_OPT_CERTIFY_BACKEND);
  if (!certifier.empty()) by.choice.backend = &certifying_backend(certifier, problem.options, problem.system);
  by.op = &problem.operators().bound(*by.choice.backend, trial);
  for (std::int64_t i = 0; i < trial.n; ++i) by.p.push_back(p[static_cast<std::size_t>(trial.point(i))]);
  Deflected result{{{problem.own_points(), {}}, std::move(p)}, {}};
  problem.rows().on_all([&] { result.product.resize(result.size()); });
  by.op->field(by.p, result.product);
  for (double& value : result.product) value *= problem.system.length_per_pressure;
  return result;
}

StepResult certify_given(const GridProblem& problem, const Target& target, const Attempt& attempt, const Outputs& outputs,
                         std::optional<double> compression) {
  const Rows& rows = problem.rows();
  TrialSet trial;
  Deflected given{{{problem.own_points(), {}}, {}}, {}};
  std::vector<double>& p = given.pressures.p;
  rows.on_all([&] {
    p.resize(static_cast<std::size_t>(problem.own_points()));
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = outputs.p.at(i);
    for (std::size_t i = 0; i < p.size(); ++i)
      if (p[i] != 0) trial.index.push_back(static_cast<std::int64_t>(i));
    trial.n = static_cast<std::int64_t>(trial.index.size());
    given.product.assign(p.size(), 0.0);
  });
  Answer answer;
  if (rows.any(trial.n > 0)) given = deflection(problem, all_if_kept(std::move(trial), problem), std::move(p), answer, attempt);
  const double depth = !target.by_load() ? target.compression(problem.surface)
                       : compression     ? *compression
                                         : fitting_compression(problem, given);
  Numbers numbers = certified(problem, target, answer, given, depth, wanted_stiffness(problem, answer, attempt), attempt);
  write_arrays(problem, given, depth, outputs);
  copy_text(numbers.solver, "none");
  return {.numbers = numbers, .overlap = overlap_of(problem, given, depth)};
}

}  // namespace rc
