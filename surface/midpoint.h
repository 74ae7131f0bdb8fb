// Random midpoint displacement: Peitgen & Saupe (1988), algorithm MidPointFM2D.
#pragma once

#include <roughcontact/surface.h>

#include <vector>

namespace rc::surface {

// The (2^stage + 1)^2 vertices of a stage, 0 <= stage <= levels.
std::vector<double> midpoint_displacement(const rc_surface_rmd_spec& spec, int stage);

}  // namespace rc::surface
