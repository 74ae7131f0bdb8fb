// Small problems on which methods fail, with the library's public interface alone.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstdint>
#include <string>
#include <vector>

#include "rough_surface.h"
#include "support/unit_system.h"

namespace failures {

struct Scene {
  std::string name;
  rc_system system = support::unit_system();  // free half-space
  std::string kernel = "love";
  Field gap;
  std::vector<std::uint8_t> mask;  // empty: every point
  double approach = 0;
  rc_step step() const;
};

// Bemporad & Paggi (2015), Example 1: side x side unit cells, every one a candidate, penetrations uniform on (0, 1). Spacing
// 2: a masked cell between each two.
Scene example_one(std::int64_t side, std::int64_t spacing, std::uint64_t seed);

// A paraboloid pressed in over a contact radius of about a third of n cells.
Scene hertz_scene(std::int64_t n);
// Midpoint displacement, approach half the height of the highest point above the mean plane; 2^levels points a side.
Scene rough_scene(std::int64_t levels, std::uint64_t seed, double hurst = 0.7);
// Points with p = 0 and gap = 0: which of them are in contact is undefined, the pressures are not.
Scene tied_scene(std::int64_t n);
// The same problem with lengths and pressures in other units.
Scene in_units(Scene scene, double length, double pressure);

// Well-posed problems that strain double precision: near-full contact, one point, spikes, offsets, flatness, aspect, kernel.
std::vector<Scene> strained_scenes(std::int64_t n);

}  // namespace failures
