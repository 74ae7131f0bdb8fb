// What bitwise repeatable results cost.
#pragma once

#include <cstdint>

#include "child.h"
#include "cold_solve.h"

namespace bench {

struct DeterministicRequest {
  ColdScene scene;
  std::int64_t threads = 2;  // against one
  std::int64_t repeats = 7;
};

// Prints a table; returns {"deterministic": rows, ...}, or {"missing": why} where the library has no such option.
Json run_deterministic(const DeterministicRequest& request);

}  // namespace bench
