// The field's standard method as it was published: I. A. Polonsky, L. M. Keer, "A numerical method for solving rough contact
// problems based on the multi-level multi-summation and conjugate gradient techniques", Wear 231 (1999) 206-219, section 3.2,
// with two products an iteration, here by a padded transform.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "padded_product.h"

namespace bench {

struct StandardProblem {
  std::int64_t n = 0;           // cells a side of the unit square; contact modulus 1
  const double* gap = nullptr;  // [n*n]
  bool load_control = true;
  double target = 0;  // load, or approach
};

// What a caller may look at after each product with p, while the clock stands still.
struct StandardState {
  std::int64_t iteration, products;
  const std::vector<double>& p;
  double residual;  // the largest of dual and complementarity residuals, as roughcontact's certificate defines them
  double seconds;   // of the iterations so far
};

// Goes on until `look` returns false or after `most` iterations. The stopping test is the caller's: it costs this method nothing.
void polonsky_keer(const StandardProblem& problem, PaddedProduct& product, int threads, std::int64_t most,
                   const std::function<bool(const StandardState&)>& look);

}  // namespace bench
