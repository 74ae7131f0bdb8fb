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

// Seconds of the fastest of at least three calls, until the budget of seconds is spent, after one to warm the caches.
template <class Call> double best_time(double budget, const Call& call) {
  call();
  double best = 1e300;
  const auto begun = Clock::now();
  for (int calls = 0; calls < 3 || (seconds_since(begun) < budget && calls < 1000); ++calls) {
    const auto start = Clock::now();
    call();
    best = std::min(best, seconds_since(start));
  }
  return best;
}

}  // namespace bench
