// A step reads this: the system, the options and the surface of one grid, and the company that solves it. Operators are made on
// demand beside it.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "contact/surface/gap_on_device.h"
#include "contact/surface/step_surface.h"
#include "contact/system.h"
#include "core/company.h"
#include "core/thread_team.h"
#include "registry/options_handle.h"

namespace rc {

class CoarseGrids;
class Operators;
struct Attempt;
struct Spectrum;

// Requests of the caller. Contacts of coarser grids have none.
struct Goal {
  double error = 0;  // the option accuracy: a relative error; 0: none
  bool of_area = false;
  bool keeps_answers = false;   // its solvers keep answers for the next step
  bool changes_bodies = false;  // its certified steps leave a plastic indentation, and a deflection in bodies that creep

  // A tolerance far below the goal. Areas need a smaller one: they count points, some of which carry hardly any pressure.
  double tol() const { return error / (of_area ? 1000 : 100); }
};
inline Goal goal_of(const rc_options& options) {
  return {options.real(RC_OPT_ACCURACY), options.text(RC_OPT_ACCURACY_OF) == "area", true, true};
}

// Facts for proofs and remarks, computed when a step first needs them.
struct Facts {
  std::shared_ptr<const Spectrum> spectrum;  // of the system
  std::optional<double> tilt;                // plane_share of the surface
  std::optional<double> punch;               // punch_stiffness of the system
};

// It cannot be moved: operators keep the addresses of its options and team.
class GridProblem {
 public:
  // team: null, or a team to use instead of its own. By rows all arrays over points are of this process's rows.
  GridProblem(const rc_system& system, const rc_options& options, const rc_team* team, const Company& company = {});
  ~GridProblem();
  GridProblem(const GridProblem&) = delete;
  GridProblem& operator=(const GridProblem&) = delete;

  // Checks the names of components before a step needs them. Throws Error(OPTION, NO_SOLVER, NO_BACKEND, INCOMPATIBLE).
  void set_options(const rc_options& given);
  const Company& company() const { return company_; }
  const Rows& rows() const { return company_.rows(); }
  const rc_team& team() const { return *team_; }
  // Whether the step's H p is wanted at all points.
  bool keeps_deflection() const { return goal.changes_bodies && !system.creep.empty(); }
  std::int64_t own_points() const { return system.given.nx * rows().own(system.given.ny); }  // of this process
  Operators& operators() const { return *operators_; }

  const System system;
  const Host host;  // with the system's kernel
  rc_options options;
  Goal goal;
  StepSurface surface;
  double compliance = 1;          // of the step, over that of the system: lengths of the surface and of answers are divided by it
  GapOnDevice gap_on_device;      // of the surface, if it is_of() that
  CoarseGrids* coarse = nullptr;  // solves coarser grids for solvers; it outlives the step; null: of a level of a pyramid
  mutable Facts facts;

 private:
  std::unique_ptr<ThreadTeam> own_team_;
  const rc_team* team_;
  const Company company_;
  std::unique_ptr<Operators> operators_;
};

// The grid of a half-space, without its gap.
rc_grid grid_of(const GridProblem& problem);

// Coarser grids for solvers: rc_problem.coarse.
class CoarseGrids {
 public:
  virtual ~CoarseGrids() = default;
  // attempt: at the step of the finest grid, whose limits hold.
  virtual rc_status solve(rc_coarse& request, const GridProblem& problem, const Attempt& attempt) = 0;
};

}  // namespace rc
