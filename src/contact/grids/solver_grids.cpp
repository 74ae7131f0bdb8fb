#include "contact/grids/solver_grids.h"

#include <algorithm>

#include "contact/coarse/level.h"
#include "contact/grids/grid_contact.h"
#include "core/error.h"
#include "core/host_call.h"

namespace rc {

SolverGrids::SolverGrids() = default;
SolverGrids::~SolverGrids() = default;

namespace {

constexpr std::int32_t keep_answer = 1;                        // rc_coarse.keep; 2: what was set up alone
constexpr std::int64_t most_gathered = std::int64_t{1} << 16;  // points of a grid that every process solves

rc_step coarse_step(const rc_coarse& request, std::int32_t warm, const double* gap, const std::uint8_t* mask) {
  rc_step step = RC_STEP_INIT;
  step.control = request.control;
  step.target = request.control == RC_CONTROL_LOAD ? request.load : request.approach;
  step.warm_start = warm;
  step.undeformed_gap.data = gap;
  step.mask.data = mask;
  return step;
}

Numbers solved(GridContact& contact, const rc_step& step, const Outputs& outputs) {
  const Step prepared = contact.prepare(step);
  Monitor monitor = contact.monitor();
  return contact.solve_prepared(prepared, monitor, outputs);
}

}  // namespace

rc_status SolverGrids::solve(rc_coarse& request, const GridProblem& problem, const Attempt& attempt) {
  const Monitor& monitor = attempt.monitor;
  const rc_system system = coarser_system(problem.system.given, request.nx, request.ny, request.factor);
  rc_options options = coarse_options(problem.options, monitor);
  options.set(RC_OPT_SOLVER, std::string(request.solver));
  options.set(RC_OPT_STIFFNESS, std::int64_t{0});
  if (request.tol > 0) options.set(RC_OPT_TOL, request.tol);

  if (problem.rows().shared()) return solve_shared(request, problem, attempt.warm, system, options);
  Level& level = levels_[system.nx * system.ny];
  if (level.contact && level.summary.nx == system.nx)
    level.contact->problem().set_options(options);
  else
    level.contact = std::make_unique<GridContact>(system, options, &problem.team(), problem.company());
  level.contact->watcher().progress = stopped_by(monitor);

  level.current = false;
  const rc_step step = coarse_step(request, attempt.warm, request.undeformed_gap, request.mask);
  const Numbers found = solved(*level.contact, step, {{request.p}, {}});
  const rc_status status = found.status;
  if (const rc_status stop = problem.company().stop().value_or(monitor.ask()); stop != RC_OK) return stop;
  request.approach = found.approach;
  if (request.keep == 0) {
    levels_.erase(system.nx * system.ny);
    return status;
  }
  if (request.keep != keep_answer) return status;
  level.summary = {sizeof(rc_level), {},
                   status,           0,
                   system.nx,        system.ny,
                   system.hx,        system.hy,
                   found.approach,   found.load(level.contact->problem().system),
                   found.candidates, found.totals.contacts};
  level.p.assign(request.p, request.p + system.nx * system.ny);
  level.current = true;
  return status;
}

// A small grid is solved by every process, all others by all of them together.
rc_status SolverGrids::solve_shared(rc_coarse& request, const GridProblem& problem, bool warm, const rc_system& system,
                                    rc_options options) {
  const Rows& rows = problem.rows();
  Level& level = levels_[system.nx * system.ny];
  const Rows half = rows.halved();
  const bool each_solves = system.nx * system.ny <= most_gathered || half.halvings() < 1;
  if (each_solves) options.set(RC_OPT_TIME_LIMIT, 0.0);  // a clock that stops one process stops all, between iterations
  rows.on_all([&] {
    level.contact =
        std::make_unique<GridContact>(system, options, &problem.team(), each_solves ? Company::repeated() : Company(half));
  });
  Numbers found;
  if (!each_solves) {
    found = solved(*level.contact, coarse_step(request, warm, request.undeformed_gap, request.mask), {{request.p}, {}});
  } else {
    const auto points = static_cast<std::size_t>(system.nx * system.ny);
    std::vector<double> gap, p;
    std::vector<std::uint8_t> mask;
    const bool masked = rows.any(request.mask != nullptr);
    rows.on_all([&] {
      gap.resize(points);
      p.resize(points);
      mask.resize(masked ? points : 0);
    });
    half.gather(request.undeformed_gap, system.nx, gap.data());
    if (masked) half.gather(request.mask, system.nx, mask.data());
    try {
      const FlagIgnored a_flag_that_stops_one_process_stops_all;
      found = solved(*level.contact, coarse_step(request, warm, gap.data(), masked ? mask.data() : nullptr), {{p.data()}, {}});
    } catch (const Error& error) {
      if (error.code() == RC_ERR_MEMORY) throw;
      found.status = error.code();  // that of every process, so the solve continues without this grid
      set_message(error.what());
    }
    std::copy_n(p.data() + half.first() * system.nx, half.own(0) * system.nx, request.p);
  }
  request.approach = found.approach;
  levels_.erase(system.nx * system.ny);  // the iteration that follows needs the memory
  const rc_status stop = problem.company().stop().value_or(RC_OK);
  return stop != RC_OK ? stop : found.status;
}

void SolverGrids::clear() { levels_.clear(); }

std::int64_t SolverGrids::current() const {
  return std::count_if(levels_.begin(), levels_.end(), [](const auto& entry) { return entry.second.current; });
}

void SolverGrids::describe(std::int64_t i, rc_level& out) const {
  const std::int64_t count = current();
  if (i < 0 || i >= count)
    fail(RC_ERR_ARGUMENT, "level = ", i, ": the last step left ", count, " coarse solutions, numbered from 0");
  for (const auto& [points, level] : levels_) {
    if (!level.current || i-- > 0) continue;
    const rc_array p = out.p;
    out = level.summary;
    out.p = p;
    if (p.data) std::ranges::copy(level.p, values_of<double>(p));
    return;
  }
}

void SolverGrids::start_solve() {
  for (auto& [points, level] : levels_) level.current = false;
}

void SolverGrids::forget() {
  for (auto& [points, level] : levels_) {
    if (level.contact) level.contact->forget(Forgotten::surface);
    level.current = false;
  }
}

}  // namespace rc
