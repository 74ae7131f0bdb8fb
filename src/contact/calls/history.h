// A loading history on one contact, step after step.
#pragma once

#include <cstdint>

#include "contact/calls/contact.h"
#include "contact/calls/step_outputs.h"

namespace rc {

// Outputs that a history wants of every step. All ranks have the same.
struct HistoryWants {
  bool virgin = false;
  bool shown_gap = false, gap = false;  // the caller's function gets it; it is computed at all points
  ColumnWants columns{};
};
HistoryWants wants_of(const rc_history& history);

// `completed` counts the steps whose outputs are written. Throws Error with the step's number.
rc_status solve_history(Contact& contact, const rc_history& history, const HistoryWants& wants, std::int64_t& completed);

}  // namespace rc
