// NumPy's .npy, version 1.0: a float64 array of shape (ny, nx), C order, little-endian.
#pragma once

#include <cstdint>
#include <cstdio>
#include <vector>

namespace cli {

void write_npy(std::FILE* file, const std::vector<double>& values, std::int64_t nx, std::int64_t ny);

}  // namespace cli
