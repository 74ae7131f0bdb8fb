// The results of `roughcontact analyze`; lengths in metres.
#pragma once

#include <roughcontact/surface.h>

#include <optional>
#include <vector>

#include "surface/input.h"

namespace cli {

struct Rings {
  std::vector<double> q, psd;
  std::vector<std::int64_t> modes;
};

struct Analysis {
  SurfaceInput input;
  bool periodic;
  rc_surface_statistics statistics;
  rc_surface_power_law law;
  std::optional<rc_surface_cmr> cmr;  // none if the grid is too small for a coarser one
  Rings rings;
};

inline double wavelength(double q) { return 2 * 3.14159265358979323846 / q; }

}  // namespace cli
