// A caller's contact: the one on the given grid, the accuracy goal with its coarser grids, and arrays on devices.
#pragma once

#include <roughcontact/derivatives.h>
#include <roughcontact/history.h>

#include <cstdint>
#include <optional>

#include "contact/calls/device_arrays.h"
#include "contact/grids/goal/accuracy_goal.h"
#include "registry/options_handle.h"

namespace rc {

// Settings that a history changes for its steps.
struct Asked {
  std::int64_t stiffness, bounds;  // the options of these names
  bool changes_bodies;             // whether it leaves an indentation and creep to those after it
};

// A step that the contact has prepared, by load if the area is prescribed.
struct Prepared {
  Step step;
  std::optional<double> share;  // of the nominal area, which the load is to give
};

class Contact {
 public:
  Contact(const rc_system& system, const rc_options& options, const Company& company = {});

  const GridProblem& problem() const { return grid_.problem(); }
  const System& system() const { return problem().system; }
  const GridContact& grid() const { return grid_; }
  Watcher& watcher() { return grid_.watcher(); }
  void set_options(const rc_options& options);

  // solve and certify accept arrays on a device. compression: see GridContact.
  Numbers solve(const rc_step& step, const Outputs& outputs);
  Numbers certify(const rc_step& step, const Outputs& outputs, std::optional<double> compression = std::nullopt);

  // Derivatives of the last step. Throw Error(ARGUMENT) where it did not return RC_OK.
  rc_status gradient(rc_gradient& gradient);
  rc_status tangent(rc_tangent& tangent);

  void forget(Forgotten what);
  // Restores the state after the steps described, which this contact or another has solved. Throws Error(ARGUMENT).
  void restore(const rc_state& state);

  // One step of a history, while it is Cancellable.
  Prepared prepare(const rc_step& step);
  Numbers solve_prepared(const Prepared& step, const Outputs& outputs);
  void ask(const Asked& asked);

 private:
  void start_solve();  // before one more solve of the prepared step
  Numbers at_target(const Step& step, Monitor& monitor, const Outputs& outputs);
  Numbers at_area(Step step, double share, Monitor& monitor, const Outputs& outputs);
  void drop_copies();

  HeldCopies held_;  // outlives what refers to it
  GridContact grid_;
  AccuracyGoal goal_;
};

}  // namespace rc
