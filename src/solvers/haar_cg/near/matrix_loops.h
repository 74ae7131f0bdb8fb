// Loops of Newton's steps, for the best vector instructions of this processor.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rc {

struct MatrixLoops {
  // The matrix is symmetric, with n rows that are `stride` values apart, a multiple of 16; vectors have `stride` values.
  // x = a b
  void (*multiply)(std::size_t n, std::size_t stride, const float* a, const float* b, float* x);
  // x = a b, y = a c
  void (*multiply_two)(std::size_t n, std::size_t stride, const float* a, const float* b, float* x, const float* c, float* y);
  // a += factor v v'
  void (*add_square)(std::size_t n, std::size_t stride, float factor, const float* v, float* a);
  // The numbers, in ascending order, of the values with p > 0 or w < limit. Returns how many; `found` has room for n.
  std::size_t (*list)(std::size_t n, const double* p, const double* w, double limit, std::int64_t* found);
};

MatrixLoops best_matrix_loops();

}  // namespace rc
