// Time, products and memory of cold solves against the number of points, the contact area and the control.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "child.h"

namespace bench {

struct ScalingRequest {
  std::vector<std::int64_t> sizes{128, 256, 512, 1024, 2048};
  std::vector<double> areas{0.01, 0.1, 0.4};  // of the grid
  std::vector<std::string> controls{"displacement", "load"};
  std::uint64_t seed = 1;
  std::int64_t threads = 1;
  double tol = 1e-8;
  std::string precision = "mixed";  // or "single": option fft.precision
  std::string solver = "auto", backend = "auto";
  double budget = 2;      // seconds for repeats of a solve and of a product
  double time_limit = 0;  // seconds after which no row begins; 0: none
  std::string file;       // JSON that is read at first and written after every row
};

// Rows that the file has from the same library are not measured again. Prints progress on stderr and a table on stdout.
void run_scaling(const ScalingRequest& request);

}  // namespace bench
