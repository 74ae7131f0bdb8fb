// summary.json: the input and every finished step.
#pragma once

#include <span>
#include <string>

#include "json_text.h"
#include "problem.h"

namespace cli {

class Summary {
 public:
  // The summary of a run of this problem.
  explicit Summary(const Problem& problem);
  // The values of a step, as `step_fields` or an earlier summary has them.
  void add(std::span<const JsonEntry> step);
  // removing: steps of an earlier run, 1 to this number, whose files are about to go; 0: none.
  std::string text(std::size_t removing = 0) const;

 private:
  JsonText document_;
};

}  // namespace cli
