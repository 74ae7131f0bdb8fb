// The surfaces that are pressed: gaps over the unit square, sampled at the centres of n x n cells.
#pragma once

#include <cstdint>
#include <vector>

namespace bench {

using Field = std::vector<double>;

// A self-affine surface about a mean plane at 0: random phases, power ~ |k|^-2(1+H) between roll_off and cut_off waves a side,
// flat below, none above.
struct SelfAffine {
  std::uint64_t seed = 1;
  double hurst = 0.8;
  double roll_off = 4;
  double cut_off = 0;  // 0: n/8, a shortest wave of 8 cells
  double rms_slope = 0.1;
};

// Every wave's phase depends on the seed and its wave vector alone: a finer grid samples the same surface where cut_off is the
// same, and adds shorter waves to it where it grows with n.
Field self_affine_gap(std::int64_t n, const SelfAffine& surface);

// A paraboloid of radius of curvature 1 that touches in the middle of the square, with Hertz's solution for contact modulus 1.
struct Hertz {
  double contact_radius = 0.25;
  double approach() const;
  double load() const;
  double contact_area() const;
  Field gap(std::int64_t n) const;
  Field pressure(std::int64_t n) const;
};

}  // namespace bench
