// Height maps as text: one row a line, values separated by semicolons, as many rows as columns. The form that MIRCO reads.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

struct Topography {
  std::int64_t side = 0;
  std::vector<double> heights;  // side by side, x (along a line of the file) fastest
};

// Throws std::runtime_error with file, line and what is wrong.
Topography read_topography(const std::string& path);
