// Dilute contacts: one product by backends "split" and "fft" in both precisions, and solves.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "child.h"

namespace bench {

struct DiluteRequest {
  std::vector<std::int64_t> sizes = {1024, 2048, 4096};
  std::vector<double> contacts = {0.0004, 0.001, 0.01, 0.1};  // shares of the grid in contact
  std::int64_t threads = 2;                                   // of solves; of products besides 1
  std::uint64_t seed = 1;
  double budget = 0.3;  // seconds for each series
  std::vector<std::string> controls = {"displacement", "load"};
  std::vector<double> tolerances = {1e-8, 1e-4};
  std::int64_t largest_full = 4096;  // points a side up to which solves go over the whole grid as well
  bool products = true, solves = true;
};

// Prints tables; returns {"dilute": rows of products, "solves": rows}.
Json run_dilute(const DiluteRequest& request);

}  // namespace bench
