// From an answer on a trial set to a certified result.
#pragma once

#include "contact/answer.h"
#include "contact/step/monitor.h"
#include "contact/workspace.h"

namespace rc {

struct Finished {
  rc_status status = RC_OK;  // the result's
  Pressures pressures;       // of a step that is certified or within its goal; else of no use
};

// Certifies the answer of a step, writes the result and last the caller's arrays. answer: a default one where nothing touches or
// a stop came before any answer.
Finished certified_result(Workspace& work, const rc_step& step, Answer&& answer, const Monitor& monitor, rc_result& result);
// The same of the pressures in result.p.
rc_status certify_given(Workspace& work, const rc_step& step, const Monitor& monitor, rc_result& result);

// Its parts, for answers that are finished another way.

// H p by the certifying operator: over all points, or where not `everywhere` over those that matter.
Deflected deflected(Workspace& work, Answer& answer, bool everywhere);
// The compression at which the mean of the gap, weighted by the pressures, vanishes.
double fitting_compression(const Workspace& work, const Deflected& answer);
// Certificate, bounds, and all of the result that follows from pressures and product. RC_OK or RC_UNCERTIFIED.
rc_status certify_and_fill(Workspace& work, const rc_step& step, const Deflected& answer, double compression, rc_result& result);
void name_components(Workspace& work, const Answer& answer, rc_result& result);
void count_work(const Workspace& work, const Monitor& monitor, rc_result& result);
void write_arrays(const Workspace& work, const Deflected& answer, double compression, const rc_result& result);

}  // namespace rc
