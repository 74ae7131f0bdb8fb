// Solutions on coarser grids, for solvers that ask for them: each level is a contact of its own and is remembered.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "contact/contact.h"
#include "core/error.h"

namespace rc {

namespace {

std::int32_t ask(const rc_progress*, void* monitor) { return static_cast<const Monitor*>(monitor)->ask() != RC_OK; }

}  // namespace

rc_status Contact::solve_coarse(rc_coarse& request, const Monitor& monitor) {
  rc_system system = system_.given;
  system.nx = request.nx;
  system.ny = request.ny;
  system.hx *= static_cast<double>(request.factor);
  system.hy *= static_cast<double>(request.factor);
  rc_options options = options_;
  const auto set = [&](const char* key, const OptionValue& value) { options.values.set(options.context->option(key), value); };
  set(RC_OPT_SOLVER, std::string(request.solver));
  set(RC_OPT_STIFFNESS, std::int64_t{0});
  set(RC_OPT_BOUNDS, std::int64_t{0});
  set(RC_OPT_TIME_LIMIT, monitor.time_left());
  if (request.tol > 0) set(RC_OPT_TOL, request.tol);

  Level& level = levels_[system.nx * system.ny];
  if (level.contact && level.summary.nx == system.nx)
    level.contact->set_options(options);
  else
    level.contact = std::make_unique<Contact>(system, options, team_);
  level.contact->goal_ = {};  // this grid is asked for, and no other
  level.contact->on_progress({ask, const_cast<Monitor*>(&monitor), 1});

  rc_step step = RC_STEP_INIT;
  step.control = request.control;
  step.target = request.control == RC_CONTROL_LOAD ? request.load : request.approach;
  step.warm_start = warm_;
  step.gap = request.gap;
  step.mask = request.mask;
  rc_result result{};
  result.p = request.p;
  level.current = false;
  const rc_status status = level.contact->solve(step, result);
  if (const rc_status stop = monitor.ask(); stop != RC_OK) return stop;
  request.approach = result.displacement;
  if (!request.keep) {
    levels_.erase(system.nx * system.ny);
    return status;
  }
  level.summary = {
      sizeof(rc_level), nullptr,           status,         0, system.nx, system.ny, system.hx, system.hy, result.displacement,
      result.load,      result.candidates, result.contacts};
  level.p.assign(request.p, request.p + system.nx * system.ny);
  level.current = true;
  return status;
}

void Contact::level(std::int64_t i, rc_level& out) const {
  std::vector<const Level*> current;
  for (const auto& [points, each] : levels_)
    if (each.current) current.push_back(&each);
  if (i < 0 || i >= static_cast<std::int64_t>(current.size()))
    fail(RC_ERR_ARGUMENT, "level ", i, " is not in 0 .. ", static_cast<std::int64_t>(current.size()) - 1, ": the last step left ",
         current.size(), " coarse solutions");
  const Level& found = *current[static_cast<std::size_t>(i)];
  double* const p = out.p;
  out = found.summary;
  out.p = p;
  if (p) std::copy(found.p.begin(), found.p.end(), p);
}

}  // namespace rc
