// A look at all points of the grid for overlap, if only few of them are unknowns.
#pragma once

#include "contact/answer.h"
#include "contact/problem.h"

namespace rc {

// Whether the operator looks itself; else a product over the whole grid shows all points.
bool screens(const Choice& choice);

// H p on the trial set, and at least at the points outside it whose gap is below the margin [length].
Deflected screened(const GridProblem& problem, const Answer& answer, double compression, double margin);

}  // namespace rc
