// What the steps of one contact work with: the problem, the current step's surface, and the components made for them. It holds no
// solution.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/calls/device_arrays.h"
#include "contact/grids/solver_grids.h"
#include "contact/proof/bounds.h"
#include "contact/proof/spectrum.h"
#include "contact/step/choice.h"
#include "contact/surface/step_surface.h"
#include "contact/system.h"
#include "core/thread_team.h"
#include "operator/operator.h"
#include "registry/options_handle.h"

namespace rc {

// The accuracy goal: what the option accuracy asks for.
struct Goal {
  double error = 0;  // relative; 0: none
  bool of_area = false;

  // A tolerance far below the goal. Areas need a smaller one: they count points, some of which carry hardly any pressure.
  double tol() const { return error / (of_area ? 1000 : 100); }
};
inline Goal goal_of(const rc_options& options) {
  return {options.real(RC_OPT_ACCURACY), options.text(RC_OPT_ACCURACY_OF) == "area"};
}

// Notes of one step, for its result and for its next choice.
struct StepRecord {
  bool warm = true;                         // the step may start from earlier steps
  Choice choice;                            // the latest
  std::vector<std::string> failed;          // components that "auto" passes over
  bool by_solver = false;                   // the last failure was a solver's own, not its backend's
  std::vector<std::string> remarks;         // for rc_result.note
  std::int64_t look = 0;                    // most iterations of a look at the given grid; 0: this is a solve
  double setup_seconds = 0;                 // of operators
  std::int64_t products_before = 0;         // products that the operators had made
  rc_accuracy accuracy = RC_ACCURACY_INIT;  // of its answer; model_nx = 0: it has none
  std::int32_t certified = 0;               // its control, once its answer on this grid is certified and remembered
  std::int64_t undecided = -1;              // of that answer
  std::optional<ProvenSets> proven;         // of that answer, where its stiffness is to have an interval
};

// Facts for proofs and remarks, computed when a step first needs them.
struct ProofFacts {
  std::optional<Spectrum> spectrum;  // of the problem
  std::optional<double> tilt;        // plane_share of the surface
  std::optional<double> punch;       // punch_stiffness of the system
};

// It cannot be moved: operators keep the addresses of its options and team.
class Workspace {
 public:
  // team: null, or a team to use instead of its own. ranks: null, or those that share the grid by rows, which must outlive it:
  // all arrays over points are then of this rank's rows.
  Workspace(const rc_system& system, const rc_options& options, const rc_team* team, const Ranks* ranks = nullptr);
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  // Checks the names of components before a step needs them. Throws Error(OPTION, NO_SOLVER, NO_BACKEND, INCOMPATIBLE).
  void set_options(const rc_options& given);
  const rc_team& team() const { return *team_; }
  const Ranks* ranks() const { return ranks_; }
  // Null, or the ranks that all do alike, with all points, what this one does; then they agree on stops.
  const Ranks* alike() const { return surface.tiles() ? surface.tiles()->shared().ranks() : alike_; }
  void do_alike(const Ranks* ranks) { alike_ = ranks; }
  // Null, or the workspace of this rank's rows on the same grid: its operators make the products of this one, all ranks together.
  Workspace* rows() const { return rows_; }
  void multiply_by(Workspace* rows) { rows_ = rows; }
  std::int64_t own_rows() const { return ranks_ ? ranks_->rows() : system.given.ny; }
  std::int64_t own_points() const { return system.given.nx * own_rows(); }  // of this process
  rc_grid grid() const;                                                     // of a half-space; without its gap

  // This backend's operator, bound to that trial set. It is made at the first call.
  Operator& bound_operator(const rc_backend& backend, const TrialSet& trial);
  void drop_operator(const char* backend) { operators_.erase(backend); }
  // Factors depend on the order in which points came, transforms on earlier, larger boxes. After this the next answer has the
  // bits of a first one.
  void forget_operators();
  // A step is over: what operators keep for products only is freed, or lent to other contacts.
  void rest_operators();
  std::int64_t products() const;  // of all operators
  // Dimensionless influence coefficients. The last table is kept, because solvers ask for the same one at every step.
  rc_status coefficients(std::int64_t mx, std::int64_t my, double* out);

  const System system;
  const Host host;  // with the system's kernel
  rc_options options;
  // Both set by Contact: the contact of a coarser grid has no goal, and its solvers keep nothing between steps.
  Goal goal;
  bool keeps_history = false;
  bool passes_over = true;  // "auto" goes on without a component that lacks memory; not where other ranks do the same
  StepSurface surface;
  GapOnDevice gap_on_device;  // of the surface, where it is_of() that
  StepRecord record;
  ProofFacts facts;
  SolverGrids solver_grids;

 private:
  // Free systems: by all threads. False where that is not possible, or some value is refused: out is then to be filled anew.
  bool coefficients_by_team(std::int64_t mx, std::int64_t my, double* out) const;

  struct Table {
    std::int64_t mx = 0, my = 0;
    std::shared_ptr<const std::vector<double>> values;  // shared by contacts of one context with the same system
  };

  std::unique_ptr<ThreadTeam> own_team_;
  const rc_team* team_;
  const Ranks* ranks_;
  const Ranks* alike_ = nullptr;
  Workspace* rows_ = nullptr;
  std::map<std::string, std::unique_ptr<Operator>> operators_;
  Table table_;
};

// At its end the operators rest.
class Rest {
 public:
  explicit Rest(Workspace& work) : work_(work) {}
  ~Rest() { work_.rest_operators(); }
  Rest(const Rest&) = delete;
  Rest& operator=(const Rest&) = delete;

 private:
  Workspace& work_;
};

}  // namespace rc
