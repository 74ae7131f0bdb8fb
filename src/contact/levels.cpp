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

rc_status Contact::solve_coarse(const rc_coarse& request, const Monitor& monitor) {
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

  Level& level = levels_[system.nx * system.ny];
  if (level.contact && level.summary.nx == system.nx)
    level.contact->set_options(options);
  else
    level.contact = std::make_unique<Contact>(system, options);
  level.contact->on_progress({ask, const_cast<Monitor*>(&monitor), 1});

  level.p.resize(static_cast<std::size_t>(system.nx * system.ny));
  rc_step step = RC_STEP_INIT;
  step.target = request.approach;
  step.warm_start = warm_;
  step.gap = request.gap;
  step.mask = request.mask;
  rc_result result{};
  result.p = level.p.data();
  level.current = false;
  const rc_status status = level.contact->solve(step, result);
  if (const rc_status stop = monitor.ask(); stop != RC_OK) return stop;
  level.summary = {sizeof(rc_level), nullptr,   status,      0,           system.nx,         system.ny,
                   system.hx,        system.hy, step.target, result.load, result.candidates, result.contacts};
  level.current = true;
  std::copy(level.p.begin(), level.p.end(), request.p);
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
