// One surface pressed in steps, warm-started or from zero.
#pragma once

#include <cstdint>
#include <vector>

#include "library.h"
#include "scene.h"

namespace bench {

struct LoadingHistory {
  std::int64_t n = 0;  // points a side
  Field gap;
  std::vector<double> approaches;
};

// Increasing steps up to half the height of the highest point above the mean plane, of a midpoint displacement surface of
// 2^levels points a side over the unit square: Bemporad & Paggi (2015), section 4.
LoadingHistory loading_history(std::int64_t levels, double hurst, std::uint64_t seed, std::int64_t steps);

struct HistoryStep {
  rc_result result{};
  double cpu_seconds = 0;  // of the call, what it built included
};

// Each step, or those up to the first that ran out of time.
std::vector<HistoryStep> run_history(const LoadingHistory& history, const Settings& settings, bool warm);

}  // namespace bench
