#include "passes.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

#include "lanes.h"

namespace rc_fft {

namespace {

// For one width of the vector registers.
template <class Scalar, int Bytes> struct Lanes {
  using Real = Scalar;
  using V = Vector<Real, Bytes>;
  using Plain = typename V::Type;
  static constexpr int lanes = V::lanes;
  static constexpr int columns = static_cast<int>(width<Real>);
  static constexpr std::int64_t row = row_size<Real>;

  // work(R) for the one of the radices that is wanted.
  template <int... Radices, class Work> RC_FFT_INLINE static void with_radix(int radix, const Work& work) {
    (void)((radix == Radices && (work(std::integral_constant<int, Radices>{}), true)) || ...);
  }
};

// Takes the sequences and splits them into R parts. Half: rows of the second half are 0.
template <class L> struct First : L {
  using typename L::Real, typename L::V;

  template <int R, bool Half> RC_FFT_INLINE static void pass(const Plan<Real>& plan, Source<Real>& source, Real* scratch) {
    constexpr int given = Half ? R / 2 : R;
    const std::int64_t part = plan.length / R;
    const Real* from[given][L::columns];
    for (std::int64_t first = 0; first < part; first += L::columns) {
      const std::int64_t count = std::min<std::int64_t>(L::columns, part - first);
      for (int q = 0; q < given; ++q) source.read(q, first + q * part, count, from[q]);
      for (std::int64_t i = 0; i < count; ++i) {
        const Real* const twiddle = plan.twiddles.data() + (part > 1 ? 2 * (R - 1) * (first + i) : 0);
        Real* const to = scratch + (first + i) * L::row;
        for (int c = 0; c < L::columns; c += L::lanes) {
          Complex<V> x[R];
          for (int q = 0; q < given; ++q) load(from[q][i] + c, x[q]);
          if constexpr (Half)
            Dft<R>::run_half(x);
          else
            Dft<R>::run(x);
          for (int q = 0; q < R; ++q) {
            if (q > 0 && part > 1) multiply(x[q], twiddle[2 * q - 2], twiddle[2 * q - 1]);
            store(to + q * part * L::row + c, x[q]);
          }
        }
      }
    }
  }

  RC_FFT_INLINE static void run(const Plan<Real>& plan, Source<Real>& source, Real* scratch) {
    L::template with_radix<1, 2, 3, 4, 5, 7>(plan.radices.front(), [&](auto R) RC_FFT_INLINE_LAMBDA {
      if (R == 4 && source.end() <= plan.length / 2)
        pass<R, R == 4>(plan, source, scratch);
      else
        pass<R, false>(plan, source, scratch);
    });
  }
};

// The inverse of First: it runs last and hands the sequences to the sink.
template <class L> struct Last : L {
  using typename L::Real, typename L::V;

  template <int R, bool Half> RC_FFT_INLINE static void pass(const Plan<Real>& plan, const Real* scratch, Sink<Real>& sink) {
    constexpr int wanted = Half ? R / 2 : R;
    const std::int64_t part = plan.length / R;
    Real* to[wanted][L::columns];
    for (std::int64_t first = 0; first < part; first += L::columns) {
      const std::int64_t count = std::min<std::int64_t>(L::columns, part - first);
      for (int q = 0; q < wanted; ++q) sink.room(q, first + q * part, count, to[q]);
      for (std::int64_t i = 0; i < count; ++i) {
        const Real* const twiddle = plan.twiddles.data() + (part > 1 ? 2 * (R - 1) * (first + i) : 0);
        const Real* const from = scratch + (first + i) * L::row;
        for (int c = 0; c < L::columns; c += L::lanes) {
          Complex<V> x[R];
          for (int q = 0; q < R; ++q) {
            load(from + q * part * L::row + c, x[q]);
            exchange(x[q]);
            if (q > 0 && part > 1) multiply(x[q], twiddle[2 * q - 2], twiddle[2 * q - 1]);
          }
          Dft<R>::run(x);
          for (int q = 0; q < wanted; ++q) {
            exchange(x[q]);
            store(to[q][i] + c, x[q]);
          }
        }
      }
      for (int q = 0; q < wanted; ++q) sink.filled(q, first + q * part, count);
    }
  }

  RC_FFT_INLINE static void run(const Plan<Real>& plan, Real* scratch, Sink<Real>& sink) {
    L::template with_radix<1, 2, 3, 4, 5, 7>(plan.radices.front(), [&](auto R) RC_FFT_INLINE_LAMBDA {
      if (R == 4 && sink.end() <= plan.length / 2)
        pass<R, R == 4>(plan, scratch, sink);
      else
        pass<R, false>(plan, scratch, sink);
    });
  }
};

// All other passes.
template <class L> struct Inner : L {
  using typename L::Real, typename L::V;

  template <int R, bool Backward>
  RC_FFT_INLINE static void pass(Real* rows, std::int64_t length, std::int64_t groups, const Real* twiddles) {
    const std::int64_t part = length / R;
    for (std::int64_t group = 0; group < groups; ++group, rows += length * L::row)
      for (std::int64_t i = 0; i < part; ++i) {
        const Real* const twiddle = twiddles + 2 * (R - 1) * i;
        for (int c = 0; c < L::columns; c += L::lanes) {
          Real* const at = rows + i * L::row + c;
          Complex<V> x[R];
          for (int q = 0; q < R; ++q) {
            load(at + q * part * L::row, x[q]);
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
            store(at + q * part * L::row, x[q]);
          }
        }
      }
  }

  // The last pass, the factors, and the last pass backward; of these what belongs to the way.
  template <int R, Way way, bool Each>
  RC_FFT_INLINE static void turn(Real* rows, std::int64_t groups, const std::int32_t* wave, const Real* factors) {
    for (std::int64_t group = 0; group < groups; ++group, rows += R * L::row, wave += R)
      for (int c = 0; c < L::columns; c += L::lanes) {
        Complex<V> x[R];
        for (int q = 0; q < R; ++q) load(rows + q * L::row + c, x[q]);
        if constexpr (way != Way::backward) Dft<R>::run(x);
        for (int q = 0; q < R && way == Way::there_and_back; ++q) {
          if constexpr (Each) {
            const auto& factor = *reinterpret_cast<const typename V::Type*>(factors + std::int64_t{wave[q]} * L::columns + c);
            x[q].re *= factor;
            x[q].im *= factor;
          } else {
            multiply(x[q], factors[2 * std::int64_t{wave[q]}], factors[2 * std::int64_t{wave[q]} + 1]);
          }
        }
        if constexpr (way != Way::forward) {
          for (int q = 0; q < R; ++q) exchange(x[q]);
          Dft<R>::run(x);
          for (int q = 0; q < R; ++q) exchange(x[q]);
        }
        for (int q = 0; q < R; ++q) store(rows + q * L::row + c, x[q]);
      }
  }

  template <int R>
  RC_FFT_INLINE static void turn(Real* rows, std::int64_t groups, const std::int32_t* wave, Way way,
                                 const Factors<Real>& factors) {
    if (way == Way::forward)
      turn<R, Way::forward, false>(rows, groups, wave, nullptr);
    else if (way == Way::backward)
      turn<R, Way::backward, false>(rows, groups, wave, nullptr);
    else if (factors.each)
      turn<R, Way::there_and_back, true>(rows, groups, wave, factors.each);
    else
      turn<R, Way::there_and_back, false>(rows, groups, wave, factors.all);
  }

  RC_FFT_INLINE static void run(const Plan<Real>& plan, Way way, const Factors<Real>& factors, Real* scratch) {
    using Kind = Step::Kind;
    for (const Step& step : plan.steps) {
      if (way == (step.kind == Kind::forward ? Way::backward : Way::forward) && step.kind != Kind::last) continue;
      Real* const rows = scratch + step.row * L::row;
      const Real* const twiddles = plan.twiddles.data() + step.twiddle;
      L::template with_radix<1, 2, 3, 4, 5, 7, 8>(step.radix, [&](auto R) RC_FFT_INLINE_LAMBDA {
        if (step.kind == Kind::last)
          turn<R>(rows, step.groups, plan.waves.data() + step.row, way, factors);
        else if constexpr (R > 1)
          step.kind == Kind::forward ? pass<R, false>(rows, step.length, step.groups, twiddles)
                                     : pass<R, true>(rows, step.length, step.groups, twiddles);
      });
    }
  }
};

// Exchanges of lanes and elements.
template <class L> struct Exchange : L {
  using typename L::Real, typename L::V, typename L::Plain;

  // Loads and stores at any address.
  RC_FFT_INLINE static void get(const Real* p, Plain& v) { std::memcpy(&v, p, sizeof v); }
  RC_FFT_INLINE static void put(Real* p, const Plain& v) { std::memcpy(p, &v, sizeof v); }

  // A block of spectra, into the second level of the cache.
  RC_FFT_INLINE static void prefetch(const Real* block) {
    for (int line = 0; line < 2 * most_lines<Real>; ++line) __builtin_prefetch(block + line * L::columns, 0, 2);
  }

  // to(j, i) from from(i, j), for `width` i and j and as many of each as a register has lanes at a time.
  template <class From, class To> RC_FFT_INLINE static void tile(const From& from, const To& to) {
    for (int i = 0; i < L::columns; i += L::lanes)
      for (int j = 0; j < L::columns; j += L::lanes) {
        Plain v[L::lanes];
        for (int k = 0; k < L::lanes; ++k) from(i + k, j, v[k]);
        transpose<V>(v);
        for (int k = 0; k < L::lanes; ++k) to(j + k, i, v[k]);
      }
  }
};

template <class L> struct FromLines : Exchange<L> {
  using typename L::Real, typename L::Plain;
  RC_FFT_INLINE static void run(const Real* const* lines, std::int64_t at, Real* rows) {
    for (int part = 0; part < 2; ++part)
      FromLines::tile(
          [&](int i, int j, Plain& v) RC_FFT_INLINE_LAMBDA {
            const Real* const line = lines[part * L::columns + i];
            v = Plain{};
            if (line) FromLines::get(line + at + j, v);
          },
          [&](int j, int i, const Plain& v)
              RC_FFT_INLINE_LAMBDA { FromLines::put(rows + j * L::row + part * L::columns + i, v); });
  }
};

template <class L> struct ToLines : Exchange<L> {
  using typename L::Real, typename L::Plain;
  RC_FFT_INLINE static void run(const Real* rows, Real* const* lines, std::int64_t at) {
    for (int part = 0; part < 2; ++part)
      ToLines::tile([&](int i, int j, Plain& v)
                        RC_FFT_INLINE_LAMBDA { ToLines::get(rows + i * L::row + part * L::columns + j, v); },
                    [&](int j, int i, const Plain& v) RC_FFT_INLINE_LAMBDA {
                      Real* const line = lines[part * L::columns + j];
                      if (line) ToLines::put(line + at + i, v);
                    });
  }
};

// With Z[k] the waves of a + ib, A and B those of a and b, and * for the conjugate complex:
// 2 A[k] = Z[k] + Z*[-k], 2 i B[k] = Z[k] - Z*[-k], Z[k] = A[k] + i B[k], Z[-k] = A*[k] + i B*[k].
template <class L> struct ToSpectra : Exchange<L> {
  using typename L::Real, typename L::Plain;

  RC_FFT_INLINE static void run(const Real* scratch, const Mirrored* rows, std::int64_t waves, Real* spectra) {
    // Part `part` of the lines from `line` on is first + sign * second, parts `of` of a wave and its mirrored one; `mirror`
    // exchanges the two.
    struct Sum {
      std::int64_t line, part;
      bool mirror;
      std::int64_t of;
      Real sign;
    };
    constexpr std::int64_t im = L::columns;
    constexpr Sum sums[] = {{0, 0, false, 0, 1}, {0, im, false, im, -1}, {im, 0, false, im, 1}, {im, im, true, 0, -1}};
    for (std::int64_t k = 0; k < waves; k += L::columns, rows += L::columns, spectra += most_lines<Real> * L::row) {
      ToSpectra::prefetch(spectra + 2 * most_lines<Real> * L::row);
      for (const Sum& sum : sums) {
        const Real* const from = scratch + sum.of;
        ToSpectra::tile(
            [&](int i, int j, Plain& v) RC_FFT_INLINE_LAMBDA {
              Plain other;
              ToSpectra::get(from + (sum.mirror ? rows[i].mirror : rows[i].row) * L::row + j, v);
              ToSpectra::get(from + (sum.mirror ? rows[i].row : rows[i].mirror) * L::row + j, other);
              v += sum.sign * other;
            },
            [&](int j, int i, const Plain& v)
                RC_FFT_INLINE_LAMBDA { ToSpectra::put(spectra + (sum.line + j) * L::row + sum.part + i, v); });
      }
    }
  }
};

template <class L> struct FromSpectra : Exchange<L> {
  using typename L::Real, typename L::Plain;

  RC_FFT_INLINE static void run(const Real* spectra, std::int64_t count, const Mirrored* rows, std::int64_t waves,
                                Real* scratch) {
    struct Sum {
      std::int64_t part;  // this part of the wave,
      bool mirror;        // or of the mirrored one, is
      std::int64_t line;  // the real part of the waves of lines from `line` on and
      Real sign;          // sign times the imaginary part of the others
    };
    constexpr std::int64_t im = L::columns;
    // Waves that are their own mirrored ones are written twice. They are real but for rounding.
    constexpr Sum sums[] = {{0, true, 0, 1}, {im, true, im, -1}, {0, false, 0, -1}, {im, false, im, 1}};
    for (std::int64_t k = 0; k < waves; k += L::columns, rows += L::columns, spectra += most_lines<Real> * L::row) {
      FromSpectra::prefetch(spectra + 2 * most_lines<Real> * L::row);
      for (const Sum& sum : sums)
        FromSpectra::tile(
            [&](int i, int j, Plain& v) RC_FFT_INLINE_LAMBDA {
              const std::int64_t line = sum.line + i, other = im - sum.line + i;
              Plain imaginary{};
              v = Plain{};
              if (line < count) FromSpectra::get(spectra + line * L::row + j, v);
              if (other < count) FromSpectra::get(spectra + other * L::row + im + j, imaginary);
              v += sum.sign * imaginary;
            },
            [&](int j, int i, const Plain& v) RC_FFT_INLINE_LAMBDA {
              if (k + j < waves)
                FromSpectra::put(scratch + (sum.mirror ? rows[j].mirror : rows[j].row) * L::row + sum.part + i, v);
            });
    }
  }
};

// Work::run(arguments), compiled for a set of instructions.
template <class Function> struct Builds;
template <class... Arguments> struct Builds<void (*)(Arguments...)> {
  template <class Work> static void any(Arguments... arguments) { Work::run(arguments...); }
#ifdef RC_HAS_WIDER_VECTORS
  template <class Work> [[gnu::target("avx2,fma")]] static void avx2(Arguments... arguments) { Work::run(arguments...); }
  template <class Work> [[gnu::target("avx512f,avx512dq,fma")]] static void avx512(Arguments... arguments) {
    Work::run(arguments...);
  }
#endif
};

#define RC_FFT_PASSES(Real, bytes, build)                                                    \
  {                                                                                          \
    Builds<decltype(Passes<Real>::first)>::build<First<Lanes<Real, bytes>>>,                 \
        Builds<decltype(Passes<Real>::inner)>::build<Inner<Lanes<Real, bytes>>>,             \
        Builds<decltype(Passes<Real>::last)>::build<Last<Lanes<Real, bytes>>>,               \
        Builds<decltype(Passes<Real>::from_lines)>::build<FromLines<Lanes<Real, bytes>>>,    \
        Builds<decltype(Passes<Real>::to_lines)>::build<ToLines<Lanes<Real, bytes>>>,        \
        Builds<decltype(Passes<Real>::to_spectra)>::build<ToSpectra<Lanes<Real, bytes>>>,    \
        Builds<decltype(Passes<Real>::from_spectra)>::build<FromSpectra<Lanes<Real, bytes>>> \
  }

}  // namespace

template <class Real> const Passes<Real>& Passes<Real>::of([[maybe_unused]] rc_common::Vectors vectors) {
#ifdef RC_HAS_WIDER_VECTORS
  static constexpr Passes avx2 = RC_FFT_PASSES(Real, 32, template avx2), avx512 = RC_FFT_PASSES(Real, 64, template avx512);
  if (vectors == rc_common::Vectors::avx2) return avx2;
  if (vectors == rc_common::Vectors::avx512) return avx512;
#endif
  static constexpr Passes any = RC_FFT_PASSES(Real, 16, template any);
  return any;
}

template struct Passes<double>;
template struct Passes<float>;

}  // namespace rc_fft
