// A solve on an idle machine, and while every core is loaded by something else.
#pragma once

#include <cstdint>
#include <vector>

#include "child.h"
#include "cold_solve.h"

namespace bench {

struct BusyRequest {
  ColdScene scene;
  std::vector<std::int64_t> threads{1, 2};
  std::int64_t others = 2;  // processes at full load
  std::int64_t repeats = 7;
};

// Prints a table; returns {"busy": rows}.
Json run_busy(const BusyRequest& request);

}  // namespace bench
