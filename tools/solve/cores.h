// How many threads solve if nobody says.
#pragma once

#include <cstdint>

namespace cli {

// One for each 16384 points of a grid, at least 1, not more than the cores that the process may use, OMP_THREAD_LIMIT and
// OMP_NUM_THREADS; as in Python.
int default_threads(std::int64_t points);

}  // namespace cli
