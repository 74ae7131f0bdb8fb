// Certifies an answer: one fresh product, all that follows from it, and the caller's arrays.
#pragma once

#include <optional>
#include <vector>

#include "contact/attempt.h"
#include "contact/proof/result.h"

namespace rc {

struct Survey;

// A step with its certificate.
struct StepResult {
  Numbers numbers;
  Pressures pressures = {};             // of use only if the step is certified or within its goal
  Overlap overlap = {};                 // the same: of points whose pressure is the hardness
  std::vector<double> deflection = {};  // the same: H p at all points, if the problem keeps it
  KeptAnswer kept = {};                 // the same: pressures that the solver keeps
  Choice by = {};                       // the components that solved
};

// Certifies the answer of a step and writes the caller's arrays at last. answer: default constructed if nothing touches, or if a
// stop came before any answer.
StepResult certify_and_write(const GridProblem& problem, const Target& target, Answer&& answer, const Attempt& attempt,
                             const Outputs& outputs);
// The same for the pressures in outputs.p. compression: by load; without it the one that fits them. Only numbers
// and overlap are set.
StepResult certify_given(const GridProblem& problem, const Target& target, const Attempt& attempt, const Outputs& outputs,
                         std::optional<double> compression = std::nullopt);

// The parts of certify_and_write, for answers that are written in another way.

// H p by the certifying operator: over all points if `everywhere`, else at least over those that the certificate needs. Takes
// the pressures out of the answer, unless the operator has screened all points.
Deflected deflected(const GridProblem& problem, Answer& answer, bool everywhere);
// The same for pressures p at all points of the process [force/length^2] that vanish off this trial set. by: out, the components
// and the operator.
Deflected deflection(const GridProblem& problem, const TrialSet& trial, std::vector<double> p, Answer& by,
                     const Attempt& attempt);
// The compression at which the mean of the gap, weighted by the pressures, vanishes, over points below the hardness; if
// there are none, the least at which all points with pressure touch.
double fitting_compression(const GridProblem& problem, const Deflected& answer);
// Certificate, bounds and all that follows from pressures, product and stiffness. The status is RC_OK or RC_UNCERTIFIED. proven:
// null, or what an interval of the stiffness needs.
Numbers certified_numbers(const GridProblem& problem, const Target& target, const Answer& answer, const Deflected& found,
                          double compression, double stiffness, const Attempt& attempt,
                          std::optional<ProvenSets>* proven = nullptr);
// Over the included points [length], from a survey of all points. overlap: the sum over the points at the hardness, whose gap is
// 0.
double mean_gap(const GridProblem& problem, const Survey& everywhere, double overlap);
Work work_of(const GridProblem& problem, const Monitor& monitor);
void write_arrays(const GridProblem& problem, const Deflected& answer, double compression, const Outputs& outputs);

}  // namespace rc
