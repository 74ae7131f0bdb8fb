// Time, products and memory against the number of points and the contact area.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "child.h"

namespace bench {

struct ScalingRequest {
  std::vector<std::int64_t> sizes{128, 256, 512, 1024, 2048};
  std::vector<double> areas{0.01, 0.1, 0.4};  // of the grid
  std::uint64_t seed = 1;
  std::int64_t threads = 1;
  double tol = 1e-8;
  std::string solver = "auto", backend = "auto";
  double budget = 2;           // seconds for repeats of a solve and of a product
  double planning_limit = 30;  // seconds for FFTW_MEASURE of the baseline
  bool products_only = false;
};

// Prints progress on stderr and tables on stdout.
Json run_scaling(const ScalingRequest& request);

}  // namespace bench
