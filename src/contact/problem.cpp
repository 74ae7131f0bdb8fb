#include "contact/problem.h"

#include "contact/choice.h"
#include "contact/operators.h"
#include "core/error.h"
#include "core/grid.h"

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
std::string key_of(const System& system, const GridProblem& problem) {
  return system.halfspace() ? system.kernel.key : join("contact ", static_cast<const void*>(&problem));
}

// An accuracy goal loosens tol: digits below the grid's own error are wasted.
rc_options loosened(const rc_options& given) {
  rc_options options = given;
  const double tol = goal_of(given).tol();
  if (tol > options.real(RC_OPT_TOL)) options.set(RC_OPT_TOL, tol);
  return options;
}

}  // namespace

GridProblem::GridProblem(const rc_system& given, const rc_options& given_options, const rc_team* team, const Company& company)
    : system(checked_system(given, given_options, true)),
      host(*given_options.context, system.kernel.influence.get(), key_of(system, *this)),
      options(given_options),
      team_(team),
      company_(company) {
  set_options(given_options);
  check_memory(system.given, own_points());
  if (!team_) {
    own_team_ = std::make_unique<ThreadTeam>(options.integer(RC_OPT_THREADS));
    team_ = own_team_.get();
  }
  operators_ = std::make_unique<Operators>(*this);
}

GridProblem::~GridProblem() = default;

void GridProblem::set_options(const rc_options& given) {
  if (given.context != options.context) fail(RC_ERR_OPTION, "these options belong to another context");
  for (const OptionSpec* spec : options.context->known_options())
    if (spec->fixed && given.values.get(*spec) != options.values.get(*spec))
      fail(RC_ERR_OPTION, "option \"", spec->key, "\" is fixed when the contact is created; make a new contact to change it");
  check_names(given, system);
  options = loosened(given);
}

rc_grid grid_of(const GridProblem& problem) {
  const System& system = problem.system;
  const rc_system& s = system.given;
  return {.struct_size = sizeof(rc_grid),
          .nx = s.nx,
          .ny = s.ny,
          .hx = s.hx,
          .hy = s.hy,
          .mask = problem.surface.mask().data(),
          .softness = system.periodic() ? system.bounds.lambda_most / system.half_space_wave() : 1,
          .boundary = s.boundary};
}

}  // namespace rc
