// A contact on one grid. It solves steps and remembers the last two that are certified. Coarser grids are such contacts, too.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>

#include "contact/attempt.h"
#include "contact/grids/solver_grids.h"
#include "contact/memory/memory.h"
#include "contact/problem.h"
#include "contact/proof/certified.h"
#include "contact/surface/indentation.h"

namespace rc {

class GridContact {
 public:
  // team: null, or a team to use instead of its own. Of a company by rows all call the same functions.
  GridContact(const rc_system& system, const rc_options& options, const rc_team* team, const Company& company = {})
      : problem_(system, options, team, company) {
    problem_.coarse = &grids_;
  }

  GridProblem& problem() { return problem_; }
  const GridProblem& problem() const { return problem_; }
  const Memory& memory() const { return memory_; }
  const SolverGrids& grids() const { return grids_; }
  const StepOutcome& outcome() const { return outcome_; }  // of the last step

  // From here on certified steps leave a plastic indentation; the contacts of coarser grids get theirs with the surface.
  void leave_indentations() { leaves_indentation_ = true; }
  void on_progress(const ProgressCallback& progress) { progress_ = progress; }
  // Solves stop when a finer grid's monitor says so, which must outlive them; with `report` its caller sees their progress.
  void watched_by(const Monitor& monitor, bool report);
  Monitor monitor() const;

  // Checks the step and takes its surface; a step that is refused changes nothing.
  Step begin(const rc_step& step);
  // Solves a step that has begun. nearer: the estimate of a coarser grid.
  Numbers solve_begun(const Step& step, Monitor& monitor, const Outputs& outputs,
                      const std::optional<Estimate>& nearer = std::nullopt);
  Numbers solve(const rc_step& step, const Outputs& outputs);
  // Certifies the pressures in outputs.p.
  Numbers certify(const rc_step& step, const Outputs& outputs);
  // The same of a step that was solved elsewhere, at this compression if the load is prescribed; the steps that follow see its
  // indentation.
  Numbers retrace(const rc_step& step, double compression, const Outputs& outputs);
  // Remembers a step that is certified or within its goal.
  void remember(Finished&& finished, const Choice& by);

  void adopt(StepSurface&& given);
  void reset();             // no earlier step, no coarser grids
  void forget();            // as new, but keeps what is the same for all contacts of the system
  void forget_operators();  // those of coarser grids, too
  void forget_steps() { memory_ = {}; }
  // The state after the steps that memory describes. surface: theirs, with the indentation.
  void restore(Memory&& memory, StepSurface&& surface, Indentation&& indentation);
  // The plastic indentation that the next step will see [nx*ny].
  void write_indentation(std::span<double> to) const;

  std::int64_t surfaces() const { return surfaces_; }  // counts its changes

  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  void clear_cancellation() { cancelled_.store(false, std::memory_order_relaxed); }

 private:
  Finished certified(const rc_step& step, const Outputs& outputs, std::optional<double> compression);
  void indent();
  void fill_masked();
  void forget_surface();

  GridProblem problem_;
  SolverGrids grids_;
  Memory memory_;
  StepOutcome outcome_;
  Indentation indentation_;  // in the surface
  Overlap overlap_;          // of the last certified step; not in the surface yet
  bool leaves_indentation_ = false;
  ProgressCallback progress_;
  std::int64_t surfaces_ = 0;
  std::atomic<bool> cancelled_{false};
};

}  // namespace rc
