// Arrays in .npy files of which every rank reads and writes its rows, by MPI-IO.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "communicator.h"
#include "formats/npy.h"

namespace cli {

// Which rows of the grid a rank has.
struct Rows {
  std::int64_t first = 0, count = 0;
};

// The layout of a file of heights, the same on every rank, read once. Throws if it is no array of float32 or float64 in C
// order, or where the file is not as long as its grid.
rc::formats::NpyLayout read_layout(const Communicator& ranks, const std::string& file);

// These rows as double precision. Throws the same Error on every rank.
std::vector<double> read_rows(const Communicator& ranks, const std::string& file, const rc::formats::NpyLayout& layout,
                              Rows rows);

// Writes an array (ny, nx) of float64 of which `values` are these rows, under a temporary name that is then renamed. Throws the
// same Error on every rank.
void write_rows(const Communicator& ranks, const std::filesystem::path& path, std::span<const double> values, std::int64_t nx,
                std::int64_t ny, Rows rows);

}  // namespace cli
