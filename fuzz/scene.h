// A contact problem of up to 64 points, from bytes. Its input begins with options as text, "key=value" a line, up to an empty
// line; so a file of the corpus says what it sets. The line "hardness=X" is none of the library's: X in units of the pressure
// that deflects by the unit of heights. What follows is binary, a byte or a few for each number, in the order of read_scene() and
// read_step().
#pragma once

#include <roughcontact/roughcontact.h>

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "bytes.h"

namespace fuzz {

using Reals = std::vector<double>;

struct Scene {
  std::vector<std::pair<std::string, std::string>> options;
  rc_system system = RC_SYSTEM_INIT;
  Reals matrix;       // the caller's, of DENSE and CALLBACK
  int fails_at = 0;   // CALLBACK: the product that reports failure; 0: none
  int products = 0;   // CALLBACK: so many were asked for
  double height = 1;  // unit of heights

  Scene() = default;
  Scene(const Scene&) = delete;  // `system` points into it
  Scene& operator=(const Scene&) = delete;
  std::size_t points() const { return static_cast<std::size_t>(system.nx * system.ny); }
  std::string option(const std::string& key, const std::string& otherwise) const;
};

struct Step {
  rc_step given = RC_STEP_INIT;  // its pointers are those of the arrays below, or null
  Reals undeformed_gap, start;
  std::vector<std::uint8_t> mask;
};

/** Arrays of a step of doubles, or null. */
inline const double* gap_of(const rc_step& step) { return static_cast<const double*>(step.undeformed_gap.data); }
inline const std::uint8_t* mask_of(const rc_step& step) { return static_cast<const std::uint8_t*>(step.mask.data); }

void read_scene(Bytes& bytes, Scene& scene);

/** `last`: the load and the approach of an answer before, which targets may be near. */
struct Last {
  double load = 0, approach = 0;
};
void read_step(Bytes& bytes, const Scene& scene, const Last& last, bool keeps_gap, Step& step);

/** The scene's options, less those with values that are refused. nullptr where there is no memory. */
rc_options* make_options(const Scene& scene);

}  // namespace fuzz
