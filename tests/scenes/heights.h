// Random surfaces of many kinds.
#pragma once

#include <cstdint>
#include <string>

#include "random.h"
#include "support/harness.h"

namespace scenes {

using pairs::Field;

struct Heights {
  std::string family;
  Field z;  // [nx*ny], of no particular scale
};

/** The generator decides the family and every height. */
Heights random_heights(std::int64_t nx, std::int64_t ny, Random& random);

}  // namespace scenes
