#include "contact/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace rc {

Contact::Contact(const rc_system& system, const rc_options& options, const rc_team* team)
    : system_(checked_system(system, options.text(RC_OPT_KERNEL), true)), options_(options), team_(team) {
  adopt(options);
  if (!team_) {
    own_team_ = std::make_unique<Team>(options_.integer(RC_OPT_THREADS));
    team_ = own_team_.get();
  }
}

// What the grid is off by leaves no use for digits of the solver's.
void Contact::adopt(const rc_options& options) {
  check_names(options);
  rc_options copy = options;
  goal_ = goal_of(options);
  if (goal_.tol() > copy.real(RC_OPT_TOL)) copy.values.set(copy.context->option(RC_OPT_TOL), goal_.tol());
  options_ = std::move(copy);
}

// Names are checked before a step needs them, and a pair that is fully named must go together.
void Contact::check_names(const rc_options& options) const {
  if (const std::string& first = options.text(RC_OPT_WARMUP); first != "none") options.context->solver(first);
  const std::string& solver = options.text(RC_OPT_SOLVER);
  if (solver != "auto") options.context->solver(solver);
  if (const std::string& certifier = options.text(RC_OPT_CERTIFY_BACKEND); !certifier.empty())
    certifying_backend(certifier, options, system_);
  if (options.text(RC_OPT_BACKEND) != "auto") choose(options, system_, RC_CONTROL_DISPLACEMENT, {});
}

void Contact::set_options(const rc_options& options) {
  if (options.context != options_.context) fail(RC_ERR_OPTION, "these options belong to another context");
  for (const OptionSpec* spec : options_.context->options())
    if (spec->fixed && options.values.get(*spec) != options_.values.get(*spec))
      fail(RC_ERR_OPTION, "option \"", spec->key, "\" is fixed when the contact is created; make a new contact to change it");
  adopt(options);
}

void Contact::reset() {
  surface_.clear();
  last_ = before_ = {};
  levels_.clear();
  models_.clear();
  models_current_ = false;
  // A factor remembers the order in which points came, a transform the larger box before: an answer after a reset would differ
  // from a first one by round-off.
  std::erase_if(operators_, [](const auto& entry) { return !entry.second->forget(); });
}

void Contact::forget_operators() {
  std::erase_if(operators_, [](const auto& entry) { return !entry.second->forget(); });
  for (auto& [points, level] : levels_) {
    if (level.contact) level.contact->forget();
    level.current = false;
  }
  for (Model& model : models_) {
    model.contact->last_ = model.contact->before_ = {};
    model.contact->forget_operators();
  }
}

void Contact::forget() {
  forget_operators();
  surface_.clear();
  last_ = before_ = {};
  models_current_ = false;
}

// suffix: of the names of rc_state's members.
Contact::Last Contact::certified(const double* p, double displacement, double load, const SurfaceState& surface,
                                 const char* suffix) const {
  if (!p) return {};
  Last step{{}, displacement, load, true};
  for (const auto& [value, name] : {std::pair{displacement, "displacement"}, {load, "load"}})
    if (!std::isfinite(value)) fail(RC_ERR_ARGUMENT, "rc_state.", name, suffix, " = ", value, " is not finite");
  Pressures& pressures = step.pressures;
  for (std::int64_t i = 0; i < system_.points(); ++i) {
    if (!std::isfinite(p[i])) fail(RC_ERR_ARGUMENT, "rc_state.p", suffix, "[", i, "] = ", p[i], " is not finite");
    if (p[i] == 0) continue;
    if (!surface.included(static_cast<std::size_t>(i)))
      fail(RC_ERR_ARGUMENT, "rc_state.p", suffix, "[", i, "] = ", p[i], " but this point is excluded by the mask");
    pressures.on.index.push_back(i);
    pressures.p.push_back(p[i]);
  }
  if (pressures.empty()) {  // a step without contact is a step
    pressures.on.index = {0};
    pressures.p = {0};
  }
  pressures.on.n = static_cast<std::int64_t>(pressures.p.size());
  if (pressures.on.n == system_.points()) pressures.on.index.clear();
  return step;
}

void Contact::restore(const rc_state& state) {
  const auto n = static_cast<std::size_t>(system_.points());
  if (!state.gap) fail(RC_ERR_ARGUMENT, "rc_state.gap is null");
  if (!state.p && state.p_before) fail(RC_ERR_ARGUMENT, "rc_state.p is null but rc_state.p_before is not");
  SurfaceState surface({system_.given.nx, system_.given.ny, {state.gap, n}, {state.mask, state.mask ? n : 0}, false}, *team_);
  Last last = certified(state.p, state.displacement, state.load, surface, ""),
       before = certified(state.p_before, state.displacement_before, state.load_before, surface, "_before");
  forget();
  adopt(std::move(surface));
  last_ = std::move(last);
  before_ = std::move(before);
}

// The surface as this step describes it; nothing where it is that of the step before.
std::optional<SurfaceState> Contact::given_surface(const rc_step& step) const {
  const auto n = static_cast<std::size_t>(system_.points());
  if (!step.gap && surface_.empty()) fail(RC_ERR_ARGUMENT, "rc_step.gap is null and no earlier step gave one");
  if (!step.gap && !step.mask) return std::nullopt;
  GivenSurface given{system_.given.nx, system_.given.ny, surface_.gap(), {step.mask, step.mask ? n : 0}, false};
  if (step.gap) given.gap = {step.gap, n};
  given.borrowed = step.gap && step.borrow != 0;
  return SurfaceState(given, *team_);
}

void Contact::check_target(const rc_step& step, const SurfaceState& surface) const {
  if (step.control != RC_CONTROL_DISPLACEMENT && step.control != RC_CONTROL_LOAD)
    fail(RC_ERR_ARGUMENT, "rc_step.control = ", step.control, " is neither RC_CONTROL_DISPLACEMENT (1) nor RC_CONTROL_LOAD (2)");
  if (!std::isfinite(step.target)) fail(RC_ERR_ARGUMENT, "rc_step.target = ", step.target, " is not finite");
  if (step.control == RC_CONTROL_LOAD && step.target < 0)
    fail(RC_ERR_INFEASIBLE, "load = ", step.target,
         " is negative; a contact without adhesion cannot pull, the smallest load is 0");
  if (step.control == RC_CONTROL_LOAD && step.target > 0 && surface.included_points() == 0)
    fail(RC_ERR_INFEASIBLE, "load = ", step.target, " but every point is excluded by the mask");
  if (step.control == RC_CONTROL_DISPLACEMENT && system_.periodic() && surface.whole() && step.target > surface.lowest() &&
      step.target - surface.lowest() >= surface.mean_height())
    fail(RC_ERR_INFEASIBLE, "approach = ", step.target, " reaches the mean plane of the gap, ", surface.mean(),
         ": with periodic boundaries the load is not determined there; prescribe the load");
  if (surface.included_points() > 0 && !(std::isfinite(surface.highest() - surface.lowest()) &&
                                         (step.control == RC_CONTROL_LOAD || std::isfinite(step.target - surface.lowest()))))
    fail(RC_ERR_ARGUMENT, "the gap's range, ", surface.lowest(), " .. ", surface.highest(), ", and the target ", step.target,
         " are too far apart for double precision");
  if (step.p0)
    for (std::int64_t i = 0; i < system_.points(); ++i)
      if (!std::isfinite(step.p0[i])) fail(RC_ERR_ARGUMENT, "rc_step.p0[", i, "] = ", step.p0[i], " is not finite");
}

void Contact::begin(const rc_step& step) {
  // A step that is refused changes nothing.
  std::optional<SurfaceState> given = given_surface(step);
  check_target(step, given ? *given : surface_);
  if (given) adopt(std::move(*given));
  if (options_.integer(RC_OPT_RESUMABLE) != 0) forget_operators();
  warm_ = step.warm_start != 0;
  remarks_.clear();
  for (auto& [points, level] : levels_) level.current = false;
  setup_seconds_ = 0;
  applications_before_ = applications();
}

void Contact::adopt(SurfaceState&& given) {
  const bool same = !surface_.empty() && given.equals(surface_, *team_);
  last_.same_gap = last_.same_gap && same;
  before_.same_gap = before_.same_gap && same;
  models_current_ = models_current_ && same;
  if (!same) tilt_.reset();
  surface_ = std::move(given);
}

std::int64_t Contact::applications() const {
  std::int64_t total = 0;
  for (const auto& [name, op] : operators_) total += op->applications();
  return total;
}

double Contact::compression(const rc_step& step) const {
  return surface_.included_points() > 0 ? step.target - surface_.lowest() : 0;
}

bool Contact::nothing_touches(const rc_step& step) const {
  if (surface_.included_points() == 0) return true;
  return step.control == RC_CONTROL_LOAD ? step.target == 0 : step.target <= surface_.lowest();
}

rc_status Contact::solve(const rc_step& step, rc_result& result) {
  begin(step);
  const ClearCancellation clear{cancelled_};
  return solve_begun(step, result);
}

rc_status Contact::solve_begun(const rc_step& step, rc_result& result, std::optional<Estimate> nearer) {
  Monitor monitor(cancelled_, progress_, options_.real(RC_OPT_TIME_LIMIT), options_.integer(RC_OPT_MAX_ITER));
  if (nothing_touches(step)) return finish(step, {}, monitor, result);
  bool on_models = false;
  if (goal_.error > 0 && system_.halfspace()) {
    OnCoarserGrids found = on_coarser_grids(step, monitor, result.gap != nullptr);
    if (found.status == RC_WITHIN_GOAL && within_goal(step, found, monitor, result)) return RC_WITHIN_GOAL;
    if (found.status != RC_OK && found.grid > 0) return deliver_stopped(step, found, monitor, result);
    if (found.status != RC_OK) {
      Answer stopped;
      stopped.status = found.status;
      return finish(step, std::move(stopped), monitor, result);
    }
    on_models = true;
    if (!step.p0) nearer = std::move(found.estimate);
  }
  failed_.clear();
  std::optional<Error> first;  // what "auto" passed over a backend for
  bool delivered = false;      // an answer that is not certified: the caller's arrays hold it if nothing better follows
  for (;;) {
    choice_ = {};
    try {
      std::optional<Answer> few = at_few_points(step, monitor, nearer);
      Answer answer = few                               ? std::move(*few)
                      : step.control == RC_CONTROL_LOAD ? at_load(step, monitor, nearer)
                                                        : at_displacement(step, monitor, nearer);
      const rc_status status = finish(step, std::move(answer), monitor, result);
      if (on_models) {
        count_models(result);
        result.seconds = std::max(0.0, monitor.seconds() - result.setup_seconds);
      }
      const bool hopeless = status == RC_STOP_STALLED || status == RC_STOP_UNCERTIFIED;
      if (!hopeless || !pass_over(choice_.solver->name, RC_OPT_SOLVER, join("which ended with: ", rc_status_text(status))))
        return status;
      delivered = true;
      clear_message();
    } catch (const Error& error) {
      const bool lacking = error.code() == RC_ERR_MEMORY || error.code() == RC_ERR_PLUGIN || error.code() == RC_ERR_INCOMPATIBLE;
      if (lacking && choice_.backend && pass_over(choice_.backend->name, RC_OPT_BACKEND, error.what())) {
        operators_.erase(choice_.backend->name);
        if (!first) first = error;
        continue;
      }
      if (!delivered && first) fail(first->code(), first->what(), "; the next choice of auto failed, too: ", error.what());
      if (!delivered) throw;
      set_message(join(rc_status_text(result.status), "; the next choice of auto failed: ", error.what()).c_str());
      return result.status;
    }
  }
}

TrialSet Contact::trial_below(double limit) const { return system_.positive ? surface_.below(limit) : surface_.all(); }

Choice Contact::choose_for(const TrialSet& trial, std::int32_t control) {
  const Counts counts{trial.n, box_points(trial, system_.given.nx, system_.given.ny), system_.points(),
                      options_.real(RC_OPT_TOL)};
  choice_ = choose(options_, system_, control, counts, failed_);
  if (look_ > 0) choice_.solver = &options_.context->solver(suited(false, true));
  return choice_;
}

// Whether there is something else that "auto" may stand for.
bool Contact::pass_over(const char* name, const char* option, const std::string& reason) {
  if (options_.text(option) != "auto" || options_.integer(RC_OPT_ALLOW_FALLBACK) == 0) return false;
  failed_.emplace_back(name);
  try {
    choose(options_, system_, RC_CONTROL_DISPLACEMENT, {}, failed_);
  } catch (const Error&) {
    return false;
  }
  remarks_.push_back(join("auto: passed over ", name, ", ", reason));
  return true;
}

// A solver that takes every point of a box for an unknown needs no index, where products cost the same.
TrialSet Contact::widened(TrialSet trial, const Choice& choice) const {
  constexpr std::uint64_t by_points = RC_CAP_SUBSET | RC_CAP_SCREEN;  // backends whose products cost by the point
  if (!(choice.solver->needs & RC_WANTS_BOX) || (choice.backend->caps & by_points) || !surface_.whole()) return trial;
  const std::int64_t box = box_points(trial, system_.given.nx, system_.given.ny);
  return trial.n < box && 2 * trial.n >= box ? box_of(trial, system_.given.nx, system_.given.ny) : trial;
}

Operator& Contact::bound_operator(const rc_backend& backend, const TrialSet& trial) {
  const auto begun = Clock::now();
  auto it = operators_.find(backend.name);
  if (it == operators_.end()) {
    auto made = std::make_unique<Operator>(backend, options_.context->host(), system_.unit, system_.kernel, options_, *team_,
                                           system_.operator_scale);
    it = operators_.emplace(backend.name, std::move(made)).first;
  }
  it->second->bind(trial);
  setup_seconds_ += seconds_since(begun);
  return *it->second;
}

Answer Contact::prepare(const TrialSet& trial, std::int32_t control, double length_unit) {
  Answer answer;
  answer.choice = choose_for(trial, control);
  answer.length_unit = length_unit;
  answer.pressure_unit = length_unit / system_.length_per_pressure;
  return answer;
}

// A little less than is certified: the certificate's product rounds in its own way.
double Contact::solver_tol() const { return 0.98 * options_.real(RC_OPT_TOL); }

// Solvers ask for the same table at every step.
rc_status Contact::coefficients(std::int64_t mx, std::int64_t my, double* out) {
  constexpr std::int64_t most = 1 << 14;  // values that are kept
  if (mx != table_.mx || my != table_.my) {
    const rc_host& host = options_.context->host();
    const rc_status status = host.coefficients(&host, &system_.unit, system_.kernel.c_str(), mx, my, out);
    if (status == RC_OK && mx <= most / my) table_ = {mx, my, {out, out + mx * my}};
    return status;
  }
  std::copy(table_.values.begin(), table_.values.end(), out);
  return RC_OK;
}

rc_grid Contact::grid() const {
  return {sizeof(rc_grid),
          system_.given.nx,
          system_.given.ny,
          system_.given.hx,
          system_.given.hy,
          surface_.gap().data(),
          surface_.mask(),
          nullptr,
          0,
          system_.given.boundary,
          0};
}

SolverRun Contact::run(const Answer& answer, Monitor& monitor) {
  const bool grid_units = system_.halfspace();
  return {*answer.choice.solver,
          *options_.context,
          options_,
          *team_,
          *answer.op,
          monitor,
          options_.integer(RC_OPT_ALLOW_FALLBACK) != 0,
          system_.lambda_min,
          system_.positive,
          grid_units ? grid() : rc_grid{},
          grid_units ? answer.length_unit : 0,
          grid_units ? answer.pressure_unit : 0,
          [this, &monitor](rc_coarse& request) { return solve_coarse(request, monitor); },
          [this](std::int64_t mx, std::int64_t my, double* out) { return coefficients(mx, my, out); },
          [this](const std::string& text) {
            const std::string from = text.substr(0, text.find(':'));
            std::erase_if(remarks_, [&](const std::string& each) { return each.substr(0, each.find(':')) == from; });
            remarks_.push_back(text);
          },
          look_ > 0 ? look_ : std::numeric_limits<std::int64_t>::max(),
          look_ > 0};
}

// How far along the line through the last two steps the new one lies, beyond the last; 0 where there is no such line.
double Contact::ahead(const rc_step& step) const {
  if (step.p0 || !step.warm_start || !last_.same_gap || before_.pressures.empty() || !before_.same_gap) return 0;
  const bool by_load = step.control == RC_CONTROL_LOAD;
  const double newest = by_load ? last_.load : last_.approach, older = by_load ? before_.load : before_.approach;
  const double part = (step.target - newest) / (newest - older);
  // Pressures bend: a long way ahead, and back beyond the older step, the line leads astray.
  return part >= -1 && part <= 2 ? part : 0;
}

std::vector<double> Contact::start(const rc_step& step, const TrialSet& trial, double pressure_unit,
                                   const Pressures* nearer) const {
  std::vector<double> p;
  if (nearer) {
    p = nearer->at(trial);
  } else if (step.p0) {
    p.resize(static_cast<std::size_t>(trial.n));
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = step.p0[trial.point(static_cast<std::int64_t>(i))];
  } else if (step.warm_start && !last_.pressures.empty()) {
    p = last_.pressures.at(trial);
    if (const double part = ahead(step); part != 0) {
      const std::vector<double> older = before_.pressures.at(trial);
      for (std::size_t i = 0; i < p.size(); ++i) p[i] += part * (p[i] - older[i]);
    }
  } else {
    p.resize(static_cast<std::size_t>(trial.n));
    return p;
  }
  for (double& value : p) value = std::max(0.0, value / pressure_unit);
  return p;
}

// Dimensionless; none where the solver takes them from the gap.
std::vector<double> Contact::compenetrations(const Answer& answer, double datum) const {
  if (system_.halfspace() && takes_gap(*answer.choice.solver, options_)) return {};
  const TrialSet& trial = answer.op->trial();
  std::vector<double> u(static_cast<std::size_t>(trial.n));
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = (datum - surface_.gap()[static_cast<std::size_t>(trial.point(static_cast<std::int64_t>(i)))]) / answer.length_unit;
  return u;
}

Answer Contact::at_displacement(const rc_step& step, Monitor& monitor, const std::optional<Estimate>& nearer) {
  TrialSet trial = trial_below(step.target);
  const double depth = compression(step);
  Answer answer = prepare(trial, step.control, depth);
  trial = widened(std::move(trial), answer.choice);
  answer.op = &bound_operator(*answer.choice.backend, trial);
  answer.p = start(step, trial, answer.pressure_unit, nearer ? &nearer->pressures : nullptr);
  answer.compression = answer.limit = depth;
  const std::vector<double> u = compenetrations(answer, step.target);
  double unused = 0;
  answer.status = run(answer, monitor)(step.control, u, 0, solver_tol() * (residual_scale(step, depth) / depth), step.target,
                                       answer.p, unused);
  return answer;
}

Pressures Contact::pressures_of(const Answer& answer) const {
  Pressures result;
  result.on = answer.op->trial();
  result.p = answer.p;
  for (double& value : result.p) value *= answer.pressure_unit;
  return result;
}

}  // namespace rc
