// Partial results of reductions: sums, extremes, conditions.
#pragma once

#include "runtime/index.h"
#include "solvers/haar_cg/iteration/iteration.h"

namespace rc_cuda {

struct Sum {
  double value = 0;
  RC_ANYWHERE void add(const Sum& other) { value += other.value; }
};

struct Any {
  bool value = false;
  RC_ANYWHERE void add(const Any& other) { value = value || other.value; }
};

struct Least {
  double value = 1e300;
  RC_ANYWHERE void add(const Least& other) {
    if (other.value < value) value = other.value;
  }
};

struct Started {
  double highest = -1e300;
  bool warm = false;
  RC_ANYWHERE void add(const Started& other) {
    if (highest < other.highest) highest = other.highest;
    warm = warm || other.warm;
  }
};

struct Measured {
  double largest = 0, load = 0, merit = 0, moment = 0, free_load = 0, free_moment = 0;
  RC_ANYWHERE void add(const Measured& other) {
    // Not a number is not less than anything: it must stay.
    if (!(other.largest <= largest)) largest = other.largest;
    load += other.load;
    merit += other.merit;
    moment += other.moment;
    free_load += other.free_load;
    free_moment += other.free_moment;
  }
};

// (z, q), and the level of w that the trees found: one cell sets it, and it is 0 in all others, so that the sum is it.
struct Preconditioned {
  double overlap = 0, level = 0;
  RC_ANYWHERE void add(const Preconditioned& other) {
    overlap += other.overlap;
    level += other.level;
  }
};

}  // namespace rc_cuda
