// The scene of a seed. Each part (system, options, mask, heights, ...) has random numbers of its own, so that a change of one
// part of the draw leaves the others as they are. Takes nothing from the library.
#pragma once

#include "scene.h"

namespace scenes {

/** reduced: few points only, for slow builds. */
Scene draw(std::uint64_t seed, bool reduced = false);

}  // namespace scenes
