// An elastic layer on a half-space of modulus 1, by the example's kernel.
#pragma once

#include <roughcontact/plugin.h>

#include <string>
#include <vector>

#include "support/cmocka.hpp"

extern "C" rc_status rc_builtin_layer(const rc_host* host, const rc_plugin** out);

namespace layer {

struct Layer {
  double thickness, modulus, poisson = 0.3, substrate = 0.3;  // modulus: E1/(1-nu1^2)
};

extern const std::vector<CMUnitTest> value_tests, solve_tests;

}  // namespace layer
