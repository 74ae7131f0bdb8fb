// Random problems on which a solver made for rough surfaces on square grids may go astray: elongated cells and grids, one point
// that carries the load, nearly full contact, thin grids. Seed and number decide everything.
#pragma once

#include <cstdint>
#include <string>

#include "support/contact.h"

namespace scenes {

struct OddScene {
  pairs::Problem problem;
  double tol = 1e-8;
  std::string name;
};

OddScene odd_scene(std::uint64_t seed, std::uint64_t number);

}  // namespace scenes
