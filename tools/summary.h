// summary.json: the input and every finished step.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "problem.h"
#include "step_record.h"

namespace cli {

class Summary {
 public:
  explicit Summary(const Problem& problem);
  void add(const StepRecord& step);
  std::string text() const;

  // How many steps a summary.json describes; 0 if it is not one of ours.
  static int step_count(const std::string& text);

 private:
  nlohmann::ordered_json document_;
};

}  // namespace cli
