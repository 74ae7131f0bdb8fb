// An earlier run, as its summary.json describes it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "files/json_text.h"

namespace cli {

struct EarlierStep {
  std::string status;
  double approach = std::numeric_limits<double>::quiet_NaN(), load = approach;
  std::vector<JsonEntry> fields;  // all fields of the step

  bool certified() const { return status == "RC_OK" || status == "RC_WITHIN_GOAL"; }
  bool complete() const { return !status.empty() && (!certified() || (std::isfinite(approach) && std::isfinite(load))); }
};

struct EarlierRun {
  std::vector<JsonEntry> input;  // without file, targets and times
  std::vector<double> targets, times;
  std::vector<EarlierStep> steps;
  std::size_t removing = 0;  // steps of a still earlier run whose files it was about to remove

  // Files of steps 1 to this number belong to this run, whether or not they were written.
  std::size_t own_steps() const { return std::max({targets.size(), steps.size(), removing}); }
};

// Empty if the text is not from our summary.json.
std::optional<EarlierRun> read_earlier_run(const std::string& text);

// Throws an Error unless a run with the summary `now` continues the earlier one: the same surface, system and options, and the
// same targets for the first `steps` steps. `name`: of the earlier summary, for the message.
void check_continues(const EarlierRun& earlier, const EarlierRun& now, std::size_t steps, const std::string& name);

}  // namespace cli
