#include "contact/choice.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <tuple>

#include "contact/operators.h"
#include "contact/problem.h"
#include "contact/trial_box.h"
#include "core/error.h"
#include "platform/memory.h"

namespace rc {

namespace {

// [s] A step that takes less has no use for plugins: opening them takes longer.
constexpr double worth_opening = 7.5e-5;
constexpr double usual_products = 100;  // of a solver that does not say what it costs

// The least points of a grid on which contact at few points is solved there alone. On smaller grids the estimate takes more time
// than it saves.
constexpr std::int64_t least_sparse_points = 512 * 512, least_sparse_of_period = 256 * 256;
// The choice for sparse contact is made before the unknowns are known: it assumes at most this many.
constexpr std::int64_t most_few = 1 << 24;
// Contact on at most this share of the grid's points counts as sparse: products that cost by the contact are then cheaper.
constexpr double sparse_share = 0.05;
// If processes share products by rows, each repeats the work on all unknowns, so that fewer points count as sparse.
constexpr double sparse_share_by_rows = 0.01;
constexpr std::int64_t most_few_by_rows = 1 << 17;

std::string in_full(double bytes) { return bytes < 9e18 ? join(static_cast<std::int64_t>(bytes)) : join(bytes); }

std::string kind_of(const System& system) {
  if (system.given.op == RC_OPERATOR_DENSE) return "the caller's dense matrix";
  if (system.given.op == RC_OPERATOR_CALLBACK) return "the caller's product";
  return join(system.boundary(), " boundaries");
}

// The property of this system that the backend does not support; "" if it supports the system.
std::string beyond(const rc_backend& backend, const System& system) {
  if ((backend.caps & system.needed_caps()) != system.needed_caps()) return kind_of(system);
  if ((backend.caps & RC_CAP_FAR_FIELD) && system.halfspace() && !system.kernel.influence->has(RC_KERNEL_FAR_FIELD))
    return join("kernel \"", system.kernel.name, "\", whose far field is not that of the half-space");
  return {};
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

// A pair, or a backend that no solver can use.
struct Candidate {
  const rc_solver* solver = nullptr;
  const rc_backend* backend = nullptr;
  double seconds = 0, bytes = 0;
  bool scored = false;     // solver and backend both estimate their cost
  bool repeats = true;     // its bits do not depend on threads
  std::string obstacle;    // why it cannot be chosen; "" if it can
  bool too_large = false;  // the obstacle: bytes is more than this machine has

  bool operator<(const Candidate& other) const { return order() < other.order(); }

 private:
  std::tuple<bool, bool, bool, double, std::string_view, std::string_view> order() const {
    return {!obstacle.empty(), !scored, !repeats, seconds, backend->name, solver ? solver->name : ""};
  }
};

using Backends = std::vector<const rc_backend*>;
using Solvers = std::vector<const rc_solver*>;

template <class Vtable> std::vector<const Vtable*> tables(const std::vector<const Component<Vtable>*>& components) {
  std::vector<const Vtable*> result;
  for (const auto* component : components) result.push_back(&component->vtable);
  return result;
}

bool can(const std::vector<Candidate>& list) { return !list.empty() && list.front().obstacle.empty(); }

struct Question {
  const rc_options& options;
  const System& system;
  const StepFacts& facts;
  const std::vector<std::string>& failed;
  const bool explain;           // obstacles come with their text, and what cannot be chosen is listed as well
  const bool optional = false;  // the step can be solved in another way
  // A trial of a few iterations (partial) may take any solver: another one can solve the problem after it.
  const rc_solver* const solver =
      options.text(RC_OPT_SOLVER) == "auto" || facts.partial ? nullptr : &options.context->solver(options.text(RC_OPT_SOLVER));
  const bool any_backend = options.text(RC_OPT_BACKEND) == "auto";
  const bool fallbacks = options.integer(RC_OPT_ALLOW_FALLBACK) != 0;
  const Host host{*options.context, system.kernel.influence.get()};

  // Every pair of these, the best first.
  std::vector<Candidate> pairs(const Backends& backends, const Solvers& solvers) const {
    std::vector<Candidate> list;
    for (const rc_backend* backend : backends) add(*backend, solvers, list);
    std::sort(list.begin(), list.end());
    return list;
  }

  // Candidates with this backend; null: with any. Plugins are opened only if built-in ones take longer than that or cannot do it,
  // and all of them only if nothing else can do what must be done.
  std::vector<Candidate> pairs(const rc_backend* backend) const {
    Context& context = *options.context;
    const auto solvers = [&](std::int64_t points) { return solver ? Solvers{solver} : tables(context.solvers_for_auto(points)); };
    std::vector<Candidate> list;
    for (const std::int64_t points : {std::int64_t{0}, system.points()}) {
      list = pairs(backend ? Backends{backend} : tables(context.backends_for_auto(points)), solvers(points));
      if (can(list) && (backend || static_cast<double>(facts.at_once) * list.front().seconds <= worth_opening)) return list;
    }
    return can(list) || backend || optional ? list : pairs(tables(context.backends()), solvers(system.points()));
  }

  // All that are in question, the best first. missing: why a named backend is not there.
  std::vector<Candidate> ranked(std::optional<Error>* missing = nullptr) const {
    if (any_backend) return pairs(nullptr);
    std::vector<Candidate> all;
    for (const std::string& name : split(options.text(RC_OPT_BACKEND), ',')) {
      try {
        std::vector<Candidate> list = pairs(&options.context->backend(name));
        if (can(list)) return list;
        all.insert(all.end(), list.begin(), list.end());
      } catch (const Error& error) {
        if (missing && !*missing) *missing = error;
      }
    }
    return all;
  }

 private:
  template <class... Parts>
  void leave(std::vector<Candidate>& list, const rc_solver* by, const rc_backend& backend, const Parts&... why) const {
    if (explain) list.push_back({.solver = by, .backend = &backend, .obstacle = join(why...)});
  }

  // Whether the component says what it costs; one that refuses has set the message.
  template <class Vtable> static bool says(const Vtable& component, const rc_facts& given, rc_estimate& estimate, bool& refuses) {
    estimate.struct_size = sizeof estimate;
    refuses = component.score && component.score(&given, &estimate) != RC_OK;
    return component.score && !refuses;
  }

  // The cost of a backend without an estimate: products entry by entry.
  rc_estimate entry_by_entry() const {
    constexpr double entry = 1e-9;  // [s]
    const auto n = static_cast<double>(facts.candidates), points = static_cast<double>(system.points());
    return {.product = entry * n * n, .field = entry * n * points, .factor = entry * n * n * n / 81};
  }

  void add(const rc_backend& backend, const Solvers& solvers, std::vector<Candidate>& list) const {
    if (const std::string what = beyond(backend, system); !what.empty())
      return leave(list, nullptr, backend, "backend \"", backend.name, "\" cannot do ", what);
    if (facts.few && (backend.caps & RC_CAP_SCREEN) == 0) return leave(list, nullptr, backend, "does not screen other points");
    if (facts.shared && (backend.caps & RC_CAP_ROWS) == 0)
      return leave(list, nullptr, backend, "backend \"", backend.name, "\" cannot work on rows that processes share");
    if (contains(failed, backend.name)) return leave(list, nullptr, backend, "has failed");
    rc_estimate cost{};
    rc_facts given{.struct_size = sizeof given,
                   .host = &host,
                   .options = &options,
                   .system = &system.unit,
                   .n = facts.candidates,
                   .box = facts.box,
                   .tol = facts.tol,
                   .at_once = facts.at_once,
                   .partial = facts.partial};
    bool refuses = false;
    const bool scored = says(backend, given, cost, refuses);
    if (refuses && any_backend) return leave(list, nullptr, backend, last_message());
    if (!scored) cost = entry_by_entry();
    given.backend = &cost;
    given.caps = backend.caps;
    for (const rc_solver* each : solvers) add(*each, backend, given, scored, list);
  }

  void add(const rc_solver& by, const rc_backend& backend, const rc_facts& given, bool scored,
           std::vector<Candidate>& list) const {
    if (facts.shared && (by.needs & RC_TAKES_ROWS) == 0)
      return leave(list, &by, backend, "solver \"", by.name, "\" cannot work on rows that processes share");
    if (contains(failed, by.name)) return leave(list, &by, backend, "has failed");
    if (const std::string why = obstacle(by, backend, system, facts.control, fallbacks); !why.empty())
      return leave(list, &by, backend, why);
    rc_estimate whole{};
    bool refuses = false;
    const bool known = says(by, given, whole, refuses);
    if (refuses && !solver) return leave(list, &by, backend, last_message());
    if (!known) whole.seconds = given.backend->seconds + usual_products * given.backend->product + given.backend->field;
    if (!by.solve_many) whole.seconds /= static_cast<double>(std::min(facts.at_once, facts.threads));
    whole.bytes += given.backend->bytes;
    if (any_backend && whole.bytes > rc_platform::machine_bytes()) {
      leave(list, &by, backend, "needs ", in_full(whole.bytes), " bytes on ", backend.name, ", this machine has ",
            in_full(rc_platform::machine_bytes()));
      if (explain) list.back().bytes = whole.bytes, list.back().too_large = true;
      return;
    }
    if (!(whole.seconds >= 0)) return leave(list, &by, backend, "its estimate on ", backend.name, " is not a time");
    list.push_back({.solver = &by,
                    .backend = &backend,
                    .seconds = whole.seconds,
                    .bytes = whole.bytes,
                    .scored = scored && known,
                    .repeats = (backend.caps & RC_CAP_THREAD_INVARIANT) != 0});
  }
};

// Ranks the candidates; messages of components in between are not failures.
std::vector<Candidate> answered(const Question& question, std::optional<Error>* missing = nullptr) {
  std::vector<Candidate> all = question.ranked(missing);
  clear_message();
  return all;
}

// Throws what is in the way of every pair.
[[noreturn]] void refuse(const Question& question) {
  std::optional<Error> missing;
  const std::vector<Candidate> all = answered(question, &missing);
  if (!question.any_backend) {
    if (missing && all.empty()) throw *missing;
    std::vector<std::string> reasons;
    for (const Candidate& each : all)
      if (!contains(reasons, each.obstacle.c_str())) reasons.push_back(each.obstacle);
    if (missing) reasons.push_back(missing->what());
    fail(RC_ERR_INCOMPATIBLE, describe(reasons));
  }
  const Candidate* least = nullptr;
  for (const Candidate& each : all)
    if (each.too_large && (!least || each.bytes < least->bytes)) least = &each;
  if (least) {
    const rc_system& system = question.system.given;
    fail(RC_ERR_MEMORY, kind_of(question.system), " and ", system.nx, " x ", system.ny, " points: ", least->solver->name, " ",
         least->obstacle, "; use a coarser grid or a smaller domain");
  }
  const bool usable = std::any_of(all.begin(), all.end(), [](const Candidate& each) { return each.solver != nullptr; });
  if (usable && !question.solver) fail(RC_ERR_NO_SOLVER, "every solver that suits ", kind_of(question.system), " has failed");
  fail(RC_ERR_NO_BACKEND, "no backend can do ", kind_of(question.system), question.solver ? " with this solver" : "",
       "; is a plugin missing?");
}

// Two digits are enough of an estimate.
std::string cost_of(const Candidate& pair) {
  return join(in_digits(pair.seconds, 2), " s, ", in_digits(pair.bytes / 1048576, 2), " MiB");
}

// One line, without the end of it.
std::string line_of(const Candidate& pair, const Candidate& taken) {
  if (!pair.obstacle.empty()) return join(pair.solver ? pair.solver->name : pair.backend->name, ": ", pair.obstacle);
  const char* const why = &pair == &taken                  ? "taken"
                          : !pair.scored && taken.scored   ? "does not say what it costs"
                          : !pair.repeats && taken.repeats ? "its bits depend on threads"
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

std::string missing_cap(const rc_solver& solver, const System& system) {
  if (!system.capped() || (solver.needs & RC_TAKES_CAP)) return {};
  return join("solver \"", solver.name, "\" knows no largest pressure, but the system has the hardness ", system.hardness);
}

std::string obstacle(const rc_solver& solver, const rc_backend& backend, const System& system, std::int32_t control,
                     bool fallbacks) {
  if (const std::string what = beyond(backend, system); !what.empty())
    return join("backend \"", backend.name, "\" cannot do ", what);
  if ((solver.needs & RC_NEEDS_GRID) && !system.halfspace())
    return join("solver \"", solver.name, "\" needs a half-space grid, not ", kind_of(system));
  if (std::string missing = missing_cap(solver, system); !missing.empty()) return missing;
  if (const std::string missing = missing_operation(solver, backend.caps, fallbacks); !missing.empty())
    return join("backend \"", backend.name, "\": ", missing);
  const bool replaced = !factors(backend);
  if (control == RC_CONTROL_LOAD && !(solver.controls & RC_CONTROL_LOAD) && replaced && !fallbacks)
    return join("load control of solver \"", solver.name, "\" needs systems on subsets, which backend \"", backend.name,
                "\" cannot factor, and allow_fallback is 0");
  return {};
}

Choice choose(const rc_options& options, const System& system, const StepFacts& facts, const std::vector<std::string>& failed) {
  const std::vector<Candidate> all = answered({options, system, facts, failed, false});
  if (!can(all)) refuse({options, system, facts, failed, true});
  return {all.front().solver, all.front().backend, facts};
}

Choice choose_for(const GridProblem& problem, const TrialSet& trial, std::int32_t control, const std::vector<std::string>& failed,
                  bool partial) {
  const rc_system& system = problem.system.given;
  const bool shared = problem.rows().shared();
  const StepFacts facts{.control = control,
                        .candidates = shared ? problem.system.points() : trial.n,
                        .box = shared ? problem.system.points() : box_points(trial, system.nx, system.ny),
                        .tol = problem.options.real(RC_OPT_TOL),
                        .partial = partial,
                        .shared = shared};
  return choose(problem.options, problem.system, facts, failed);
}

const rc_solver& solver_inside(const rc_options& options, const System& system, const StepFacts& facts,
                               const rc_backend& backend) {
  const std::vector<std::string> none;
  const Question question{options, system, facts, none, false, false, nullptr, false};
  const std::vector<Candidate> all = question.pairs({&backend}, tables(options.context->solvers_for_auto(0)));
  clear_message();
  if (!can(all)) fail(RC_ERR_NO_SOLVER, "no solver suits backend \"", backend.name, "\"");
  return *all.front().solver;
}

std::string explained(const rc_options& options, const System& system, const Choice& choice,
                      const std::vector<std::string>& failed) {
  if (!choice.solver) return {};
  const StepFacts& facts = choice.facts;
  const Question question{options, system, facts, failed, true};
  std::vector<Candidate> all = answered(question);
  std::string text = join(facts.candidates, " of ", system.points(), " points may carry pressure, in a box of ", facts.box,
                          ", tol = ", facts.tol, "\n");
  const auto taken = std::find_if(all.begin(), all.end(), [&](const Candidate& each) {
    return each.solver == choice.solver && each.backend == choice.backend;
  });
  if (taken == all.end()) return text;
  std::rotate(all.begin(), taken, taken + 1);
  for (const Candidate& each : all) {
    const std::string line = line_of(each, all.front()) + "\n";
    if (text.find("\n" + line) == std::string::npos) text += line;
  }
  if (question.any_backend && all.front().seconds <= worth_opening)
    text += "plugins: left alone, since to open them takes longer\n";
  return text;
}

const rc_backend& certifying_backend(const std::string& name, const rc_options& options, const System& system) {
  const rc_backend& backend = options.context->backend(name);
  if (const std::string what = beyond(backend, system); !what.empty())
    fail(RC_ERR_INCOMPATIBLE, RC_OPT_CERTIFY_BACKEND, " = ", name, ": this backend cannot do ", what,
         "; leave the option empty or name one that can");
  return backend;
}

bool are_few(std::int64_t contacts, std::int64_t points, bool by_rows) {
  if (by_rows)
    return contacts > 0 && contacts <= most_few_by_rows &&
           static_cast<double>(contacts) <= sparse_share_by_rows * static_cast<double>(points);
  return contacts > 0 && static_cast<double>(contacts) <= sparse_share * static_cast<double>(points);
}

std::optional<Choice> choose_for_few(const GridProblem& problem, std::int32_t control) {
  const rc_options& options = problem.options;
  const System& system = problem.system;
  if (!system.halfspace() || (!system.periodic() && !system.positive) ||
      system.points() < (system.periodic() ? least_sparse_of_period : least_sparse_points) ||
      options.text(RC_OPT_SOLVER) != "auto" || options.text(RC_OPT_WARMUP) != "none" ||
      !options.text(RC_OPT_CERTIFY_BACKEND).empty() || options.text(RC_OPT_BACKEND).find(',') != std::string::npos)
    return std::nullopt;
  const StepFacts facts{
      .control = control,
      .candidates = std::min(most_few, static_cast<std::int64_t>(sparse_share * static_cast<double>(system.points()))),
      .box = system.points(),
      .tol = options.real(RC_OPT_TOL),
      .few = !system.periodic(),
      .shared = problem.rows().shared() ? system.periodic() : problem.operators().multiply_by_rows()};
  const std::vector<std::string> none;
  const std::vector<Candidate> all = answered({options, system, facts, none, false, true});
  if (!can(all) || !(all.front().solver->controls & static_cast<std::uint32_t>(control))) return std::nullopt;
  return Choice{all.front().solver, all.front().backend, facts};
}

}  // namespace rc
