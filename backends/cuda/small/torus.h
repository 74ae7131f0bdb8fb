// H x of a small grid by one block of threads: transforms of complex numbers in place. Frequencies are in the order in which the
// passes leave them, and eigenvalues as well, so that nothing is ever sorted.
//
// Free boundaries: along x the product is computed modulo X^width + 1/i, X the shift by a cell. What goes around comes back times
// a power of i, so that the real part is the product itself, without any padding ("right-angle convolution"): reals are
// multiplied by exp(-i pi x / (2 width)) first. Along y rows of zeros are added.
#pragma once

#include "kernels/products.h"
#include "runtime/device.h"

namespace rc_cuda {

constexpr int most_passes = 16;

// The passes of a transform of so many numbers: what each of them divides by.
struct Passes {
  int length, count;
  int radix[most_passes];
};

template <class R> struct SmallTorus {
  int nx, ny;                          // points of the grid
  Passes x, y;                         // transforms of rows and columns
  const Complex<R>*roots_x, *roots_y;  // exp(-2 pi i k / length)
  const Complex<R>* twist;             // [x.length] what reals are multiplied by; 1 for periodic boundaries
  const R* eigenvalues;                // [y.length][x.length], over the number of points

  RC_ANYWHERE int pitch() const { return x.length | 1; }  // odd: neighbours in a column lie in different banks
  RC_ANYWHERE std::size_t bytes() const {
    return static_cast<std::size_t>(y.length) * static_cast<std::size_t>(pitch()) * sizeof(Complex<R>);
  }
};

template <class R> RC_ANYWHERE Complex<R> operator+(Complex<R> a, Complex<R> b) { return {a.re + b.re, a.im + b.im}; }
template <class R> RC_ANYWHERE Complex<R> operator-(Complex<R> a, Complex<R> b) { return {a.re - b.re, a.im - b.im}; }
// a b, or a times the conjugate of b
template <bool conjugate, class R> RC_ANYWHERE Complex<R> times(Complex<R> a, Complex<R> b) {
  if (conjugate) return {a.re * b.re + a.im * b.im, a.im * b.re - a.re * b.im};
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

// The transform of r numbers. roots: exp(-2 pi i k / r) at k * step.
template <int r, bool inverse, class R> struct Few {
  RC_ANYWHERE static void transform(Complex<R>* a, const Complex<R>* roots, int step) {
    Complex<R> sum[r];
    for (int t = 0; t < r; ++t) {
      sum[t] = a[0];
      for (int q = 1; q < r; ++q) sum[t] = sum[t] + times<inverse>(a[q], roots[q * t % r * step]);
    }
    for (int t = 0; t < r; ++t) a[t] = sum[t];
  }
};
template <bool inverse, class R> struct Few<2, inverse, R> {
  RC_ANYWHERE static void transform(Complex<R>* a, const Complex<R>*, int) {
    const Complex<R> first = a[0];
    a[0] = first + a[1];
    a[1] = first - a[1];
  }
};
template <bool inverse, class R> struct Few<4, inverse, R> {
  RC_ANYWHERE static void transform(Complex<R>* a, const Complex<R>*, int) {
    const Complex<R> s = a[0] + a[2], d = a[0] - a[2], u = a[1] + a[3], v = a[1] - a[3];
    const Complex<R> turned = inverse ? Complex<R>{-v.im, v.re} : Complex<R>{v.im, -v.re};
    a[0] = s + u;
    a[1] = d + turned;
    a[2] = s - u;
    a[3] = d - turned;
  }
};
template <bool inverse, class R> struct Few<8, inverse, R> {
  RC_ANYWHERE static void transform(Complex<R>* a, const Complex<R>* roots, int step) {
    Complex<R> even[4] = {a[0], a[2], a[4], a[6]}, odd[4] = {a[1], a[3], a[5], a[7]};
    Few<4, inverse, R>::transform(even, roots, step);
    Few<4, inverse, R>::transform(odd, roots, step);
    for (int t = 0; t < 4; ++t) {
      const Complex<R> turned = t == 0 ? odd[0] : times<inverse>(odd[t], roots[t * step]);
      a[t] = even[t] + turned;
      a[t + 4] = even[t] - turned;
    }
  }
};

// Lines of n numbers, `step` apart, and `line_step` between the first ones of two lines.
template <class R> struct Lined {
  Complex<R>* data;
  const Complex<R>* roots;
  int n, lines, line_step, step;
};

// One pass: blocks of s numbers into r blocks each, or back.
template <int r, bool inverse, class R> struct Butterfly {
  Lined<R> l;
  int s;
  RC_ANYWHERE void operator()(Index i) const {
    const auto k = static_cast<unsigned>(i), lines = static_cast<unsigned>(l.lines), m = static_cast<unsigned>(s / r);
    const unsigned line = k % lines, within = k / lines, block = within / m, j = within % m;
    const int apart = static_cast<int>(m) * l.step, turn = static_cast<int>(j) * (l.n / s);
    Complex<R>* const at =
        l.data + static_cast<int>(line) * l.line_step + (static_cast<int>(block) * s + static_cast<int>(j)) * l.step;
    Complex<R> a[r];
    a[0] = at[0];
    for (int q = 1; q < r; ++q) {
      a[q] = at[q * apart];
      if (inverse) a[q] = times<true>(a[q], l.roots[q * turn]);
    }
    Few<r, inverse, R>::transform(a, l.roots, l.n / r);
    at[0] = a[0];
    for (int t = 1; t < r; ++t) at[t * apart] = inverse ? a[t] : times<false>(a[t], l.roots[t * turn]);
  }
};

template <bool inverse, class R> RC_CALLED constexpr void transform(Block& block, const Passes& passes, const Lined<R>& l) {
  const auto pass = [&]<int r>(int s) { block.each(static_cast<Index>(l.lines) * (l.n / r), Butterfly<r, inverse, R>{l, s}); };
  int s = inverse ? 1 : l.n;
  for (int k = 0; k < passes.count; ++k) {
    const int radix = passes.radix[inverse ? passes.count - 1 - k : k];
    if (inverse) s *= radix;
    switch (radix) {
      case 2:
        pass.template operator()<2>(s);
        break;
      case 3:
        pass.template operator()<3>(s);
        break;
      case 4:
        pass.template operator()<4>(s);
        break;
      case 5:
        pass.template operator()<5>(s);
        break;
      case 7:
        pass.template operator()<7>(s);
        break;
      default:
        pass.template operator()<8>(s);
        break;
    }
    if (!inverse) s /= radix;
  }
}

template <class R> struct Spread {
  SmallTorus<R> torus;
  const R* x;
  Complex<R>* data;
  RC_ANYWHERE void operator()(Index i) const {
    const Place at = place_of(i, torus.x.length);
    const bool inside = at.column < torus.nx && at.row < torus.ny;
    const R value = inside ? x[at.row * torus.nx + at.column] : R{0};
    const Complex<R> by = torus.twist[at.column];
    data[at.row * torus.pitch() + at.column] = {value * by.re, value * by.im};
  }
};
template <class R> struct Weigh {
  SmallTorus<R> torus;
  Complex<R>* data;
  RC_ANYWHERE void operator()(Index i) const {
    const Place at = place_of(i, torus.x.length);
    Complex<R>& value = data[at.row * torus.pitch() + at.column];
    const R by = torus.eigenvalues[i];
    value = {value.re * by, value.im * by};
  }
};
template <class R> struct Collect {
  SmallTorus<R> torus;
  const Complex<R>* data;
  R* y;
  RC_ANYWHERE void operator()(Index i) const {
    const Place at = place_of(i, torus.nx);
    const Complex<R> value = data[at.row * torus.pitch() + at.column], by = torus.twist[at.column];
    y[i] = value.re * by.re + value.im * by.im;
  }
};

// y = H x, both over the grid. data: torus.bytes().
template <class R>
RC_CALLED constexpr void multiply(Block& block, const SmallTorus<R>& torus, Complex<R>* data, const R* x, R* y) {
  const int width = torus.x.length, height = torus.y.length, pitch = torus.pitch();
  const Index all = static_cast<Index>(width) * height;
  const Lined<R> rows{data, torus.roots_x, width, torus.ny, pitch, 1}, columns{data, torus.roots_y, height, width, 1, pitch};
  block.each(all, Spread<R>{torus, x, data});
  transform<false>(block, torus.x, rows);
  transform<false>(block, torus.y, columns);
  block.each(all, Weigh<R>{torus, data});
  transform<true>(block, torus.y, columns);
  transform<true>(block, torus.x, rows);
  block.each(static_cast<Index>(torus.nx) * torus.ny, Collect<R>{torus, data, y});
}

}  // namespace rc_cuda
