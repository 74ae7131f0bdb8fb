// Files of heights and other fields on a grid, x fastest, little-endian.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "formats/surface.h"

namespace cli {

// The header of NumPy's .npy, version 1.0, for an array of shape (ny, nx): a multiple of 64 bytes. descr: NumPy's
// name of the numbers' type.
std::string npy_header(std::int64_t nx, std::int64_t ny, const char* descr = "<f8");

void write_npy(std::FILE* file, const std::vector<double>& values, std::int64_t nx, std::int64_t ny);

// Gwyddion Simple Field, lengths in metres; heights become float32, to which rounding errors of 1e-7 of the largest must not
// matter. Throws an Error if they are beyond its range.
void write_gsf(std::FILE* file, const rc::formats::Surface& surface);

}  // namespace cli
