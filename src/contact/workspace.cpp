#include "contact/workspace.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "contact/step/monitor.h"
#include "core/error.h"

namespace rc {

namespace {

// If both solver and backend are named, they must go together.
void check_names(const rc_options& options, const System& system) {
  if (const std::string& first = options.text(RC_OPT_WARMUP); first != "none") options.context->solver(first);
  const std::string& solver = options.text(RC_OPT_SOLVER);
  if (solver != "auto") options.context->solver(solver);
  if (const std::string& certifier = options.text(RC_OPT_CERTIFY_BACKEND); !certifier.empty())
    certifying_backend(certifier, options, system);
  if (options.text(RC_OPT_BACKEND) != "auto") choose(options, system, {});
}

// Components of systems without a half-space share nothing: their matrix or product is the caller's.
std::string key_of(const System& system, const Workspace& work) {
  return system.halfspace() ? system.key : join("contact ", static_cast<const void*>(&work));
}

// An accuracy goal loosens tol: digits below the grid's own error are wasted.
rc_options loosened(const rc_options& given) {
  rc_options options = given;
  const double tol = goal_of(given).tol();
  if (tol > options.real(RC_OPT_TOL)) options.set(RC_OPT_TOL, tol);
  return options;
}

}  // namespace

Workspace::Workspace(const rc_system& given, const rc_options& given_options, const rc_team* team, const Ranks* ranks)
    : system(checked_system(given, given_options, true)),
      host(*given_options.context, system.influence.get(), key_of(system, *this)),
      options(given_options),
      team_(team),
      ranks_(ranks) {
  set_options(given_options);
  if (!team_) {
    own_team_ = std::make_unique<ThreadTeam>(options.integer(RC_OPT_THREADS));
    team_ = own_team_.get();
  }
}

void Workspace::set_options(const rc_options& given) {
  if (given.context != options.context) fail(RC_ERR_OPTION, "these options belong to another context");
  for (const OptionSpec* spec : options.context->known_options())
    if (spec->fixed && given.values.get(*spec) != options.values.get(*spec))
      fail(RC_ERR_OPTION, "option \"", spec->key, "\" is fixed when the contact is created; make a new contact to change it");
  check_names(given, system);
  options = loosened(given);
}

rc_grid Workspace::grid() const {
  const rc_system& s = system.given;
  return {.struct_size = sizeof(rc_grid),
          .nx = s.nx,
          .ny = s.ny,
          .hx = s.hx,
          .hy = s.hy,
          .mask = surface.mask(),
          .boundary = s.boundary,
          .softness = system.periodic() ? system.lambda_most / system.half_space_wave() : 1};
}

Operator& Workspace::bound_operator(const rc_backend& backend, const TrialSet& trial) {
  const auto begun = Clock::now();
  auto it = operators_.find(backend.name);
  if (it == operators_.end()) {
    auto made = rows_ ? std::make_unique<Operator>(rows_->bound_operator(backend, {rows_->own_points(), {}}))
                      : std::make_unique<Operator>(backend, host, system.unit, system.kernel, options, *team_,
                                                   system.operator_scale, ranks_);
    it = operators_.emplace(backend.name, std::move(made)).first;
  }
  it->second->bind(trial);
  record.setup_seconds += seconds_since(begun);
  return *it->second;
}

void Workspace::forget_operators() {
  std::erase_if(operators_, [](const auto& entry) { return !entry.second->forget(); });
}

void Workspace::rest_operators() {
  for (const auto& [name, op] : operators_) op->rest();
}

std::int64_t Workspace::products() const {
  std::int64_t total = 0;
  for (const auto& [name, op] : operators_) total += op->products();
  return total;
}

bool Workspace::coefficients_by_team(std::int64_t mx, std::int64_t my, double* out) const {
  constexpr std::int64_t values_at_once = 1 << 15;
  if (system.unit.boundary == RC_BOUNDARY_PERIODIC || team().threads == 1) return false;
  const std::int64_t rows = std::max<std::int64_t>(1, values_at_once / mx);
  std::atomic<bool> all = true;
  roughcontact::for_each(team(), (my + rows - 1) / rows, true, [&](std::int64_t item, std::int64_t) {
    const std::int64_t first = item * rows, count = std::min(rows, my - first);
    if (host.window(&host, &system.unit, system.kernel.c_str(), 0, first, mx, count, out + first * mx) != RC_OK) all = false;
  });
  return all;
}

rc_status Workspace::coefficients(std::int64_t mx, std::int64_t my, double* out) {
  constexpr std::int64_t most = 1 << 14;  // values that are kept
  const auto computed = [&](double* to) { return host.coefficients(&host, &system.unit, system.kernel.c_str(), mx, my, to); };
  if (mx > most / my) return coefficients_by_team(mx, my, out) ? RC_OK : computed(out);
  if (mx != table_.mx || my != table_.my) {
    rc_status status = RC_OK;
    const auto make = [&] {
      auto values = std::make_shared<std::vector<double>>(static_cast<std::size_t>(mx * my));
      status = computed(values->data());
      return status == RC_OK ? values : nullptr;
    };
    const std::string key = join("coefficients ", mx, " ", my, " ", host.identity);
    auto values = options.context->shared().get<const std::vector<double>>(key, make);
    if (!values) return status;
    table_ = {mx, my, std::move(values)};
  }
  std::copy(table_.values->begin(), table_.values->end(), out);
  return RC_OK;
}

}  // namespace rc
