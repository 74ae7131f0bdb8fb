// Small discrete Fourier transforms of many sequences side by side: one sequence to a lane of a vector register. Header of
// passes.cpp alone.
#pragma once

#include <cstdint>
#include <numbers>
#include <utility>

#include "sequences.h"

// Inlined into functions that are compiled for one instruction set each.
#define RC_FFT_INLINE [[gnu::always_inline]] inline
#define RC_FFT_INLINE_LAMBDA __attribute__((always_inline))

namespace rc_fft {

template <class Scalar, int Bytes> struct Vector {
  using Real = Scalar;
  typedef Real Type __attribute__((vector_size(Bytes), may_alias));
  static constexpr int lanes = Bytes / static_cast<int>(sizeof(Real));
};

// As many complex numbers as a register of vector type V has lanes.
template <class V> struct Complex { typename V::Type re, im; };

template <class V> RC_FFT_INLINE void add(const Complex<V>& a, const Complex<V>& b, Complex<V>& out) {
  const Complex<V> sum{a.re + b.re, a.im + b.im};
  out = sum;
}

template <class V> RC_FFT_INLINE void subtract(const Complex<V>& a, const Complex<V>& b, Complex<V>& out) {
  const Complex<V> difference{a.re - b.re, a.im - b.im};
  out = difference;
}

template <class V> RC_FFT_INLINE void multiply(Complex<V>& a, typename V::Real re, typename V::Real im) {
  const Complex<V> product{a.re * re - a.im * im, a.re * im + a.im * re};
  a = product;
}

// z -> i conj(z). Backward = exchange, forward, exchange; and products with a factor keep that factor in between.
template <class V> RC_FFT_INLINE void exchange(Complex<V>& a) {
  const Complex<V> exchanged{a.im, a.re};
  a = exchanged;
}

// x[k] <- sum over j of x[j] exp(-2 pi i jk/R).
template <int R> struct Dft {
  // R is odd. With x[j] + x[R-j] and x[j] - x[R-j] half of the products drop out.
  template <class V> RC_FFT_INLINE static void run(Complex<V>* x) {
    using Real = typename V::Real;
    constexpr int half = R / 2;
    constexpr Turns<Real> turn{};
    Complex<V> sum[half + 1], difference[half + 1];
    for (int j = 1; j <= half; ++j) {
      add(x[j], x[R - j], sum[j]);
      subtract(x[j], x[R - j], difference[j]);
    }
    const Complex<V> first = x[0];
    for (int j = 1; j <= half; ++j) add(x[0], sum[j], x[0]);
    for (int k = 1; k <= half; ++k) {
      Complex<V> even = first, odd{};
      for (int j = 1; j <= half; ++j) {
        const Real cosine = turn.cosine[j * k % R], sine = turn.sine[j * k % R];
        even.re += sum[j].re * cosine;
        even.im += sum[j].im * cosine;
        odd.re += difference[j].im * sine;
        odd.im -= difference[j].re * sine;
      }
      add(even, odd, x[k]);
      subtract(even, odd, x[R - k]);
    }
  }

 private:
  template <class Real> struct Turns {
    constexpr Turns() {
      constexpr long double values[][4] = {{1, 0.623489801858733530525L, -0.222520933956314404289L, -0.900968867902419126236L},
                                           {0, 0.781831482468029808708L, 0.974927912181823607018L, 0.433883739117558120475L},
                                           {1, 0.309016994374947424102L, -0.809016994374947424102L, 0},
                                           {0, 0.951056516295153572116L, 0.587785252292473129169L, 0},
                                           {1, -0.5L, 0, 0},
                                           {0, 0.866025403784438646764L, 0, 0}};
      constexpr int row = R == 7 ? 0 : R == 5 ? 2 : 4;
      for (int j = 0; j < R; ++j) {
        cosine[j] = static_cast<Real>(values[row][j <= R / 2 ? j : R - j]);
        sine[j] = static_cast<Real>(j <= R / 2 ? values[row + 1][j] : -values[row + 1][R - j]);
      }
    }
    Real cosine[R]{}, sine[R]{};
  };
};

template <> struct Dft<1> {
  template <class V> RC_FFT_INLINE static void run(Complex<V>*) {}
};

template <> struct Dft<2> {
  template <class V> RC_FFT_INLINE static void run(Complex<V>* x) {
    const Complex<V> first = x[0];
    add(first, x[1], x[0]);
    subtract(first, x[1], x[1]);
  }
};

template <> struct Dft<4> {
  template <class V> RC_FFT_INLINE static void run(Complex<V>* x) {
    Complex<V> even[2] = {x[0], x[2]}, odd[2] = {x[1], x[3]};
    Dft<2>::run(even);
    Dft<2>::run(odd);
    join(even, odd, x);
  }
  // The transform of a sequence whose second half is zero.
  template <class V> RC_FFT_INLINE static void run_half(Complex<V>* x) {
    const Complex<V> even[2] = {x[0], x[0]}, odd[2] = {x[1], x[1]};
    join(even, odd, x);
  }

 private:
  template <class V> RC_FFT_INLINE static void join(const Complex<V>* even, const Complex<V>* odd, Complex<V>* x) {
    add(even[0], odd[0], x[0]);
    subtract(even[0], odd[0], x[2]);
    const Complex<V> turned{odd[1].im, -odd[1].re};
    add(even[1], turned, x[1]);
    subtract(even[1], turned, x[3]);
  }
};

template <> struct Dft<8> {
  template <class V> RC_FFT_INLINE static void run(Complex<V>* x) {
    constexpr typename V::Real h = std::numbers::sqrt2_v<typename V::Real> / 2;
    Complex<V> even[4] = {x[0], x[2], x[4], x[6]}, odd[4] = {x[1], x[3], x[5], x[7]};
    Dft<4>::run(even);
    Dft<4>::run(odd);
    const Complex<V> turned[4] = {odd[0],
                                  {(odd[1].re + odd[1].im) * h, (odd[1].im - odd[1].re) * h},
                                  {odd[2].im, -odd[2].re},
                                  {(odd[3].im - odd[3].re) * h, -(odd[3].re + odd[3].im) * h}};
    for (int k = 0; k < 4; ++k) {
      add(even[k], turned[k], x[k]);
      subtract(even[k], turned[k], x[k + 4]);
    }
  }
};

template <class V> RC_FFT_INLINE void load(const typename V::Real* row, Complex<V>& z) {
  z.re = *reinterpret_cast<const typename V::Type*>(row);
  z.im = *reinterpret_cast<const typename V::Type*>(row + width<typename V::Real>);
}
template <class V> RC_FFT_INLINE void store(typename V::Real* row, const Complex<V>& z) {
  *reinterpret_cast<typename V::Type*>(row) = z.re;
  *reinterpret_cast<typename V::Type*>(row + width<typename V::Real>) = z.im;
}

// Exchanges v[i][j] and v[j][i], by swapping blocks of half the size off the diagonal. I counts the lanes.
template <class V, int Half, int... I> RC_FFT_INLINE void swap_blocks(typename V::Type* v, std::integer_sequence<int, I...>) {
  for (int i = 0; i < V::lanes; ++i) {
    if ((i & Half) != 0) continue;
    const typename V::Type a = v[i], b = v[i + Half];
    v[i] = __builtin_shufflevector(a, b, ((I & Half) != 0 ? V::lanes + I - Half : I)...);
    v[i + Half] = __builtin_shufflevector(a, b, ((I & Half) != 0 ? V::lanes + I : I + Half)...);
  }
}
template <class V, int Half = V::lanes / 2> RC_FFT_INLINE void transpose(typename V::Type* v) {
  if constexpr (Half > 0) {
    swap_blocks<V, Half>(v, std::make_integer_sequence<int, V::lanes>{});
    transpose<V, Half / 2>(v);
  }
}

}  // namespace rc_fft
