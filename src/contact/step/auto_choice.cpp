#include "contact/step/auto_choice.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.h"

namespace rc {

namespace {

const char* kind_of(const System& system) {
  if (system.given.op == RC_OPERATOR_DENSE) return "the caller's dense matrix";
  if (system.given.op == RC_OPERATOR_CALLBACK) return "the caller's product";
  return system.periodic() ? "periodic boundaries" : "free boundaries";
}

bool fits(const rc_backend& backend, const System& system) {
  return (backend.caps & system.needed_caps()) == system.needed_caps();
}
bool factors(const rc_backend& backend) { return (backend.caps & RC_CAP_SUBSET) != 0; }

// Operations of a direct solve: assembly, about six factorisations of a third of the candidates, and a certificate that sums over
// contacts and points.
double direct_cost(const Counts& c) {
  const double n = static_cast<double>(c.candidates);
  return 4 * n * n + 6 * std::pow(n / 3, 3) / 3 + 0.5 * n * static_cast<double>(c.points);
}

// Operations of about forty products by padded transforms on the box, and one on the grid.
double transform_cost(const Counts& c) {
  const auto product = [](double points) { return 2.5 * 4 * points * std::log2(4 * points + 1); };
  return 40 * product(static_cast<double>(c.box)) + product(static_cast<double>(c.points));
}

constexpr double exact_tol = 1e-12;              // below this, iterations come near the limit of double precision
constexpr std::int64_t exact_candidates = 4096;  // up to which an exact solve is always affordable

// A factoring backend with an exact solver, or iterations on a matrix-free one.
bool prefers_direct(const Counts& counts) {
  if (counts.tol < exact_tol && counts.candidates <= exact_candidates) return true;
  return direct_cost(counts) <= transform_cost(counts);
}

constexpr std::int64_t least_dilute_points = 512 * 512;
constexpr double least_approximate_tol = 1e-9;  // two digits above what approximate products are good for
constexpr double few_share = 0.05;              // of the grid's points: products that cost by the contact are cheaper below

// Contacts so sparse in their bounding box that products which cost by the contact are cheaper than transforms of the box.
bool dilute(const Counts& counts) {
  return counts.points >= least_dilute_points && counts.tol >= least_approximate_tol && 8 * counts.candidates <= counts.box;
}

std::string describe(const std::vector<std::string>& reasons) {
  std::string text;
  for (const std::string& reason : reasons) text += (text.empty() ? "" : "; ") + reason;
  return text;
}

bool contains(const std::vector<std::string>& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The backends that "auto" chooses between, one of each kind.
struct Kinds {
  const rc_backend *direct = nullptr, *matrix_free = nullptr, *approximate = nullptr;

  template <class Usable> Kinds(const std::vector<const Component<rc_backend>*>& all, const Usable& usable) {
    const auto repeats = [](const rc_backend& backend) { return (backend.caps & RC_CAP_THREAD_INVARIANT) != 0; };
    for (const auto* component : all) {
      const rc_backend& backend = component->vtable;
      if (!usable(backend)) continue;
      const bool rough = (backend.caps & RC_CAP_APPROXIMATE) != 0;
      const rc_backend*& slot = rough ? approximate : factors(backend) ? direct : matrix_free;
      // Among equals the first by name, but before it one whose results do not depend on the number of threads.
      if (!slot || (!rough && !repeats(*slot) && repeats(backend))) slot = &backend;
    }
  }
};

// The first of the named backends that can be used; by counts for "auto".
const rc_backend& choose_backend(const rc_options& options, const System& system, std::int32_t control, const Counts& counts,
                                 const rc_solver* solver, const std::vector<std::string>& failed) {
  const std::string& wanted = options.text(RC_OPT_BACKEND);
  const bool fallbacks = options.integer(RC_OPT_ALLOW_FALLBACK) != 0;
  const auto reason = [&](const rc_backend& backend) {
    if (solver) return obstacle(*solver, backend, system, control, fallbacks);
    return fits(backend, system) ? std::string() : join("backend \"", backend.name, "\" cannot do ", kind_of(system));
  };
  if (wanted != "auto") {
    std::vector<std::string> reasons;
    std::optional<Error> missing;
    for (const std::string& name : split(wanted, ',')) {
      try {
        const rc_backend& backend = options.context->backend(name);
        reasons.push_back(reason(backend));
        if (reasons.back().empty()) return backend;
      } catch (const Error& error) {
        if (!missing) missing = error;
      }
    }
    if (missing && reasons.empty()) throw *missing;
    if (missing) reasons.push_back(missing->what());
    fail(RC_ERR_INCOMPATIBLE, describe(reasons));
  }
  const auto usable = [&](const rc_backend& backend) { return reason(backend).empty() && !contains(failed, backend.name); };
  // Plugins are opened only where what is built in cannot do as well, and all of them only where nothing else can do it at all.
  Kinds found(options.context->backends_for_auto(false), usable);
  const bool enough = system.halfspace() ? found.direct && prefers_direct(counts) : found.direct || found.matrix_free;
  if (!enough) found = Kinds(options.context->backends_for_auto(true), usable);
  if (!found.direct && !found.matrix_free) found = Kinds(options.context->backends(), usable);
  if (!found.direct && !found.matrix_free)
    fail(RC_ERR_NO_BACKEND, "no backend can do ", kind_of(system), solver ? " with this solver" : "", "; is a plugin missing?");
  if (!found.matrix_free || (found.direct && prefers_direct(counts))) return *found.direct;
  return found.approximate && dilute(counts) ? *found.approximate : *found.matrix_free;
}

}  // namespace

const char* suited(bool factors, bool grid) { return factors ? "nnls" : grid ? "haar-cg" : "polonsky-keer"; }

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

Choice choose(const rc_options& options, const System& system, std::int32_t control, const Counts& counts,
              const std::vector<std::string>& failed) {
  Choice choice;
  const std::string& wanted = options.text(RC_OPT_SOLVER);
  if (wanted != "auto") choice.solver = &options.context->solver(wanted);
  choice.backend = &choose_backend(options, system, control, counts, choice.solver, failed);
  if (!choice.solver) {
    const bool direct = factors(*choice.backend) && (prefers_direct(counts) || system.given.op == RC_OPERATOR_DENSE);
    const char* name = suited(direct, system.halfspace());
    for (const char* next : {"nnls", "polonsky-keer"})
      if (contains(failed, name)) name = next;
    if (contains(failed, name)) fail(RC_ERR_NO_SOLVER, "every solver that suits ", kind_of(system), " has failed");
    choice.solver = &options.context->solver(name);
  }
  return choice;
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

std::optional<Choice> choose_for_few(const rc_options& options, const System& system, std::int32_t control,
                                     const std::vector<std::string>& failed) {
  if (!system.halfspace() || system.periodic() || !system.positive || system.points() < least_dilute_points ||
      options.text(RC_OPT_SOLVER) != "auto" || options.text(RC_OPT_WARMUP) != "none" ||
      !options.text(RC_OPT_CERTIFY_BACKEND).empty())
    return std::nullopt;
  Choice choice;
  choice.solver = &options.context->solver(suited(false, true));
  if (contains(failed, choice.solver->name)) return std::nullopt;
  const std::string& wanted = options.text(RC_OPT_BACKEND);
  std::vector<const rc_backend*> candidates;
  if (wanted != "auto") {
    if (wanted.find(',') == std::string::npos) candidates = {&options.context->backend(wanted)};
  } else if (options.real(RC_OPT_TOL) >= least_approximate_tol) {
    for (const auto* component : options.context->backends_for_auto(true)) candidates.push_back(&component->vtable);
  }
  for (const rc_backend* backend : candidates) {
    if (!(backend->caps & RC_CAP_SCREEN) || contains(failed, backend->name)) continue;
    if (!obstacle(*choice.solver, *backend, system, control, options.integer(RC_OPT_ALLOW_FALLBACK) != 0).empty()) continue;
    choice.backend = backend;
    return choice;
  }
  return std::nullopt;
}

}  // namespace rc
