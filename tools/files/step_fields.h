// The fields of a step in summary.json and steps.csv, under the same names.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/json_text.h"
#include "solve/step_record.h"

namespace cli {

// The place of every value is its name.
std::vector<JsonEntry> step_fields(const StepRecord& step, const Problem& problem);

// The name of a field alone, whether the value comes from a step or from an earlier summary: "load" of "/steps/0/load".
std::string_view name_of(const JsonEntry& field);

// The unit of a field, "" if it has none.
std::string_view unit_of(std::string_view name);

// steps.csv: one row a step, with the names of summary.json and their units in the header.
class StepTable {
 public:
  void add(std::span<const JsonEntry> step);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int rows_ = 0;
};

}  // namespace cli
