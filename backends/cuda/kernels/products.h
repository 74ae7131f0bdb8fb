// H x by a convolution, around the transforms. Rows of the transformed grid are length/2 + 1 complex numbers, `pitch`; before and
// after the transforms of rows they hold 2 pitch reals.
#pragma once

#include "runtime/index.h"

namespace rc_cuda {

// Aligned, so that both parts are loaded and stored in one access.
template <class R> struct alignas(2 * sizeof(R)) Complex { R re, im; };

// A box of nx columns into rows of reals, zeros behind it. The first row is the box's.
template <class R> struct Pad {
  const R* from;
  R* rows;
  Index nx, first_column, pitch;
  RC_ANYWHERE void operator()(Index i) const {
    const Place at = place_of(i, 2 * pitch);
    const Index x = at.column - first_column;
    rows[i] = x >= 0 && x < nx ? from[at.row * nx + x] : R{0};
  }
};

// By the eigenvalues; the mean's has one more part.
template <class R> struct Times {
  Complex<R>* data;
  const R* eigenvalues;  // rows 0 .. height/2, of `pitch` each
  Index pitch, height;
  R of_mean;
  RC_ANYWHERE void operator()(Index i) const {
    const Place at = place_of(i, pitch);
    const Index row = 2 * at.row > height ? height - at.row : at.row;
    const R by = eigenvalues[row * pitch + at.column] + (i == 0 ? of_mean : R{0});
    data[i] = {data[i].re * by, data[i].im * by};
  }
};

template <class R> struct Crop {
  const R* rows;
  R* to;
  Index nx, pitch;
  RC_ANYWHERE void operator()(Index i) const {
    const Place at = place_of(i, nx);
    to[i] = rows[at.row * 2 * pitch + at.column];
  }
};

// Some rows of the table of coefficients onto the torus: at their offsets, and at the negative ones.
struct Wrap {
  const double* k;  // rows first_row .. of nx coefficients
  double* rows;
  Index nx, first_row, width, height;  // of the torus
  bool periodic;                       // the table covers the torus
  RC_ANYWHERE void operator()(Index i) const {
    const Index pitch = 2 * (width / 2 + 1), y = i / nx + first_row, x = i % nx;
    rows[y * pitch + x] = k[i];
    if (periodic) return;
    const Index left = x > 0 ? width - x : 0, above = y > 0 ? height - y : 0;
    rows[y * pitch + left] = k[i];
    rows[above * pitch + x] = k[i];
    rows[above * pitch + left] = k[i];
  }
};

// Eigenvalues are real, because coefficients are even.
template <class R> struct Keep {
  const Complex<double>* from;
  R* to;
  double by;
  RC_ANYWHERE void operator()(Index i) const { to[i] = static_cast<R>(from[i].re * by); }
};

// A vector of the unknowns into a box that is 0 elsewhere, and back.
template <class R> struct Scatter {
  const R* from;
  const Index* place;
  R* to;
  RC_ANYWHERE void operator()(Index i) const { to[place[i]] = from[i]; }
};
template <class R> struct Gather {
  const R* from;
  const Index* place;
  R* to;
  RC_ANYWHERE void operator()(Index i) const { to[i] = from[place[i]]; }
};

}  // namespace rc_cuda
