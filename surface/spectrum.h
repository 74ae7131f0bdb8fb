// The power spectral density of a map, mode by mode and averaged over rings.
#pragma once

#include <vector>

#include "heights.h"

namespace rc::surface {

struct Spectrum {
  std::int64_t nx, ny;
  double dx, dy;              // wave numbers of one wave along x and along y
  double area;                // of the map
  int dimensions;             // 1 for profiles
  double nyquist;             // pi / max(hx, hy), of the directions with more than one point
  bool windowed;              // not periodic
  double shared;              // how many modes carry the same random number: 2 (conjugates), more under a window
  std::vector<double> power;  // C(qx, qy) at index ky*nx + kx
  std::vector<bool> texture;  // of the same size: modes of periodic textures, see find_peaks

  double q(std::int64_t kx, std::int64_t ky) const;
  double at(std::int64_t kx, std::int64_t ky) const { return power[index(kx, ky)]; }
  std::size_t index(std::int64_t kx, std::int64_t ky) const;  // of any integers
};

Spectrum spectrum(const Heights& heights);

// The wave number of a wave as long as the longer side.
double lowest_wave(const Spectrum& spectrum);

struct Ring {
  double q = 0, power = 0;  // means
  std::int64_t modes = 0;
};

// Rings of width 2 pi / max(nx hx, ny hy); rings without modes are left out.
std::vector<Ring> rings(const Spectrum& spectrum);

}  // namespace rc::surface
