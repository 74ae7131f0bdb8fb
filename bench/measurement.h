// One solved step as a record.
#pragma once

#include "child.h"
#include "library.h"

namespace bench {

// Status, certificate, counts and time.
Json record_of(const rc_result& result);

// The fastest of repeated one-shot solves within a budget of seconds, at least one. Each makes its contact anew, so that nothing
// that a backend builds along the way escapes the clock.
struct TimedSolve {
  rc_result result;          // of the fastest
  double setup_seconds = 0;  // its whole call without solving and certifying
  double cpu_seconds = 0;    // its whole call, all threads together: what a busy machine disturbs least
  std::int64_t repeats = 0;
};
TimedSolve time_solve(const rc_system& system, const rc_step& step, const Options& options, double budget, double* p);

}  // namespace bench
