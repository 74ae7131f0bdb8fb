// Times y = H[T,T] x through the public plugin interface: a solver that multiplies instead of solving.
#pragma once

#include <string>
#include <vector>

#include "library.h"
#include "stopwatch.h"

namespace bench {

struct ProductSetup {
  std::string backend = "auto";
  std::string planning;  // of backend fft; empty: its default
  std::int64_t threads = 1;
  double budget = 0.3;  // seconds to spend, three products at least
  bool single = false;  // precision
};

// T is the trial set of this step, which must be in displacement control. x is the compenetration over T, positive everywhere;
// the last product goes to y where it is not null.
CallTimes time_products(const rc_system& system, const rc_step& step, const ProductSetup& setup,
                        std::vector<double>* y = nullptr);

}  // namespace bench
