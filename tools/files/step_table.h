// steps.csv: one row a step, with the names of summary.json and their units in the header.
#pragma once

#include <span>
#include <string>

#include "files/json_text.h"

namespace cli {

class StepTable {
 public:
  void add(std::span<const JsonEntry> step);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int rows_ = 0;
};

}  // namespace cli
