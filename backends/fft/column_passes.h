// The passes of a column product, for one width of the vector registers.
#pragma once

#include <utility>

#include "columns.h"
#include "lanes.h"

namespace rc_fft {

template <class Real, int Bytes> struct Passes {
  using V = Vector<Real, Bytes>;
  static constexpr int lanes = V::lanes;
  static constexpr int width = static_cast<int>(columns_per_block<Real>);  // columns
  static constexpr std::int64_t row = 2 * width;                           // reals in a row of the scratch
  using Lanes = std::make_integer_sequence<int, lanes>;

  // The first pass: reads the rows of the work array and splits the columns into R parts. Half: rows of the second half are 0.
  template <int R, bool Half> RC_FFT_INLINE static void read(const ColumnProduct<Real>& plan, const ColumnBlock<Real>& block) {
    alignas(alignment) static constexpr Real zeros[row] = {};
    constexpr std::int64_t ahead = 8;
    const std::int64_t part = plan.length() / R;
    const Real* const rows = reinterpret_cast<const Real*>(block.rows);
    const std::int64_t stride = 2 * block.stride;
    for (std::int64_t i = 0; i < part; ++i) {
      const Real* from[R];
      for (int q = 0; q < (Half ? R / 2 : R); ++q) {
        const std::int64_t source = i + q * part - block.first_source;
        from[q] = source >= 0 && source < block.sources ? rows + (i + q * part) * stride : zeros;
        if (source >= 0 && source + ahead < block.sources) {
          __builtin_prefetch(from[q] + ahead * stride);
          __builtin_prefetch(from[q] + ahead * stride + width);
        }
      }
      const Real* const twiddle = plan.twiddles(0) + (part > 1 ? 2 * (R - 1) * i : 0);
      Real* const to = reinterpret_cast<Real*>(block.scratch) + i * row;
      for (int c = 0; c < width; c += lanes) {
        Complex<V> x[R];
        for (int q = 0; q < (Half ? R / 2 : R); ++q) load_pairs(from[q] + 2 * c, x[q], Lanes{});
        if constexpr (Half)
          Dft<R>::run_half(x);
        else
          Dft<R>::run(x);
        for (int q = 0; q < R; ++q) {
          if (q > 0 && part > 1) multiply(x[q], twiddle[2 * q - 2], twiddle[2 * q - 1]);
          store(to + q * part * row + c, x[q]);
        }
      }
    }
  }

  // The first pass backward, into the rows of the work array; rows that are not wanted go to the scratch's last one.
  template <int R, bool Half> RC_FFT_INLINE static void write(const ColumnProduct<Real>& plan, const ColumnBlock<Real>& block) {
    const std::int64_t part = plan.length() / R;
    Real* const rows = reinterpret_cast<Real*>(block.rows);
    Real* const scratch = reinterpret_cast<Real*>(block.scratch);
    for (std::int64_t i = 0; i < part; ++i) {
      Real* to[R];
      for (int q = 0; q < (Half ? R / 2 : R); ++q)
        to[q] = i + q * part < block.targets ? rows + (i + q * part) * 2 * block.stride : scratch + plan.length() * row;
      const Real* const twiddle = plan.twiddles(0) + (part > 1 ? 2 * (R - 1) * i : 0);
      const Real* const from = scratch + i * row;
      for (int c = 0; c < width; c += lanes) {
        Complex<V> x[R];
        for (int q = 0; q < R; ++q) {
          load(from + q * part * row + c, x[q]);
          exchange(x[q]);
          if (q > 0 && part > 1) multiply(x[q], twiddle[2 * q - 2], twiddle[2 * q - 1]);
        }
        Dft<R>::run(x);
        for (int q = 0; q < (Half ? R / 2 : R); ++q) {
          exchange(x[q]);
          store_pairs(to[q] + 2 * c, x[q], Lanes{});
        }
      }
    }
  }

  template <int R, bool Backward>
  RC_FFT_INLINE static void pass(Real* rows, std::int64_t length, std::int64_t groups, const Real* twiddles) {
    const std::int64_t part = length / R;
    for (std::int64_t group = 0; group < groups; ++group, rows += length * row)
      for (std::int64_t i = 0; i < part; ++i) {
        const Real* const twiddle = twiddles + 2 * (R - 1) * i;
        for (int c = 0; c < width; c += lanes) {
          Real* const at = rows + i * row + c;
          Complex<V> x[R];
          for (int q = 0; q < R; ++q) {
            load(at + q * part * row, x[q]);
            if (!Backward) continue;
            exchange(x[q]);
            if (q > 0) multiply(x[q], twiddle[2 * q - 2], twiddle[2 * q - 1]);
          }
          Dft<R>::run(x);
          for (int q = 0; q < R; ++q) {
            if (Backward)
              exchange(x[q]);
            else if (q > 0)
              multiply(x[q], twiddle[2 * q - 2], twiddle[2 * q - 1]);
            store(at + q * part * row, x[q]);
          }
        }
      }
  }

  // The last pass, the eigenvalues, and the last pass backward.
  template <int R>
  RC_FFT_INLINE static void product(Real* rows, std::int64_t groups, const std::int32_t* wave, const Real* eigenvalues) {
    for (std::int64_t group = 0; group < groups; ++group, rows += R * row, wave += R)
      for (int c = 0; c < width; c += lanes) {
        Complex<V> x[R];
        for (int q = 0; q < R; ++q) load(rows + q * row + c, x[q]);
        Dft<R>::run(x);
        for (int q = 0; q < R; ++q) {
          const auto& factor = *reinterpret_cast<const typename V::Type*>(eigenvalues + std::int64_t{wave[q]} * width + c);
          x[q].re *= factor;
          x[q].im *= factor;
          exchange(x[q]);
        }
        Dft<R>::run(x);
        for (int q = 0; q < R; ++q) {
          exchange(x[q]);
          store(rows + q * row + c, x[q]);
        }
      }
  }

  // work(R) for the one of the radices that is wanted.
  template <int... Radices, class Work> RC_FFT_INLINE static void with_radix(int radix, const Work& work) {
    (void)((radix == Radices && (work(std::integral_constant<int, Radices>{}), true)) || ...);
  }

  RC_FFT_INLINE static void run(const ColumnProduct<Real>& plan, const ColumnBlock<Real>& block) {
    const std::int64_t half = plan.length() / 2;
    const bool half_read = block.first_source + block.sources <= half, half_written = block.targets <= half;
    with_radix<1, 2, 3, 4, 5, 7>(plan.first_radix(), [&](auto R) RC_FFT_INLINE_LAMBDA {
      if (R == 4 && half_read)
        read<R, R == 4>(plan, block);
      else
        read<R, false>(plan, block);
    });
    using Kind = typename ColumnProduct<Real>::Step::Kind;
    for (const auto& step : plan.steps()) {
      Real* const rows = reinterpret_cast<Real*>(block.scratch) + step.row * row;
      const Real* const twiddles = plan.twiddles(step.twiddle);
      with_radix<1, 2, 3, 4, 5, 7, 8>(step.radix, [&](auto R) RC_FFT_INLINE_LAMBDA {
        if (step.kind != Kind::forward && step.kind != Kind::backward)
          product<R>(rows, step.groups, plan.wave(step.row), block.eigenvalues);
        else if constexpr (R > 1)
          step.kind == Kind::forward ? pass<R, false>(rows, step.length, step.groups, twiddles)
                                     : pass<R, true>(rows, step.length, step.groups, twiddles);
      });
    }
    with_radix<1, 2, 3, 4, 5, 7>(plan.first_radix(), [&](auto R) RC_FFT_INLINE_LAMBDA {
      if (R == 4 && half_written)
        write<R, R == 4>(plan, block);
      else
        write<R, false>(plan, block);
    });
  }
};

template <class Real, int Bytes> void multiply_columns(const ColumnProduct<Real>& plan, const ColumnBlock<Real>& block) {
  Passes<Real, Bytes>::run(plan, block);
}

#ifdef RC_HAS_WIDER_VECTORS
template <class Real>
[[gnu::target("avx2,fma")]] void multiply_columns_avx2(const ColumnProduct<Real>& plan, const ColumnBlock<Real>& block) {
  Passes<Real, 32>::run(plan, block);
}
template <class Real>
[[gnu::target("avx512f,avx512dq,fma")]] void multiply_columns_avx512(const ColumnProduct<Real>& plan,
                                                                     const ColumnBlock<Real>& block) {
  Passes<Real, 64>::run(plan, block);
}
#endif

}  // namespace rc_fft
