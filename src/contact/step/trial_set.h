// The unknowns of a step, and an answer made ready for a solver on them.
#pragma once

#include <vector>

#include "contact/answer.h"
#include "contact/workspace.h"

namespace rc {

// Points that may carry pressure where the gap is below the limit.
TrialSet trial_below(double limit, const Workspace& work);
// A solver that takes every point of a box for an unknown needs no index, where products cost the same.
TrialSet widened(TrialSet trial, const Choice& choice, const Workspace& work);

// The solver and the backend that the options name, or that "auto" stands for. Noted in the step's record.
Choice choose_for(const TrialSet& trial, std::int32_t control, Workspace& work);
// An answer with its choice and units, without operator and pressures.
Answer prepared(const TrialSet& trial, std::int32_t control, double length_unit, Workspace& work);
// u, dimensionless; none where the solver takes it from the gap. datum: the approach that it is counted from.
std::vector<double> compenetrations(const Answer& answer, double datum, const Workspace& work);

// A little less than is certified: the certificate's product rounds in its own way.
inline double solver_tol(const Workspace& work) { return 0.98 * work.options.real(RC_OPT_TOL); }

}  // namespace rc
