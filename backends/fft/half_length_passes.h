// The pass between the transforms of a real line and of its complex form, for one width of the vector registers.
#pragma once

#include <cstring>
#include <utility>

#include "columns.h"
#include "half_length.h"
#include "lanes.h"

namespace rc_fft {

template <class Real, int Bytes> struct HalfLengthPass {
  using V = Vector<Real, Bytes>;
  static constexpr int lanes = V::lanes;
  using Lanes = std::make_integer_sequence<int, lanes>;
  using Plain = typename V::Type;

  // Loads and stores at any address.
  RC_FFT_INLINE static void get(const Real* p, Plain& v) { std::memcpy(&v, p, Bytes); }
  RC_FFT_INLINE static void put(Real* p, const Plain& v) { std::memcpy(p, &v, Bytes); }

  // Load and store `lanes` complex numbers, in their order or from the last to the first.
  static constexpr int place(int i, bool back) { return back ? lanes - 1 - i : i; }
  template <bool Back, int... I> RC_FFT_INLINE static void load(const Real* p, Complex<V>& z, std::integer_sequence<int, I...>) {
    Plain a, b;
    get(p, a);
    get(p + lanes, b);
    z.re = __builtin_shufflevector(a, b, (2 * place(I, Back))...);
    z.im = __builtin_shufflevector(a, b, (2 * place(I, Back) + 1)...);
  }
  template <bool Back, int... I> RC_FFT_INLINE static void store(Real* p, const Complex<V>& z, std::integer_sequence<int, I...>) {
    put(p, __builtin_shufflevector(z.re, z.im, (place(I / 2, Back) + I % 2 * lanes)...));
    put(p + lanes, __builtin_shufflevector(z.re, z.im, (place(lanes / 2 + I / 2, Back) + I % 2 * lanes)...));
  }

  // The elements k and M - k; `mirrored` is the latter before, and after.
  template <bool Back, class Number>
  RC_FFT_INLINE static void join(Number& re, Number& im, Number& mirrored_re, Number& mirrored_im, const Number& turn_re,
                                 const Number& turn_im) {
    const Number sum_re = re + mirrored_re, sum_im = im - mirrored_im;
    const Number difference_re = re - mirrored_re, difference_im = im + mirrored_im;
    const Number factor_im = Back ? -turn_im : turn_im;
    const Number turned_re = difference_re * turn_re - difference_im * factor_im;
    const Number turned_im = difference_re * factor_im + difference_im * turn_re;
    re = sum_re + turned_re;
    im = sum_im + turned_im;
    mirrored_re = sum_re - turned_re;
    mirrored_im = turned_im - sum_im;
  }

  template <bool Back> RC_FFT_INLINE static void run(const HalfLength<Real>& plan, std::complex<Real>* row) {
    const std::int64_t half = plan.half();
    Real* const z = reinterpret_cast<Real*>(row);
    const auto one = [&](std::int64_t k, std::int64_t mirror) {
      Real re = z[2 * k], im = z[2 * k + 1], mirrored_re = z[2 * mirror], mirrored_im = z[2 * mirror + 1];
      join<Back>(re, im, mirrored_re, mirrored_im, plan.re()[k], plan.im()[k]);
      z[2 * mirror] = mirrored_re;
      z[2 * mirror + 1] = mirrored_im;
      z[2 * k] = re;
      z[2 * k + 1] = im;
    };
    if (!Back) {
      z[2 * half] = z[0];
      z[2 * half + 1] = z[1];
    }
    one(0, half);
    std::int64_t k = 1;
    for (; k + lanes <= (half + 1) / 2; k += lanes) {
      Complex<V> a, b;
      Real* const left = z + 2 * k;
      Real* const right = z + 2 * (half - k - lanes + 1);
      load<false>(left, a, Lanes{});
      load<true>(right, b, Lanes{});
      Plain turn_re, turn_im;
      get(plan.re() + k, turn_re);
      get(plan.im() + k, turn_im);
      join<Back, Plain>(a.re, a.im, b.re, b.im, turn_re, turn_im);
      store<false>(left, a, Lanes{});
      store<true>(right, b, Lanes{});
    }
    for (; k <= half / 2; ++k) one(k, half - k);
  }
};

template <class Real, int Bytes, bool Back> void join_halves(const HalfLength<Real>& plan, std::complex<Real>* row) {
  HalfLengthPass<Real, Bytes>::template run<Back>(plan, row);
}

#ifdef RC_HAS_WIDER_VECTORS
template <class Real, bool Back>
[[gnu::target("avx2,fma")]] void join_halves_avx2(const HalfLength<Real>& plan, std::complex<Real>* row) {
  HalfLengthPass<Real, 32>::template run<Back>(plan, row);
}
template <class Real, bool Back>
[[gnu::target("avx512f,avx512dq,fma")]] void join_halves_avx512(const HalfLength<Real>& plan, std::complex<Real>* row) {
  HalfLengthPass<Real, 64>::template run<Back>(plan, row);
}
#endif

}  // namespace rc_fft
