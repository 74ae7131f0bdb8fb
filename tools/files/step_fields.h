// What summary.json and steps.csv say of a step, under the same names.
#pragma once

#include <string_view>
#include <vector>

#include "files/json_text.h"
#include "solve/step_record.h"

namespace cli {

// The place of every value is its name. yields: whether the bodies have a hardness.
std::vector<JsonEntry> step_fields(const StepRecord& step, bool yields);

// The name of a field alone, whether the value comes from a step or from an earlier summary: "load" of "/steps/0/load".
std::string_view name_of(const JsonEntry& field);

// The unit of a field, "" if it has none.
std::string_view unit_of(std::string_view name);

}  // namespace cli
