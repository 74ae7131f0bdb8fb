// Random problems for a solver: a contact and a short history of unrelated steps. Seed and number decide everything.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenes/random.h"
#include "support/contact.h"

namespace scenes {

using pairs::Field;

/** Pressures a step starts from, instead of those that the contact remembers. */
struct Start {
  enum Kind { remembered, random, checkerboard, too_large, zero, single_cell } kind = remembered;
  std::uint64_t seed = 0;
  double size = 0;  // typical pressure
};

struct Step {
  std::string surface;  // its family
  Field gap;            // empty: as in the step before
  std::vector<std::uint8_t> mask;
  std::int32_t control = RC_CONTROL_APPROACH;
  double target = 0;
  bool warm = true;
  Start start;
  rc_status expected = RC_OK;
  std::string name;
};

struct Scene {
  std::uint64_t number = 0;
  pairs::Problem problem;  // system and kernel; the gap and mask of the first step
  pairs::Pair pair;
  double tol = 1e-8;
  std::vector<Step> steps;
  std::string name;
};

Scene random_scene(std::uint64_t seed, std::uint64_t number);

/** The start's pressures; `last` are those of the step before, empty at first. Nothing where the contact's own serve. */
std::optional<Field> start_pressures(const Start& start, const pairs::Problem& problem, const Field& last);

}  // namespace scenes
