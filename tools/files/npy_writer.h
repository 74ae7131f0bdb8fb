// NumPy's .npy, version 1.0: a float64 array of shape (ny, nx), C order, little-endian.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace cli {

// What stands before the data, of a multiple of 64 bytes. descr: NumPy's name of the numbers' type.
std::string npy_header(std::int64_t nx, std::int64_t ny, const char* descr = "<f8");

void write_npy(std::FILE* file, const std::vector<double>& values, std::int64_t nx, std::int64_t ny);

}  // namespace cli
