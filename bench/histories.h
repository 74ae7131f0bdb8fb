// A loading history with warm starts against the same steps from zero.
#pragma once

#include <string>
#include <vector>

#include "child.h"

namespace bench {

struct HistoriesRequest {
  std::int64_t levels = 9;  // of midpoint displacement: 2^levels points a side
  std::int64_t steps = 10;
  double hurst = 0.7;
  double tol = 1e-8;
  std::vector<std::uint64_t> seeds{1};
  std::vector<std::string> solvers;  // name, name+key=value+..., either with @backend; empty: every one, and nnls@dense
  std::string backend = "fft";
  std::int64_t threads = 1;
  double time_limit = 120;  // seconds for one step; 0: none
};

// Prints tables; returns {"histories": totals, "steps": each step of each solver}.
Json run_histories(const HistoriesRequest& request);

}  // namespace bench
