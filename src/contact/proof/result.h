// Turns an answer on a trial set into a certified result.
#pragma once

#include <optional>

#include "contact/step/answer.h"
#include "contact/step/monitor.h"
#include "contact/workspace.h"

namespace rc {

struct Survey;

struct Finished {
  rc_status status = RC_OK;  // the result's
  Pressures pressures = {};  // of use only if the step is certified or within its goal
  Overlap overlap = {};      // likewise: where the pressures are the hardness
  KeptAnswer kept = {};      // likewise: of the pressures
};

// Certifies the answer of a step, writes the result and at last the caller's arrays. answer: default constructed where nothing
// touches, or where a stop came before any answer.
Finished certified_result(Workspace& work, const rc_step& step, Answer&& answer, const Monitor& monitor, rc_result& result);
// The same for the pressures in result.p or result.p_single. compression: by load; without it the one that fits them. Of what is
// finished only status and overlap are set.
Finished certify_given(Workspace& work, const rc_step& step, const Monitor& monitor, rc_result& result,
                       std::optional<double> compression = std::nullopt);

// The parts of certified_result, for answers that are finished in another way.

// H p by the certifying operator: over all points if `everywhere`, else at least over those that the certificate needs. Takes
// the pressures out of the answer, but where the operator has screened all points.
Deflected deflected(Workspace& work, Answer& answer, bool everywhere);
// The compression at which the mean of the gap, weighted by the pressures, vanishes where these are below the hardness; where
// none is, the least at which all points with pressure touch.
double fitting_compression(const Workspace& work, const Deflected& answer);
// Writes certificate, bounds and all that follows from pressures, product and stiffness. Returns RC_OK or RC_UNCERTIFIED.
rc_status certify_and_fill(Workspace& work, const rc_step& step, const Deflected& answer, double compression, double stiffness,
                           rc_result& result);
// Over the included points [length], from a survey of all points. overlap: the sum over the points at the hardness, whose gap is
// 0.
double mean_gap(const Workspace& work, const Survey& everywhere, double overlap);
void name_components(Workspace& work, const Answer& answer, rc_result& result);
void count_work(const Workspace& work, const Monitor& monitor, rc_result& result);
void write_arrays(const Workspace& work, const Deflected& answer, double compression, const rc_result& result);

}  // namespace rc
