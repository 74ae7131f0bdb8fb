// The unknowns of a step, and an answer made ready for a solver on them.
#pragma once

#include <vector>

#include "contact/step/answer.h"
#include "contact/workspace.h"

namespace rc {

// Points that may carry pressure if only points with gap < limit can be in contact; all, if H has negative entries. With ranks:
// every point of this rank's rows.
TrialSet trial_below(double limit, const Workspace& work);
// The whole bounding box, where the solver wants it, products on it cost the same and it is at most twice as large.
TrialSet widened(TrialSet trial, const Choice& choice, const Workspace& work);

// The solver and the backend that the options name, or that "auto" chooses. It notes them in the step's record.
Choice choose_for(const TrialSet& trial, std::int32_t control, Workspace& work);
// An answer with its choice and units, but without operator and pressures.
Answer prepared(const TrialSet& trial, std::int32_t control, double length_unit, Workspace& work);
// The dimensionless u = (datum - gap) / length unit; empty where the solver reads the gap itself.
std::vector<double> compenetrations(const Answer& answer, double datum, const Workspace& work);

// A little less than tol, because the certificate's product rounds differently.
inline double solver_tol(const Workspace& work) { return 0.98 * work.options.real(RC_OPT_TOL); }

}  // namespace rc
