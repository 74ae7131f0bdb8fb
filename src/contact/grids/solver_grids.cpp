#include "contact/grids/solver_grids.h"

#include <algorithm>

#include "contact/grid_contact.h"
#include "contact/grids/pyramid.h"
#include "contact/step/monitor.h"
#include "contact/workspace.h"
#include "core/error.h"
#include "core/ranks.h"

namespace rc {

SolverGrids::SolverGrids() = default;
SolverGrids::~SolverGrids() = default;

namespace {

constexpr std::int32_t keep_answer = 1;  // rc_coarse.keep; 2: what was set up alone

}  // namespace

rc_status SolverGrids::solve(rc_coarse& request, const Workspace& work, const Monitor& monitor) {
  const rc_system system = coarser_system(work.system.given, request.nx, request.ny, request.factor);
  rc_options options = coarse_options(work.options, monitor);
  options.set(RC_OPT_SOLVER, std::string(request.solver));
  options.set(RC_OPT_STIFFNESS, std::int64_t{0});
  if (request.tol > 0) options.set(RC_OPT_TOL, request.tol);

  if (work.ranks()) return solve_shared(request, work, system, options);
  Level& level = levels_[system.nx * system.ny];
  if (level.contact && level.summary.nx == system.nx)
    level.contact->set_options(options);
  else
    level.contact = std::make_unique<GridContact>(system, options, &work.team());
  level.contact->watched_by(monitor, false);
  level.contact->work().do_alike(work.alike());
  level.contact->work().passes_over = work.passes_over;

  rc_step step = RC_STEP_INIT;
  step.control = request.control;
  step.target = request.control == RC_CONTROL_LOAD ? request.load : request.approach;
  step.warm_start = work.record.warm;
  step.undeformed_gap = request.undeformed_gap;
  step.mask = request.mask;
  rc_result result{};
  result.p = request.p;
  level.current = false;
  const rc_status status = level.contact->solve(step, result);
  if (const rc_status stop = work.alike() ? RC_OK : monitor.ask(); stop != RC_OK) return stop;
  request.approach = result.approach;
  if (request.keep == 0) {
    levels_.erase(system.nx * system.ny);
    return status;
  }
  if (request.keep != keep_answer) return status;
  level.summary = {sizeof(rc_level), nullptr,   status,          0,           system.nx,         system.ny,
                   system.hx,        system.hy, result.approach, result.load, result.candidates, result.contacts};
  level.p.assign(request.p, request.p + system.nx * system.ny);
  level.current = true;
  return status;
}

namespace {

constexpr std::int64_t most_gathered = std::int64_t{1} << 16;  // points of a grid that every rank solves alike

rc_step step_of(const rc_coarse& request, std::int32_t warm, const double* gap, const std::uint8_t* mask) {
  rc_step step = RC_STEP_INIT;
  step.control = request.control;
  step.target = request.control == RC_CONTROL_LOAD ? request.load : request.approach;
  step.warm_start = warm;
  step.undeformed_gap = gap;
  step.mask = mask;
  return step;
}

}  // namespace

// A small grid is solved by every rank alike, all others by all of them together.
rc_status SolverGrids::solve_shared(rc_coarse& request, const Workspace& work, const rc_system& system, rc_options options) {
  const Ranks& all = *work.ranks();
  Level& level = levels_[system.nx * system.ny];
  level.ranks = std::make_unique<Ranks>(all.halved());
  const Ranks& ranks = *level.ranks;
  const bool alike = system.nx * system.ny <= most_gathered || ranks.halvings() < 1;
  if (alike) options.set(RC_OPT_TIME_LIMIT, 0.0);  // a clock that stops one rank stops all, between iterations
  on_all(&all, [&] { level.contact = std::make_unique<GridContact>(system, options, &work.team(), alike ? nullptr : &ranks); });
  rc_result result{};
  rc_status status = RC_OK;
  if (!alike) {
    result.p = request.p;
    status = level.contact->solve(step_of(request, work.record.warm, request.undeformed_gap, request.mask), result);
  } else {
    const auto points = static_cast<std::size_t>(system.nx * system.ny);
    std::vector<double> gap, p;
    std::vector<std::uint8_t> mask;
    const bool masked = all.any(request.mask != nullptr);
    on_all(&all, [&] {
      gap.resize(points);
      p.resize(points);
      mask.resize(masked ? points : 0);
    });
    ranks.gather_rows(request.undeformed_gap, system.nx, gap.data());
    if (masked) ranks.gather_rows(request.mask, system.nx, mask.data());
    result.p = p.data();
    level.contact->work().passes_over = false;
    try {
      status = level.contact->solve(step_of(request, work.record.warm, gap.data(), masked ? mask.data() : nullptr), result);
    } catch (const Error& error) {
      if (error.code() == RC_ERR_MEMORY) throw;
      status = error.code();  // that of every rank, so the solve goes on without this grid
      set_message(error.what());
    }
    std::copy_n(p.data() + ranks.first_row() * system.nx, ranks.rows() * system.nx, request.p);
  }
  request.approach = result.approach;
  levels_.erase(system.nx * system.ny);  // the iteration that follows needs the memory
  return all.stop() != RC_OK ? all.stop() : status;
}

void SolverGrids::clear() { levels_.clear(); }

std::int64_t SolverGrids::current() const {
  return std::count_if(levels_.begin(), levels_.end(), [](const auto& entry) { return entry.second.current; });
}

void SolverGrids::describe(std::int64_t i, rc_level& out) const {
  const std::int64_t count = current();
  if (i < 0 || i >= count)
    fail(RC_ERR_ARGUMENT, "level ", i, " is not in 0 .. ", count - 1, ": the last step left ", count, " coarse solutions");
  for (const auto& [points, level] : levels_) {
    if (!level.current || i-- > 0) continue;
    double* const p = out.p;
    out = level.summary;
    out.p = p;
    if (p) std::copy(level.p.begin(), level.p.end(), p);
    return;
  }
}

void SolverGrids::begin_step() {
  for (auto& [points, level] : levels_) level.current = false;
}

void SolverGrids::forget() {
  for (auto& [points, level] : levels_) {
    if (level.contact) level.contact->forget();
    level.current = false;
  }
}

}  // namespace rc
