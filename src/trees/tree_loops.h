// The arithmetic of the trees, eight blocks of 2 x 2 cells at a time, for the best vector instructions of this processor.
#pragma once

#include <cstdint>

#include "trees/tree_shape.h"

namespace rc {

// Eight blocks: w and m as algebra.inc stores them.
struct HaarBlocks {
  std::int16_t w[4][8];
  std::uint16_t m[6][8];
};

// The same for the finest level, for the 16 patterns of children in contact: all cells are equal, so nothing else matters.
struct HaarPatterns {
  float w[4][16], m[6][16];
  float above[16];  // self coupling of the parent
};

// Loops over `count` groups of eight blocks. A group's children lie in two rows of 16: 0 1 0 1 .. and 2 3 2 3 ..
struct HaarRows {
  // Blocks and their self couplings `above`, from the self couplings of their children, which are 0 without contact.
  void (*solve)(std::int64_t count, const HaarCouplings& k, const float* first, const float* second, HaarBlocks* blocks,
                float* above);
  // Loads of the blocks, from those of their children.
  void (*up)(std::int64_t count, const HaarBlocks* blocks, const float* first, const float* second, float* above);
  // Replaces the loads of the children by their pressures; above: the pressures of the blocks.
  void (*down)(std::int64_t count, const HaarBlocks* blocks, float* first, float* second, const float* above);
};

template <class Real> struct HaarFinest {
  void (*solve)(std::int64_t count, const HaarPatterns& table, const std::uint8_t* in_first, const std::uint8_t* in_second,
                float* above);
  void (*up)(std::int64_t count, const HaarPatterns& table, const std::uint8_t* in_first, const std::uint8_t* in_second,
             const Real* first, const Real* second, float* above);
  // z = (add ? z : 0) + scale * pressure on the free set, 0 elsewhere; a null row of z is not written.
  void (*down)(std::int64_t count, const HaarPatterns& table, const std::uint8_t* in_first, const std::uint8_t* in_second,
               const Real* first, const Real* second, const float* above, Real scale, bool add, Real* z_first, Real* z_second);
};

// (a, b), where a is 0 off the free set, which is `active`.
template <class Real> using HaarInner = double (*)(std::int64_t n, const Real* a, const Real* b, const std::uint8_t* active);

HaarRows best_haar_rows();
template <class Real> HaarFinest<Real> best_haar_finest();
template <class Real> HaarInner<Real> best_haar_inner();

}  // namespace rc
