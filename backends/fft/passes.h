// The passes of Fourier transforms, compiled for each set of vector instructions.
#pragma once

#include <cstdint>
#include <vector>

#include "common/processor.h"
#include "sequences.h"

namespace rc_fft {

// One pass over some rows of the scratch.
struct Step {
  enum class Kind { forward, last, backward } kind;
  int radix;
  std::int64_t row, length, groups;  // groups of `length` rows from `row` on, each split into `radix` parts
  std::size_t twiddle;               // of the first twiddle factor
};

// Rows of the scratch that hold the waves k and length - k.
struct Mirrored {
  std::int32_t row, mirror;
};

template <class Real> struct Passes;

template <class Real> struct Plan {
  std::int64_t length;
  std::vector<int> radices;  // of all passes; the last has no twiddle factors
  std::vector<Real> twiddles;
  std::vector<Step> steps;          // all but the first and the last pass, which take and give the sequences
  std::vector<std::int32_t> waves;  // rank of the wave in each row of the scratch
  const Passes<Real>* passes;
};

// The factors of the waves, by rank, before they are transformed back.
template <class Real> struct Factors {
  const Real* each;  // `width` real factors, one for each sequence
  const Real* all;   // or a complex factor for all of them
};

enum class Way { forward, there_and_back, backward };

// Lines are real sequences, most_lines of them: line l < width is the real parts of sequence l, line width + l its imaginary
// parts.
template <class Real> struct Passes {
  void (*first)(const Plan<Real>&, Source<Real>&, Real* scratch);
  void (*inner)(const Plan<Real>&, Way, const Factors<Real>&, Real* scratch);
  void (*last)(const Plan<Real>&, Real* scratch, Sink<Real>&);
  // `width` elements from place `at` on of lines into rows; and back. Lines may be null.
  void (*from_lines)(const Real* const* lines, std::int64_t at, Real* rows);
  void (*to_lines)(const Real* rows, Real* const* lines, std::int64_t at);
  // The waves of lines, twice, from those of the sequences in the scratch: in blocks of `width` waves, within a block one line
  // after the other, `width` real parts and as many imaginary parts. And back, without the factor, of the first `count` lines.
  void (*to_spectra)(const Real* scratch, const Mirrored* rows, std::int64_t waves, Real* spectra);
  void (*from_spectra)(const Real* spectra, std::int64_t count, const Mirrored* rows, std::int64_t waves, Real* scratch);

  static const Passes& of(rc_common::Vectors);
};

}  // namespace rc_fft
