// The library's product with H against a padded transform.
#pragma once

#include <cstdint>
#include <vector>

#include "child.h"

namespace bench {

struct ProductsRequest {
  std::vector<std::int64_t> sizes{128, 256, 512, 1024, 2048};
  std::uint64_t seed = 1;
  std::int64_t threads = 1;    // and 1 as well
  double budget = 2;           // seconds for the repeats of a row
  double planning_limit = 30;  // seconds for FFTW_MEASURE of the baseline
};

// Prints progress on stderr and a table on stdout; returns {"products": rows}.
Json run_products(const ProductsRequest& request);

}  // namespace bench
