// One product of a dilute contact by backends "split" and "fft", in both precisions.
#pragma once

#include <cstdint>
#include <vector>

#include "child.h"

namespace bench {

struct DiluteRequest {
  std::vector<std::int64_t> sizes = {1024, 2048, 4096};
  std::vector<double> contacts = {0.001, 0.01, 0.1};  // shares of the grid in contact
  std::int64_t threads = 2;                           // besides 1
  std::uint64_t seed = 1;
  double budget = 0.3;  // seconds for each series
};

// Prints a table; returns {"dilute": rows}.
Json run_dilute(const DiluteRequest& request);

}  // namespace bench
