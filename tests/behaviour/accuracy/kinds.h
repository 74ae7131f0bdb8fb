// Kinds of surfaces for statistics of option accuracy: rough ones, and shapes with floors, grains and steps.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes.h"

namespace accuracy {

/** One surface of each kind, pressed to a depth that the seed draws. */
struct Kind {
  std::string name;
  Problem (*make)(unsigned seed);
};

const std::vector<Kind>& kinds();

}  // namespace accuracy
