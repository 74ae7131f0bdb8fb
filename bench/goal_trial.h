// Option accuracy on surfaces that are made to mislead it: how often an answer without a solve of the whole grid is beyond its
// goal.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

struct GoalTrialRequest {
  std::vector<std::string> surfaces;  // empty: all
  std::int64_t points = 160;          // a side, about
  std::int64_t first = 1, last = 20;  // seeds
  std::vector<double> goals{0.1, 0.03, 0.01};
  bool times = false;  // the whole grid's, too
  std::int64_t threads = 1;
  std::string file;  // results, in JSON; "": none
};

// Prints a table by surface and, last, the rate of all.
void run_goal_trial(const GoalTrialRequest& request);

}  // namespace bench
