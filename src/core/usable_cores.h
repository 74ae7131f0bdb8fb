// The default number of threads.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rc {

// The first number of a list as OpenMP reads it, "4" or " 4, 2 "; nothing unless all of them are whole numbers above 0.
std::optional<std::int64_t> openmp_limit(std::string_view text);

// Cores that this process may use, >= 1: those its threads may run on, or with allowed > 0 that many; at most what its control
// groups, OMP_THREAD_LIMIT and OMP_NUM_THREADS allow, and the most that option threads takes.
std::int64_t usable_cores(std::int64_t allowed);

}  // namespace rc
