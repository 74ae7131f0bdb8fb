// Random contacts of every kind of system, small enough for dense algebra.
#pragma once

#include <random>

#include "support/contact.h"

namespace pairs {

double uniform(std::mt19937& generator);
double normal(std::mt19937& generator);
Field normals(std::size_t n, std::mt19937& generator);

struct RandomProblem {
  Problem problem;
  Pair pair;
  Field matrix;  // of H, row by row: the system's own, where that is a matrix or a product
  std::string name;

  RandomProblem() = default;
  RandomProblem(const RandomProblem&) = delete;
  RandomProblem& operator=(const RandomProblem&) = delete;
};

/** Kernel, boundary, control, sides, cells, mask, hardness, solver and backend from the seed; some points touch, but not all of a
 * periodic grid in approach control. systems: half-spaces alone, or matrices and products, too. */
void make_random(unsigned seed, std::int64_t most, bool half_spaces_alone, RandomProblem& out);

}  // namespace pairs
