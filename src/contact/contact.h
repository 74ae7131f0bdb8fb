// One contact: a system, its operators, and what is remembered from step to step.
#pragma once

#include <atomic>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/blocks.h"
#include "contact/certificate.h"
#include "contact/grid_error.h"
#include "contact/monitor.h"
#include "contact/pressures.h"
#include "contact/selection.h"
#include "contact/solver_run.h"
#include "contact/spectrum.h"
#include "contact/surface_state.h"
#include "contact/system.h"
#include "core/team.h"
#include "operator/operator.h"
#include "registry/options_handle.h"

namespace rc {

// A solution on a trial set, before it is certified.
struct Answer {
  rc_status status = RC_OK;
  Choice choice;
  Operator* op = nullptr;                                   // bound to the trial set
  std::vector<double> p;                                    // on the trial set, dimensionless
  double length_unit = 1;                                   // [length]
  double pressure_unit = 1;                                 // [force/length^2]
  double compression = 0;                                   // [length] approach less the lowest gap
  double limit = -std::numeric_limits<double>::infinity();  // [length] the trial set holds every point of a smaller height
  std::optional<Deflected> checked;                         // what the operator's screening told of all points
  bool handed_over = false;  // the solver's own load control stalled; the core's iteration on the approach took over
  double datum_shift = 0;    // [length] what the trial set's zero mode adds to H p
};

// What a coarser grid or an earlier step tells of a solution.
struct Estimate {
  Pressures pressures;  // of the points that carry some
  double approach = 0;  // [length]
};

class Contact {
 public:
  // team: null, or one to work with instead of its own.
  Contact(const rc_system& system, const rc_options& options, const rc_team* team = nullptr);

  void set_options(const rc_options& options);
  void on_progress(const ProgressCallback& progress) { progress_ = progress; }
  rc_status solve(const rc_step& step, rc_result& result);
  // The steps of a history in order; `completed` counts those that are certified and written.
  rc_status solve_path(const rc_path& path, std::int64_t& completed);
  rc_status certify_given(const rc_step& step, rc_result& result);
  // Points and pressures of the last certified step's contact set, as many as there is room for; returns how many there are.
  std::int64_t contact_points(std::int64_t room, std::int64_t* index, double* p) const;
  // A coarse solution of the last step, the coarsest first.
  void level(std::int64_t i, rc_level& out) const;
  void reset();
  // As new: operators, too, forget what they served (the lengths of transforms that a larger set called for), since answers would
  // differ by round-off. What is the same for all contacts of the system stays.
  void forget();
  // As after the steps described, which this contact or another has solved.
  void restore(const rc_state& state);
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }

  // True for the one thread that may use the contact now.
  bool try_enter() { return !busy_.exchange(true, std::memory_order_acquire); }
  void leave() { busy_.store(false, std::memory_order_release); }

 private:
  struct Last {
    Pressures pressures;  // empty: none
    double approach = 0, load = 0;
    bool same_gap = false;  // it belongs to the current gap
  };

  // A solution on a coarser grid, and the contact that found it: the next step needs it again.
  struct Level {
    std::unique_ptr<Contact> contact;
    rc_level summary{};
    std::vector<double> p;
    bool current = false;  // of this step
  };

  // A coarser grid, on which a goal of accuracy may be met.
  struct Model {
    std::unique_ptr<Contact> contact;
    rc_result result{};  // of this step
    std::vector<double> gap;
  };
  struct OnCoarserGrids {
    std::size_t grid = 0;              // the last that was solved, if it is of use; 0: none
    rc_status status = RC_OK;          // a stop, or RC_WITHIN_GOAL: it is worth a look at the given grid
    std::optional<Estimate> estimate;  // for the whole grid
  };

  // Influence coefficients, dimensionless.
  struct Table {
    std::int64_t mx = 0, my = 0;
    std::vector<double> values;
  };

  struct ClearCancellation {
    std::atomic<bool>& flag;
    ~ClearCancellation() { flag.store(false, std::memory_order_relaxed); }
  };

  void begin(const rc_step& step);
  void forget_operators();
  Last certified(const double* p, double displacement, double load, const SurfaceState& surface, const char* suffix) const;
  void adopt(SurfaceState&& given);
  void adopt(const rc_options& options);
  // nearer: what a coarser grid tells.
  rc_status solve_begun(const rc_step& step, rc_result& result, std::optional<Estimate> nearer = std::nullopt);
  void check_names(const rc_options& options) const;
  std::optional<SurfaceState> given_surface(const rc_step& step) const;
  void check_target(const rc_step& step, const SurfaceState& surface) const;
  bool nothing_touches(const rc_step& step) const;
  // Of the step's approach.
  double compression(const rc_step& step) const;
  double ahead(const rc_step& step) const;
  // nearer: better pressures than the step's.
  std::vector<double> start(const rc_step& step, const TrialSet& trial, double pressure_unit, const Pressures* nearer) const;
  std::vector<double> compenetrations(const Answer& answer, double datum) const;

  TrialSet trial_below(double limit) const;
  Choice choose_for(const TrialSet& trial, std::int32_t control);
  bool pass_over(const char* name, const char* option, const std::string& reason);
  TrialSet widened(TrialSet trial, const Choice& choice) const;
  Operator& bound_operator(const rc_backend& backend, const TrialSet& trial);
  Answer prepare(const TrialSet& trial, std::int32_t control, double length_unit);
  rc_grid grid() const;  // of a half-space
  SolverRun run(const Answer& answer, Monitor& monitor);
  double solver_tol() const;
  rc_status solve_coarse(rc_coarse& request, const Monitor& monitor);
  rc_status coefficients(std::int64_t mx, std::int64_t my, double* out);

  void coarsen();
  OnCoarserGrids on_coarser_grids(const rc_step& step, const Monitor& monitor, bool with_gap);
  // Grid k, 1: the finest of the coarser ones.
  rc_status solve_model(std::size_t k, const rc_step& step, const Monitor& monitor, std::optional<Estimate> estimate,
                        bool with_gap);
  static double difference(const rc_result& fine, const rc_result& coarse, std::int32_t control);
  bool within_goal(const rc_step& step, OnCoarserGrids& found, Monitor& monitor, rc_result& result);
  Blocks blocks_of(std::size_t k) const;
  void count_models(rc_result& result) const;
  rc_status deliver_stopped(const rc_step& step, const OnCoarserGrids& found, const Monitor& monitor, rc_result& result);

  // nearer: from a coarser grid, where there is one; so for the next two.
  std::optional<Answer> at_few_points(const rc_step& step, Monitor& monitor, std::optional<Estimate> nearer);
  std::optional<Estimate> last_estimate(const rc_step& step) const;
  std::optional<Estimate> coarse_estimate(const rc_step& step, const Monitor& monitor);
  std::optional<Answer> solve_few(const rc_step& step, const Choice& choice, Estimate estimate, Monitor& monitor);
  Deflected screened(const Answer& answer, double compression, double margin);
  TrialSet reachable(const Estimate& estimate, double limit) const;
  std::vector<std::int64_t> tiles_under(const Estimate& estimate, const Choice& choice);
  std::vector<std::int64_t> overlapping(const Deflected& found, double compression) const;
  void add_tiles(std::vector<std::int64_t>& tiles, const std::vector<std::int64_t>& points) const;

  Answer at_displacement(const rc_step& step, Monitor& monitor, const std::optional<Estimate>& nearer = std::nullopt);
  Answer at_load(const rc_step& step, Monitor& monitor, std::optional<Estimate> estimate = std::nullopt);
  double approach_estimate(double load, bool warm) const;
  rc_status balance_load(Answer& answer, double load, double shift, double first, Monitor& monitor);

  Pressures pressures_of(const Answer& answer) const;
  rc_status finish(const rc_step& step, Answer&& answer, const Monitor& monitor, rc_result& result);
  bool only_unknowns_matter(const Answer& answer) const;
  Deflected deflected(Answer& answer, bool everywhere);
  // What residuals of gaps are relative to, s [length].
  double residual_scale(const rc_step& step, double compression) const;
  rc_status certify_and_fill(const rc_step& step, const Deflected& answer, double compression, rc_result& result);
  void write_gap(const Deflected& answer, double compression, double* gap) const;
  void deliver(Deflected&& answer, double compression, rc_result& result);
  double fitting_compression(const Deflected& answer) const;
  void name_components(const Answer& answer, rc_result& result);
  void write_note(double compression, rc_result& result);
  double stiffness(const Answer& answer);
  std::int64_t applications() const;

  System system_;
  rc_options options_;
  std::unique_ptr<Team> own_team_;
  const rc_team* team_;
  SurfaceState surface_;
  std::optional<double> tilt_;        // of the current surface, see plane_share; once a note asked for it
  Last last_, before_;                // the last certified step, and the one before it
  std::optional<Spectrum> spectrum_;  // once bounds were asked for
  std::map<std::string, std::unique_ptr<Operator>> operators_;
  std::map<std::int64_t, Level> levels_;  // by number of points
  Goal goal_;
  std::vector<Model> models_;         // the finest first
  bool models_current_ = false;       // they show the current surface
  std::int64_t look_ = 0;             // iterations of a look at the given grid, by the solver for it; 0: this is a solve
  Table table_;                       // the last that a solver asked for
  std::vector<std::string> remarks_;  // of this step's solver
  Choice choice_;                     // the latest of this step
  std::vector<std::string> failed_;   // components that "auto" passes over in this step
  ProgressCallback progress_;
  std::atomic<bool> busy_{false}, cancelled_{false};
  bool warm_ = true;                      // this step may start from earlier ones
  double setup_seconds_ = 0;              // of this step
  std::int64_t applications_before_ = 0;  // this step
};

}  // namespace rc
