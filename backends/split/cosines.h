// The transform of a table that is even along both axes.
#pragma once

#include <cstdint>
#include <roughcontact/plugin.hpp>

namespace rc_split {

// table [ny][nx]: values of an even periodic function at 0 .. nx-1 of 2 (nx-1) points along x, likewise along y; becomes its
// discrete Fourier transform, which is real and even as well. nx, ny >= 2.
void transform_even(const rc_host* host, const rc_team& team, std::int64_t nx, std::int64_t ny, double* table);

}  // namespace rc_split
