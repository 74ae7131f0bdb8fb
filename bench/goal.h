// Option accuracy: how often the goal is met, on which grids, and what it saves.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "child.h"

namespace bench {

struct GoalRequest {
  std::vector<std::string> scenes;  // of the comparison of speed with accuracy; empty: all
  std::string surfaces;             // folder with measured ones, "": none
  std::int64_t points = 512;        // a side, of scenes that are not measured
  std::int64_t seeds = 6;           // of random scenes
  std::vector<double> contacts{1, 10, 40, 90};
  std::vector<double> goals{0.1, 0.03, 0.01, 0.003};
  std::int64_t threads = 1;
  std::string file;  // results, in JSON; "": none
};

// Prints a table for each quantity; goes on where a file of results stopped.
void run_goal(const GoalRequest& request);

}  // namespace bench
