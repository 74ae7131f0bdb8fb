// A surface as the command line asks for it: read, with its pitch settled, its form removed and its missing points treated.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/surface.h"
#include "surface/shapes.h"

namespace cli {

inline constexpr std::string_view missing_rule_names[] = {"reject", "fill", "exclude"};

struct SurfaceArguments {
  std::string file;
  std::optional<std::string> format, pitch, unit, missing, remove;
  std::optional<std::string> against, shape;
};

struct SurfaceInput {
  std::string file;
  rc::formats::Surface surface;    // with its pitch; excluded points have the height NaN
  std::string against;             // file of the other body's heights, which were added; "" if it is flat
  std::string shape;               // that was added, as given; "" if none
  std::optional<Shape> body;       // the same
  std::string removed;             // "none", "mean", "plane" or "quadric"
  std::int64_t missing = 0;        // points
  std::string missing_rule;        // what was done with them: "reject" (there are none), "fill" or "exclude"
  std::vector<std::uint8_t> mask;  // 0: excluded; empty if no point is
  std::string assumed;  // the unit that is taken for lengths without one, in words; "" if there is none or it was given
  std::vector<std::string> notes;  // what the user should know about the choices made

  // ", against other.gsf, plane removed, 12 missing points filled": what was done to the heights, for a line of text; "" if
  // nothing.
  std::string preparation() const;
};

// A struct of the surface library with the grid of a surface.
template <class Struct> Struct on_grid(const rc::formats::Surface& surface, Struct made) {
  made.nx = surface.nx;
  made.ny = surface.ny;
  made.hx = *surface.hx;
  made.hy = *surface.hy;
  return made;
}

// Metres per --unit.
double unit_of(const SurfaceArguments& arguments);

// Checks --unit against the files, and notes what is assumed if it was not given. other: null if there is no other body.
void settle_units(const SurfaceArguments& arguments, const rc::formats::Surface* other, SurfaceInput& input);

// Throws an Error at the first argument that is wrong, before the file is read. `can_exclude`: whether the caller can leave
// points out.
SurfaceInput read_input(const SurfaceArguments& arguments, bool can_exclude);

}  // namespace cli
