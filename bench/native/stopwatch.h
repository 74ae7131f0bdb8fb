// Wall-clock times of repeated calls.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <vector>

namespace bench {

using Clock = std::chrono::steady_clock;
inline double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct CallTimes {
  double best = 0, median = 0;  // seconds
  std::int64_t count = 0;
};

// One call to warm the caches, then at least three until the budget of seconds is spent.
template <class Call> CallTimes time_calls(double budget, const Call& call) {
  call();
  std::vector<double> seconds;
  const auto begun = Clock::now();
  do {
    const auto start = Clock::now();
    call();
    seconds.push_back(seconds_since(start));
  } while (seconds.size() < 3 || (seconds_since(begun) < budget && seconds.size() < 1000));
  std::sort(seconds.begin(), seconds.end());
  return {seconds.front(), seconds[seconds.size() / 2], static_cast<std::int64_t>(seconds.size())};
}

}  // namespace bench
