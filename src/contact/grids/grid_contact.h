// A contact on one grid, also on a coarser one. It solves steps and keeps the last two certified ones.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "contact/attempt.h"
#include "contact/grids/solver_grids.h"
#include "contact/memory/memory.h"
#include "contact/problem.h"
#include "contact/proof/certified.h"
#include "contact/surface/creep.h"
#include "contact/surface/indentation.h"

namespace rc {

// A contact drops this, each with all before it.
enum class Forgotten {
  steps,    // earlier steps, also those that operators keep something of; facts that hold for all contacts of the system stay
  surface,  // afterwards the next answer has the bits of a new contact's
  grids     // the coarser grids
};

class GridContact {
 public:
  // team: null, or a team to use instead of its own. If rows are shared, all ranks call the same functions.
  GridContact(const rc_system& system, const rc_options& options, const rc_team* team, const Company& company = {})
      : problem_(system, options, team, company), creep_(problem_.system.creep) {
    problem_.coarse = &grids_;
  }

  GridProblem& problem() { return problem_; }
  const GridProblem& problem() const { return problem_; }
  const Memory& memory() const { return memory_; }
  const SolverGrids& grids() const { return grids_; }
  Watcher& watcher() { return watcher_; }
  Monitor monitor() const;  // of the step that begins

  // Checks the step and takes its surface; a step that is refused changes nothing.
  Step prepare(const rc_step& step);
  // Before one more solve of the prepared step, with another target.
  void start_solve();
  // Solves a step that has prepared. nearer: the estimate of a coarser grid.
  Numbers solve_prepared(const Step& step, Monitor& monitor, const Outputs& outputs,
                         const std::optional<Estimate>& nearer = std::nullopt);
  // Certifies the pressures in outputs.p. compression: of a step that was solved elsewhere, if the load is prescribed; the steps
  // that follow see its indentation.
  Numbers certify(const rc_step& step, const Outputs& outputs, std::optional<double> compression = std::nullopt);
  // The memory that another solve of the prepared step starts from.
  void recall(Memory&& memory) { memory_ = std::move(memory); }
  // The last step does not change them.
  void leave_bodies() {
    overlap_ = {};
    creep_.leave_nothing();
  }
  // Remembers a step that is certified or within its goal.
  void remember(StepResult&& result, const Choice& by);

  void adopt(StepSurface&& given);
  void forget(Forgotten what);
  // The state after the steps that memory describes. surface: theirs, with the indentation.
  void restore(Memory&& memory, StepSurface&& surface, Indentation&& indentation, Creep&& creep);
  // The plastic indentation that the next step will see [nx*ny].
  void write_indentation(std::span<double> to) const;
  const Creep& creep() const { return creep_; }

 private:
  void settle();
  void keep_bodies(StepResult&& result);
  void forget_operators();

  GridProblem problem_;
  SolverGrids grids_;
  Memory memory_;
  Indentation indentation_;  // in the surface
  Overlap overlap_;          // of the last certified step; not in the surface yet
  Creep creep_;
  Watcher watcher_;
};

}  // namespace rc
