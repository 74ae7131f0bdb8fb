// A set of unknowns made ready and run: chosen for, widened, bound, started, solved.
#pragma once

#include <optional>
#include <vector>

#include "contact/answer.h"
#include "contact/attempt.h"
#include "contact/memory/start.h"
#include "contact/problem.h"
#include "contact/target.h"

namespace rc {

class Trial {
 public:
  // Chooses solver and backend for these unknowns, or takes those given. unit: 1 in dimensionless lengths [length].
  Trial(const GridProblem& problem, const Target& target, TrialSet set, double unit, const Attempt& attempt,
        std::optional<Choice> choice = std::nullopt);

  // Binds the operator. zero_mode: the eigenvalue for the constant vector, see rc_domain.
  void bind(double zero_mode = 0);
  // The pressures to start from: these, and nothing is kept of the answer.
  void start(const Pressures& estimate);
  // The same from earlier steps, or from `nearer` if it is not null. The solver may keep what later steps start from, and the
  // stiffness starts from how pressures have grown.
  void start(const Start& from, const Pressures* nearer);
  // One run of the solver, in the control of the target. first: by load, the dimensionless compression to start from.
  void solve(double first = 0);

  const TrialSet& set() const { return set_; }
  double load() const;                     // dimensionless; 0 if the approach is prescribed
  double scale(double compression) const;  // [length] that residuals are relative to
  Answer answer;

 private:
  const GridProblem& problem_;
  const Target& target_;
  TrialSet set_;
  const Attempt& attempt_;
  bool follows_ = false;
};

}  // namespace rc
