// Periodic self-affine surfaces with cut-offs, and the simple shapes.
#pragma once

#include <roughcontact/surface.h>

#include <vector>

namespace rc::surface {

std::vector<double> self_affine(const rc_surface_spectral_spec& spec);
void shape(const rc_surface_shape_spec& spec, double* out);

}  // namespace rc::surface
