// A contact on one grid. It solves steps and remembers the last two that are certified. Coarser grids are such contacts, too.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>

#include "contact/memory/memory.h"
#include "contact/step/answer.h"
#include "contact/step/monitor.h"
#include "contact/surface/indentation.h"
#include "contact/workspace.h"

namespace rc {

struct Finished;

class GridContact {
 public:
  // team: null, or a team to use instead of its own. ranks: null, or those that share the grid by rows; see Workspace. All of
  // them then call the same functions.
  GridContact(const rc_system& system, const rc_options& options, const rc_team* team, const Ranks* ranks = nullptr)
      : work_(system, options, team, ranks) {}

  Workspace& work() { return work_; }
  const Workspace& work() const { return work_; }
  const Memory& memory() const { return memory_; }

  void set_options(const rc_options& options) { work_.set_options(options); }
  // From here on certified steps leave a plastic indentation; the contacts of coarser grids get theirs with the surface.
  void leave_indentations() { leaves_indentation_ = true; }
  void on_progress(const ProgressCallback& progress) { progress_ = progress; }
  // Solves stop when a finer grid's monitor says so, which must outlive them; with `report` its caller sees their progress.
  void watched_by(const Monitor& monitor, bool report);
  Monitor monitor() const;

  // Checks the step and takes its surface; a step that is refused changes nothing.
  void begin(const rc_step& step);
  // Solves a step that has begun. nearer: the estimate of a coarser grid.
  rc_status solve_begun(const rc_step& step, Monitor& monitor, rc_result& result, std::optional<Estimate> nearer = std::nullopt);
  rc_status solve(const rc_step& step, rc_result& result);
  // Certifies the pressures in result.p or result.p_single.
  rc_status certify(const rc_step& step, rc_result& result);
  // The same of a step that was solved elsewhere, at this compression if the load is prescribed; the steps that follow see its
  // indentation.
  rc_status retrace(const rc_step& step, double compression, rc_result& result);
  // Remembers a step that is certified or within its goal.
  void remember(Finished&& finished, const rc_result& result);

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
  void indent();
  void fill_masked();
  void forget_surface();

  Workspace work_;
  Memory memory_;
  Indentation indentation_;  // in the surface
  Overlap overlap_;          // of the last certified step; not in the surface yet
  bool leaves_indentation_ = false;
  ProgressCallback progress_;
  std::int64_t surfaces_ = 0;
  std::atomic<bool> cancelled_{false};
};

}  // namespace rc
