// Times y = H[T,T] x through the public plugin interface: a solver that multiplies instead of solving.
#pragma once

#include <vector>

#include "library.h"
#include "stopwatch.h"

namespace bench {

struct ProductSetup {
  const char* backend = "auto";
  const char* planning = "";  // of backend fft; empty: its default
  int threads = 1;
  double budget = 0.3;  // seconds to spend, three products at least
  bool single = false;  // precision
  double share = 1;     // of the trial set that carries pressure, the deepest points
};

struct ProductTimes {
  CallTimes calls;
  double first = 0;  // seconds of the first product, with the set-up
  std::int64_t points = 0, contacts = 0;
  std::vector<double> y;  // the last product
};

// T is the trial set of this gap and approach. x is the compenetration over T, and with a share below 1 its excess over what the
// other points have.
ProductTimes time_products(const rc_system& system, const double* gap, double approach, const ProductSetup& setup);

}  // namespace bench
