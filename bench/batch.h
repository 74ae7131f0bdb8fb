// Many small contacts in one call, with one thread and with several.
#pragma once

#include <cstdint>
#include <string>

#include "child.h"

namespace bench {

struct BatchRequest {
  std::int64_t surfaces = 1000;
  std::int64_t points = 128;  // a side
  std::int64_t steps = 10;    // of each history
  std::int64_t threads = 2;
  double tol = 1e-8;
  std::string solver = "haar-cg", backend = "fft", control = "displacement";
};

// Prints a table; returns {"batch": rows, "scaling": one thread's wall time over that of several, ...}.
Json run_batch(const BatchRequest& request);

}  // namespace bench
