#include "lengths.h"

#include <algorithm>

#include "failure.h"

namespace rc_cuda {

namespace {

constexpr Index longest_axis = Index{1} << 24;
constexpr Index most_values = (Index{1} << 32) - 1;  // in one pass: places are found by 32-bit divisions

// A pass is over the reals of the box's rows, or over the complex numbers of the torus.
Torus checked(Index nx, Index ny, const Torus& torus) {
  const Index complex_rows = std::max(torus.height, 2 * ny);
  if (torus.pitch() > most_values / complex_rows)
    fail(RC_ERR_SHAPE, "products between ", nx, "x", ny, " points take passes over ", torus.pitch(), "x", complex_rows,
         " numbers, more than the limit ", most_values, "; use a smaller domain or another backend (\"fft\")");
  return torus;
}

void check_axes(Index nx, Index ny) {
  if (nx > longest_axis || ny > longest_axis)
    fail(RC_ERR_SHAPE, "a domain of ", nx, "x", ny, " points has an axis longer than the limit ", longest_axis,
         "; use a smaller domain or another backend (\"fft\")");
}

}  // namespace

Index fast_length(Index least) {
  for (Index length = least;; ++length) {
    Index rest = length;
    for (const Index factor : {2, 3, 5, 7})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return length;
  }
}

Torus free_torus(Index nx, Index ny) {
  check_axes(nx, ny);
  return checked(nx, ny, {fast_length(2 * nx - 1), fast_length(2 * ny - 1), false});
}

Torus periodic_torus(Index nx, Index ny) {
  check_axes(nx, ny);
  return checked(nx, ny, {nx, ny, true});
}

}  // namespace rc_cuda
