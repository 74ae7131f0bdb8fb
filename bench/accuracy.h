// Speed against accuracy: solvers on every backend they can run on, at a sequence of tolerances, against the truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "child.h"

namespace bench {

struct AccuracyRequest {
  std::vector<std::string> scenes{"hertz", "self-affine-256", "self-affine-512"};
  std::vector<std::string> solvers{"haar-cg", "nnls", "polonsky-keer"};
  std::vector<int> digits{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};  // tolerances 10^-digits
  std::int64_t threads = 1;
  double budget = 0.5;                // seconds for repeats of a solve
  double time_limit = 0;              // seconds for one solve, 0: none; looser tolerances only once it is hit
  std::int64_t most_factored = 4000;  // candidates up to which factoring backends run
};

Json run_accuracy(const AccuracyRequest& request);

}  // namespace bench
