// Random problems and pressures that are wrong in various ways.
#pragma once

#include <random>

#include "support/contact.h"

namespace pairs {

struct Scene {
  Problem problem;
  std::string name;
  Field matrix;  // what problem.system.dense points to, for a caller's matrix
};

/** Any kernel, boundary, aspect ratio, mask, gap and approach; grids of up to `most` by `most` points. */
Scene random_scene(std::mt19937& generator, std::int64_t most);

/** Off by about `size` times the largest pressure. Negative entries only in some. */
Field perturbed(const Problem& problem, const Field& p, double size, std::mt19937& generator);

double uniform(std::mt19937& generator);

}  // namespace pairs
