// A set of unknowns made ready and run: chosen for, widened, bound, started, solved.
#pragma once

#include <optional>
#include <vector>

#include "contact/answer.h"
#include "contact/attempt.h"
#include "contact/memory/memory.h"
#include "contact/problem.h"
#include "contact/target.h"

namespace rc {

class Trial {
 public:
  // Chooses solver and backend for these unknowns, or takes those given. unit: 1 in dimensionless lengths [length].
  Trial(const GridProblem& problem, const Step& step, TrialSet set, double unit, const Attempt& attempt,
        std::optional<Choice> choice = std::nullopt);

  // Binds the operator. zero_mode: the eigenvalue for the constant vector, see rc_domain.
  void bind(double zero_mode = 0);
  // The pressures to start from. nearer: null, or those to prefer to the step's own and to earlier ones.
  void start(const Memory& memory, const Step& from, const Pressures* nearer);
  // After start(): the solver may keep what later steps start from, and the stiffness starts from how pressures have grown.
  // of_earlier: the start was made of earlier steps.
  void continue_from(const Memory& memory, const Step& from, bool of_earlier);
  // One run of the solver: pressures and approach d, in the step's control. load: dimensionless; tol: as SolverRun has it; datum:
  // the height [length] that u counts from.
  void solve(double load, double tol, double datum, double& d);

  const TrialSet& set() const { return set_; }
  Answer answer;

 private:
  const GridProblem& problem_;
  const Step& step_;
  TrialSet set_;
  const Attempt& attempt_;
  bool follows_ = false;
};

// Points that may carry pressure if only points with gap < limit can be in contact; all, if H has negative entries. By rows:
// every point of this process.
TrialSet trial_below(double limit, const GridProblem& problem);

// A little less than tol, because the certificate's product rounds differently.
inline double solver_tol(const GridProblem& problem) { return 0.98 * problem.options.real(RC_OPT_TOL); }

}  // namespace rc
