// Watches one solve: iteration and time limits, cancellation, progress.
#pragma once

#include <roughcontact/roughcontact.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>

#include "core/host_call.h"

namespace rc {

// Products and seconds of operators since they were made.
struct Spent {
  std::int64_t products = 0;
  double setup_seconds = 0;
};

using Clock = std::chrono::steady_clock;
inline double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct ProgressCallback {
  rc_progress_fn function = nullptr;
  void* user = nullptr;
  std::int64_t every = 1;

  std::int32_t tell(const rc_progress& report) const {
    const HostsTurn turn;
    return function(&report, user);
  }
};

// Who watches the steps of a contact and may cancel them: a caller, or the monitor of a finer grid.
struct Watcher {
  ProgressCallback progress = {};
  std::atomic<bool> cancelled = false;

  void cancel() { cancelled.store(true, std::memory_order_relaxed); }
};

// While it lives, a cancellation ends the running solve or the next one. Its destructor clears the cancellation.
class Cancellable {
 public:
  explicit Cancellable(Watcher& watcher) : watcher_(watcher) {}
  ~Cancellable() { watcher_.cancelled.store(false, std::memory_order_relaxed); }
  Cancellable(const Cancellable&) = delete;
  Cancellable& operator=(const Cancellable&) = delete;
  bool cancelled() const { return stop_asked<ContactLibrary>() || watcher_.cancelled.load(std::memory_order_relaxed); }

 private:
  Watcher& watcher_;
};

class Monitor {
 public:
  // before: what the operators had spent.
  Monitor(const std::atomic<bool>& cancelled, const ProgressCallback& progress, double time_limit, std::int64_t max_iter,
          const Spent& before = {})
      : cancelled_(cancelled), progress_(progress), time_limit_(time_limit), max_iter_(max_iter), before_(before) {}

  bool cancelled() const { return stop_asked<ContactLibrary>() || cancelled_.load(std::memory_order_relaxed); }
  // Asked before every product.
  rc_status ask() const {
    if (cancelled()) return RC_STOP_CANCELLED;
    if (time_limit_ > 0 && seconds() > time_limit_) return RC_STOP_TIME;
    return RC_OK;
  }

  // Called once an iteration by a solver, which counts from 0 at each of its calls.
  rc_status poll(std::int64_t iteration, double kkt, std::int64_t products) {
    if (iteration > iteration_) ++iterations_;
    iteration_ = iteration;
    if (progress_.function && iterations_ >= next_report_) {
      next_report_ = iterations_ + progress_.every;
      const rc_progress report{sizeof(rc_progress), iterations_, products, kkt, seconds()};
      if (progress_.tell(report) != 0) return RC_STOP_CANCELLED;
    }
    if (const rc_status status = ask(); status != RC_OK) return status;
    return used_up() ? RC_STOP_MAX_ITER : RC_OK;
  }
  bool used_up() const { return iterations_ >= max_iter_; }  // no iteration is left
  // Passes the report of a solve inside this one on to the caller.
  std::int32_t report(const rc_progress& inner) const {
    if (!progress_.function || inner.iteration % progress_.every != 0) return 0;
    rc_progress report = inner;
    report.seconds = seconds();
    return progress_.tell(report);
  }
  void next_call() { iteration_ = 0; }
  // begin_call and end_call enclose a solver inside a solver.
  std::int64_t begin_call() {
    const std::int64_t outer = iteration_;
    iteration_ = 0;
    return outer;
  }
  void end_call(std::int64_t outer) { iteration_ = outer; }

  // For a solve inside this one that reports nothing.
  Monitor silent() const { return {cancelled_, {}, time_left(), max_iter_}; }

  // Seconds left of the time limit; 0: there is none.
  double time_left() const { return time_limit_ > 0 ? std::max(time_limit_ - seconds(), 1e-3) : 0; }
  std::int64_t iterations() const { return iterations_; }
  double seconds() const { return seconds_since(start_); }
  const Spent& before() const { return before_; }

 private:
  const std::atomic<bool>& cancelled_;
  const ProgressCallback progress_;
  const double time_limit_;
  const std::int64_t max_iter_;
  const Spent before_;
  const Clock::time_point start_ = Clock::now();
  std::int64_t iterations_ = 0, iteration_ = 0, next_report_ = 0;
};

// For a solve inside the monitor's, which must outlive it: the first stops it when the monitor says so; the second shows its
// progress also to the monitor's caller.
inline ProgressCallback stopped_by(const Monitor& monitor) {
  const auto ask = [](const rc_progress*, void* of) -> std::int32_t { return static_cast<const Monitor*>(of)->ask() != RC_OK; };
  return {ask, const_cast<Monitor*>(&monitor), 1};
}
inline ProgressCallback reported_by(const Monitor& monitor) {
  const auto pass_on = [](const rc_progress* progress, void* of) -> std::int32_t {
    const Monitor& outer = *static_cast<const Monitor*>(of);
    return outer.ask() != RC_OK || outer.report(*progress) != 0;
  };
  return {pass_on, const_cast<Monitor*>(&monitor), 1};
}

}  // namespace rc
