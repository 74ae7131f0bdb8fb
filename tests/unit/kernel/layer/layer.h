// An elastic layer on a half-space of modulus 1, or on a rigid base.
#pragma once

#include <roughcontact/plugin.h>

#include <numbers>
#include <string>
#include <vector>

#include "support/cmocka.hpp"

namespace layer {

inline constexpr double pi = std::numbers::pi;

struct Layer {
  double thickness, modulus, poisson = 0.3, substrate = 0.3;  // modulus: E1/(1-nu1^2)
  const char *base = "half-space", *interface = "bonded";
};

/** How a flat punch of radius a feels a layer of thickness t = xi a that is little unlike the half-space: its stiffness is
 *  4 a mu / (1 - nu) with mu = mu2 + (mu1 - mu2) I0 and nu = nu2 + (nu1 - nu2) I1. Gao, Chiu & Lee, International Journal of
 * Solids and Structures 29 (1992) 2471, for equal Poisson's ratios where the moduli differ, and the reverse. */
double gao_modulus_share(double xi, double poisson);
double gao_poisson_share(double xi);

/** Coefficients of rows that layer_reference.py has written; errors are divided by the largest coefficient. */
struct Checks {
  int rows = 0, beyond = 0;
  double worst = 0;
};
Checks check_rows(const char* file, double tolerance);

extern const std::vector<CMUnitTest> value_tests, solve_tests;

}  // namespace layer
