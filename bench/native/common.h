// C functions that report exceptions, threads, and wall-clock times of repeated calls.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <string>
#include <thread>
#include <vector>

namespace bench {

// Null, or why work failed, valid until the thread's next call.
template <class Work> const char* guarded(const Work& work) {
  thread_local std::string message;
  try {
    work();
    return nullptr;
  } catch (const std::exception& error) {
    message = error.what();
    return message.c_str();
  }
}

// work(thread, first, last) on all threads at once, with equal shares of n.
template <class Work> void in_parallel(std::int64_t n, std::int64_t threads, const Work& work) {
  std::vector<std::jthread> helpers;
  for (std::int64_t t = 1; t < threads; ++t)
    helpers.emplace_back([&, t] { work(static_cast<std::size_t>(t), n * t / threads, n * (t + 1) / threads); });
  work(std::size_t{0}, std::int64_t{0}, n / threads);
}

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
