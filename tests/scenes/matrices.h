// Symmetric positive definite matrices of several kinds.
#pragma once

#include "random.h"
#include "scene.h"

namespace scenes {

/** [n*n], row by row: factors of both signs, factors of one sign, a decaying line, points of a half-space, an M-matrix, or
 * factors of both signs whose rows and columns have scales of two decades. */
Field random_matrix(std::size_t n, Random& random);

}  // namespace scenes
