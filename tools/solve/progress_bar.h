// The bar of the running step on a terminal: how far the residual has come on a logarithmic scale, from 1 to the tolerance.
#pragma once

#include <roughcontact/roughcontact.h>

#include <chrono>
#include <string>

namespace cli {

class ProgressBar {
 public:
  // Draws on standard error if `enabled`, else does nothing.
  ProgressBar(bool enabled, double tolerance, std::size_t steps);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  bool enabled() const { return enabled_; }
  void begin(int step);
  void update(const rc_progress& progress);
  // Takes the bar off the screen.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void draw(long long iteration, double residual, double seconds);

  bool enabled_;
  bool visible_ = false;
  double tolerance_;
  std::size_t steps_;
  int step_ = 0;
  double furthest_ = 0;  // the residual goes up and down, the bar does not
  Clock::time_point drawn_{};
};

}  // namespace cli
