#include "contact/step/auto_choice.h"

#include <unistd.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <tuple>

#include "core/error.h"

namespace rc {

namespace {

// [s] A step that takes less has no use for plugins: opening them takes longer.
constexpr double worth_opening = 7.5e-5;
constexpr double usual_products = 100;  // of a solver that does not say what it costs

constexpr std::int64_t least_dilute_points = 512 * 512;
constexpr double few_share = 0.05;  // of the grid's points: products that cost by the contact are cheaper below

const char* kind_of(const System& system) {
  if (system.given.op == RC_OPERATOR_DENSE) return "the caller's dense matrix";
  if (system.given.op == RC_OPERATOR_CALLBACK) return "the caller's product";
  return system.periodic() ? "periodic boundaries" : "free boundaries";
}

bool fits(const rc_backend& backend, const System& system) {
  return (backend.caps & system.needed_caps()) == system.needed_caps();
}
bool factors(const rc_backend& backend) { return (backend.caps & RC_CAP_SUBSET) != 0; }

std::string describe(const std::vector<std::string>& reasons) {
  std::string text;
  for (const std::string& reason : reasons) text += (text.empty() ? "" : "; ") + reason;
  return text;
}

bool contains(const std::vector<std::string>& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

double machine_bytes() {
  static const double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  return bytes > 0 ? bytes : std::numeric_limits<double>::infinity();
}

// A pair, or a backend that no solver can use.
struct Candidate {
  const rc_solver* solver = nullptr;
  const rc_backend* backend = nullptr;
  double seconds = 0, bytes = 0;
  bool scored = false;   // both say what they cost
  bool repeats = true;   // its bits do not depend on threads, or may
  std::string obstacle;  // why it cannot be chosen; "" if it can

  bool operator<(const Candidate& other) const { return rank() < other.rank(); }

 private:
  std::tuple<bool, bool, bool, double, std::string_view, std::string_view> rank() const {
    return {!obstacle.empty(), !scored, !repeats, seconds, solver ? solver->name : "", backend->name};
  }
};

using Backends = std::vector<const rc_backend*>;
using Solvers = std::vector<const rc_solver*>;

template <class Vtable> std::vector<const Vtable*> tables(const std::vector<const Component<Vtable>*>& components) {
  std::vector<const Vtable*> result;
  for (const auto* component : components) result.push_back(&component->vtable);
  return result;
}

class Comparison {
 public:
  // explain: obstacles come with their text, and what cannot be chosen is listed as well.
  Comparison(const rc_options& options, const System& system, const StepFacts& facts, const std::vector<std::string>& failed,
             bool any_solver, bool any_backend, bool explain)
      : options_(options),
        system_(system),
        facts_(facts),
        failed_(failed),
        any_solver_(any_solver),
        any_backend_(any_backend),
        explain_(explain),
        fallbacks_(options.integer(RC_OPT_ALLOW_FALLBACK) != 0),
        deterministic_(options.integer(RC_OPT_DETERMINISTIC) != 0) {}

  std::vector<Candidate> pairs(const Backends& backends, const Solvers& solvers) const {
    std::vector<Candidate> list;
    for (const rc_backend* backend : backends) add(*backend, solvers, list);
    std::sort(list.begin(), list.end());
    return list;
  }

  // Plugins are opened only where what is built in takes longer than that or cannot do it, and all of them only where nothing
  // else can.
  std::vector<Candidate> pairs(const Backends& named, const rc_solver* solver) const {
    Context& context = *options_.context;
    std::vector<Candidate> list;
    for (const std::int64_t points : {std::int64_t{0}, system_.points()}) {
      list = pairs(any_backend_ ? tables(context.backends_for_auto(points)) : named,
                   any_solver_ ? tables(context.solvers_for_auto(points)) : Solvers{solver});
      if (can(list) && (!any_backend_ || list.front().seconds <= worth_opening)) return list;
    }
    if (can(list) || !any_backend_) return list;
    return pairs(tables(context.backends()), any_solver_ ? tables(context.solvers_for_auto(system_.points())) : Solvers{solver});
  }

  static bool can(const std::vector<Candidate>& list) { return !list.empty() && list.front().obstacle.empty(); }

 private:
  template <class... Parts>
  void leave(std::vector<Candidate>& list, const rc_solver* solver, const rc_backend& backend, const Parts&... why) const {
    if (explain_) list.push_back({.solver = solver, .backend = &backend, .obstacle = join(why...)});
  }

  // Whether the component says what it costs; one that refuses has set the message.
  template <class Vtable> static bool says(const Vtable& component, const rc_facts& facts, rc_estimate& estimate, bool& refuses) {
    refuses = false;
    if (!component.score) return false;
    estimate.struct_size = sizeof estimate;
    const rc_status status = component.score(&facts, &estimate);
    refuses = status != RC_OK;
    return !refuses;
  }

  // What a backend costs that does not say so: products entry by entry.
  rc_estimate entry_by_entry() const {
    constexpr double entry = 1e-9;
    const auto n = static_cast<double>(facts_.candidates), points = static_cast<double>(system_.points());
    return {.struct_size = sizeof(rc_estimate),
            .product = entry * n * n,
            .field = entry * n * points,
            .factor = entry * n * n * n / 81};
  }

  void add(const rc_backend& backend, const Solvers& solvers, std::vector<Candidate>& list) const {
    if (!fits(backend, system_))
      return leave(list, nullptr, backend, "backend \"", backend.name, "\" cannot do ", kind_of(system_));
    if (facts_.few && (backend.caps & RC_CAP_SCREEN) == 0) return leave(list, nullptr, backend, "does not screen other points");
    if (contains(failed_, backend.name)) return leave(list, nullptr, backend, "has failed");
    rc_facts facts{.struct_size = sizeof facts,
                   .host = &options_.context->host(),
                   .options = &options_,
                   .system = &system_.unit,
                   .n = facts_.candidates,
                   .box = facts_.box,
                   .tol = facts_.tol,
                   .partial = facts_.partial};
    rc_estimate cost{};
    bool refuses = false;
    const bool scored = says(backend, facts, cost, refuses);
    if (refuses && any_backend_) return leave(list, nullptr, backend, last_message());
    if (!scored) cost = entry_by_entry();
    facts.backend = &cost;
    facts.caps = backend.caps;
    for (const rc_solver* solver : solvers) add(*solver, backend, facts, scored, list);
  }

  void add(const rc_solver& solver, const rc_backend& backend, const rc_facts& facts, bool scored,
           std::vector<Candidate>& list) const {
    if (contains(failed_, solver.name)) return leave(list, &solver, backend, "has failed");
    if (const std::string why = obstacle(solver, backend, system_, facts_.control, fallbacks_); !why.empty())
      return leave(list, &solver, backend, why);
    rc_estimate whole{};
    bool refuses = false;
    const bool known = says(solver, facts, whole, refuses);
    if (refuses && any_solver_) return leave(list, &solver, backend, last_message());
    if (!known) whole.seconds = facts.backend->seconds + usual_products * facts.backend->product + facts.backend->field;
    whole.bytes += facts.backend->bytes;
    if (any_backend_ && whole.bytes > machine_bytes())
      return leave(list, &solver, backend, "needs ", whole.bytes, " bytes on ", backend.name, ", this machine has ",
                   machine_bytes());
    if (!(whole.seconds >= 0)) return leave(list, &solver, backend, "its estimate on ", backend.name, " is not a time");
    const bool repeats = (backend.caps & RC_CAP_THREAD_INVARIANT) != 0 || !deterministic_;
    list.push_back({&solver, &backend, whole.seconds, whole.bytes, scored && known, repeats, {}});
  }

  const rc_options& options_;
  const System& system_;
  const StepFacts& facts_;
  const std::vector<std::string>& failed_;
  const bool any_solver_, any_backend_, explain_, fallbacks_, deterministic_;
};

// All pairs in question, the best first. missing: what keeps a named backend from being looked at.
std::vector<Candidate> ranked(const rc_options& options, const System& system, const StepFacts& facts,
                              const std::vector<std::string>& failed, bool explain, std::optional<Error>* missing = nullptr) {
  const std::string &solver = options.text(RC_OPT_SOLVER), &backend = options.text(RC_OPT_BACKEND);
  const bool any_solver = solver == "auto", any_backend = backend == "auto";
  const rc_solver* const named = any_solver ? nullptr : &options.context->solver(solver);
  const Comparison comparison(options, system, facts, failed, any_solver, any_backend, explain);
  if (any_backend) return comparison.pairs({}, named);
  // The first of the named backends that can be used.
  std::vector<Candidate> all;
  for (const std::string& name : split(backend, ',')) {
    try {
      std::vector<Candidate> list = comparison.pairs({&options.context->backend(name)}, named);
      if (Comparison::can(list)) return list;
      all.insert(all.end(), list.begin(), list.end());
    } catch (const Error& error) {
      if (missing && !*missing) *missing = error;
    }
  }
  return all;
}

// Throws what is in the way of every pair.
[[noreturn]] void refuse(const rc_options& options, const System& system, const StepFacts& facts,
                         const std::vector<std::string>& failed) {
  const std::string &solver = options.text(RC_OPT_SOLVER), &backend = options.text(RC_OPT_BACKEND);
  std::optional<Error> missing;
  const std::vector<Candidate> all = ranked(options, system, facts, failed, true, &missing);
  if (backend != "auto") {
    if (missing && all.empty()) throw *missing;
    std::vector<std::string> reasons;
    for (const Candidate& each : all)
      if (std::find(reasons.begin(), reasons.end(), each.obstacle) == reasons.end()) reasons.push_back(each.obstacle);
    if (missing) reasons.push_back(missing->what());
    fail(RC_ERR_INCOMPATIBLE, describe(reasons));
  }
  const bool usable = std::any_of(all.begin(), all.end(), [](const Candidate& each) { return each.solver != nullptr; });
  if (usable && solver == "auto") fail(RC_ERR_NO_SOLVER, "every solver that suits ", kind_of(system), " has failed");
  fail(RC_ERR_NO_BACKEND, "no backend can do ", kind_of(system), solver != "auto" ? " with this solver" : "",
       "; is a plugin missing?");
}

// Two digits are enough of an estimate.
std::string cost_of(const Candidate& pair) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(2);
  out << pair.seconds << " s, " << pair.bytes / 1048576 << " MiB";
  return out.str();
}

// One line, without the end of it.
std::string line_of(const Candidate& pair, const Candidate& taken) {
  if (!pair.obstacle.empty()) return join(pair.solver ? pair.solver->name : pair.backend->name, ": ", pair.obstacle);
  const char* const why = &pair == &taken                  ? "taken"
                          : !pair.scored && taken.scored   ? "does not say what it costs"
                          : !pair.repeats && taken.repeats ? "its bits depend on threads, and deterministic is 1"
                          : pair.seconds > taken.seconds   ? "slower"
                                                           : "later by name";
  return join(pair.solver->name, " on ", pair.backend->name, ": ", cost_of(pair), ", ", why);
}

}  // namespace

std::string missing_operation(const rc_solver& solver, std::uint64_t capabilities, bool fallbacks) {
  const auto lacks = [&](std::uint64_t operation) { return !fallbacks && (solver.needs & operation & ~capabilities) != 0; };
  if (lacks(RC_CAP_SUBSET))
    return join("solver \"", solver.name,
                "\" needs systems on subsets, which the backend cannot factor, and allow_fallback is 0");
  if (lacks(RC_CAP_SHIFTED))
    return join("solver \"", solver.name, "\" needs shifted systems, which the backend cannot factor, and allow_fallback is 0");
  return {};
}

std::string obstacle(const rc_solver& solver, const rc_backend& backend, const System& system, std::int32_t control,
                     bool fallbacks) {
  if (!fits(backend, system)) return join("backend \"", backend.name, "\" cannot do ", kind_of(system));
  if ((solver.needs & RC_NEEDS_GRID) && !system.halfspace())
    return join("solver \"", solver.name, "\" needs a half-space grid, not ", kind_of(system));
  if (const std::string missing = missing_operation(solver, backend.caps, fallbacks); !missing.empty())
    return join("backend \"", backend.name, "\": ", missing);
  const bool replaced = !factors(backend);
  if (control == RC_CONTROL_LOAD && !(solver.controls & RC_CONTROL_LOAD) && replaced && !fallbacks)
    return join("load control of solver \"", solver.name, "\" needs systems on subsets, which backend \"", backend.name,
                "\" cannot factor, and allow_fallback is 0");
  return {};
}

Choice choose(const rc_options& options, const System& system, const StepFacts& facts, const std::vector<std::string>& failed) {
  const std::vector<Candidate> all = ranked(options, system, facts, failed, false);
  clear_message();
  if (!Comparison::can(all)) refuse(options, system, facts, failed);
  return {all.front().solver, all.front().backend, facts};
}

const rc_solver& solver_inside(const rc_options& options, const System& system, const StepFacts& facts,
                               const rc_backend& backend) {
  const std::vector<std::string> none;
  const Comparison comparison(options, system, facts, none, true, false, false);
  const std::vector<Candidate> all = comparison.pairs({&backend}, tables(options.context->solvers_for_auto(0)));
  clear_message();
  if (!Comparison::can(all)) fail(RC_ERR_NO_SOLVER, "no solver suits backend \"", backend.name, "\"");
  return *all.front().solver;
}

std::string explained(const rc_options& options, const System& system, const Choice& choice,
                      const std::vector<std::string>& failed) {
  const StepFacts& facts = choice.facts;
  std::vector<Candidate> all = ranked(options, system, facts, failed, true);
  clear_message();
  const auto taken = std::find_if(all.begin(), all.end(), [&](const Candidate& each) {
    return each.solver == choice.solver && each.backend == choice.backend;
  });
  std::string text = join(facts.candidates, " of ", system.points(), " points may carry pressure, in a box of ", facts.box,
                          ", tol = ", facts.tol, "\n");
  if (taken == all.end()) return text;
  std::rotate(all.begin(), taken, taken + 1);
  for (const Candidate& each : all) {
    const std::string line = line_of(each, all.front()) + "\n";
    if (text.find("\n" + line) == std::string::npos) text += line;
  }
  if (options.text(RC_OPT_BACKEND) == "auto" && all.front().seconds <= worth_opening)
    text += "plugins: left alone, since to open them takes longer\n";
  return text;
}

const rc_backend& certifying_backend(const std::string& name, const rc_options& options, const System& system) {
  const rc_backend& backend = options.context->backend(name);
  if (!fits(backend, system))
    fail(RC_ERR_INCOMPATIBLE, RC_OPT_CERTIFY_BACKEND, " = ", name, ": this backend cannot do ", kind_of(system),
         "; leave the option empty or name one that can");
  return backend;
}

bool few(std::int64_t contacts, std::int64_t points) {
  return contacts > 0 && static_cast<double>(contacts) <= few_share * static_cast<double>(points);
}

std::optional<Choice> choose_for_few(const rc_options& options, const System& system, std::int32_t control) {
  if (!system.halfspace() || system.periodic() || !system.positive || system.points() < least_dilute_points ||
      options.text(RC_OPT_SOLVER) != "auto" || options.text(RC_OPT_WARMUP) != "none" ||
      !options.text(RC_OPT_CERTIFY_BACKEND).empty() || options.text(RC_OPT_BACKEND).find(',') != std::string::npos)
    return std::nullopt;
  const StepFacts facts{.control = control,
                        .candidates = static_cast<std::int64_t>(few_share * static_cast<double>(system.points())),
                        .box = system.points(),
                        .tol = options.real(RC_OPT_TOL),
                        .few = true};
  const std::vector<Candidate> all = ranked(options, system, facts, {}, false);
  clear_message();
  if (!Comparison::can(all)) return std::nullopt;
  return Choice{all.front().solver, all.front().backend, facts};
}

}  // namespace rc
