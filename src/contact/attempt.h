// One attempt at a step: who watches it, who is at work, and what is remarked.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "contact/choice.h"
#include "contact/monitor.h"

namespace rc {

// The remarks of rc_result.note.
class Remarks {
 public:
  void add(std::string text) { all_.push_back(std::move(text)); }
  // Drops an earlier remark that has the same words before its colon.
  void replace(const std::string& text) {
    const std::string from = text.substr(0, text.find(':'));
    std::erase_if(all_, [&](const std::string& each) { return each.substr(0, each.find(':')) == from; });
    all_.push_back(text);
  }
  const std::vector<std::string>& all() const { return all_; }

 private:
  std::vector<std::string> all_;
};

struct Attempt {
  Monitor& monitor;
  std::vector<std::string> failed = {};  // names of components that "auto" passes over
  Choice choice = {};                    // the components that were chosen last
  bool warm = true;                      // coarser grids may also start from earlier steps
  bool by_solver = false;                // the last failure was a solver's own, not its backend's
  Remarks remarks = {};
};

// Facts of a step that later calls ask for: its explanation and its derivatives.
struct StepOutcome {
  Choice choice = {};
  std::vector<std::string> failed = {};  // components that "auto" passed over
  std::int32_t certified = 0;            // RC_CONTROL_* once the answer on this grid is certified and remembered; 0: it is not
  std::int64_t undecided = -1;           // points of that answer
};

}  // namespace rc
