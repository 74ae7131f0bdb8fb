// The arithmetic of the trees, eight blocks of 2 x 2 cells at a time, for the best vector instructions of this processor.
#pragma once

#include <cstdint>

namespace rc {

constexpr float haar_unit_share = 16384;  // of HaarBlocks::w

// Eight blocks: shares of each block's load, in units of 2^-14, and couplings of the differences between children, 01 02 03 12 13
// 23, as the upper halves of floats. A preconditioner needs no more digits.
struct HaarBlocks {
  std::int16_t w[4][8];
  std::uint16_t m[6][8];
};

// The blocks of the finest level: all cells are alike, so the pattern of those in contact tells.
struct HaarPatterns {
  float w[4][16], m[6][16];
  float above[16];  // self coupling of the parent
};

// Of neighbours along x, along y, and across.
struct HaarCouplings {
  float x, y, xy;
};

// Each over `count` groups of eight blocks. Their children lie in two rows of 16 to a group: 0 1 0 1 .. and 2 3 2 3 ..
struct HaarRows {
  // From self couplings of the children, 0 where there is no contact.
  void (*solve)(std::int64_t count, const HaarCouplings& k, const float* first, const float* second, HaarBlocks* blocks,
                float* above);
  // Loads of the children to those of the blocks.
  void (*up)(std::int64_t count, const HaarBlocks* blocks, const float* first, const float* second, float* above);
  // Loads of the children to their pressures.
  void (*down)(std::int64_t count, const HaarBlocks* blocks, float* first, float* second, const float* above);
};

template <class Real> struct HaarFinest {
  void (*solve)(std::int64_t count, const HaarPatterns& table, const std::uint8_t* in_first, const std::uint8_t* in_second,
                float* above);
  void (*up)(std::int64_t count, const HaarPatterns& table, const std::uint8_t* in_first, const std::uint8_t* in_second,
             const Real* first, const Real* second, float* above);
  // z = (add ? z : 0) + scale * pressure on the contact set, 0 elsewhere; a row of z that is null is left out.
  void (*down)(std::int64_t count, const HaarPatterns& table, const std::uint8_t* in_first, const std::uint8_t* in_second,
               const Real* first, const Real* second, const float* above, Real scale, bool add, Real* z_first, Real* z_second);
};

HaarRows best_haar_rows();
template <class Real> HaarFinest<Real> best_haar_finest();

}  // namespace rc
