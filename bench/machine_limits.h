// What memory and in-cache transforms allow on this machine, and what products and solver passes make of it.
#pragma once

#include <cstdint>
#include <vector>

#include "child.h"

namespace bench {

struct LimitsRequest {
  std::vector<std::int64_t> sizes{1024, 2048, 4096};  // points a side, powers of two
  std::int64_t threads = 2;                           // and 1
  double budget = 1;                                  // seconds for each measurement
  bool quick = false;                                 // small arrays
};

// Prints tables; returns {"bandwidth": rows, "transforms": rows, "products": rows, "passes": rows}.
Json run_limits(const LimitsRequest& request);

}  // namespace bench
