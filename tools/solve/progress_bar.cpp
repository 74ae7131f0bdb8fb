#include "solve/progress_bar.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "platform/terminal.h"
#include "text.h"

namespace cli {

namespace {

constexpr auto redraw_interval = std::chrono::milliseconds(100);
constexpr int progress_width = 30;

}  // namespace

ProgressBar::ProgressBar(bool enabled, double tolerance, std::size_t steps)
    : enabled_(enabled), tolerance_(tolerance), steps_(steps) {}

void ProgressBar::begin(int step) {
  step_ = step;
  furthest_ = 0;
  drawn_ = Clock::now();
  if (enabled_) draw(0, 1, 0);
}

void ProgressBar::update(const rc_progress& progress) {
  if (!enabled_) return;
  if (progress.kkt > 0) furthest_ = std::max(furthest_, std::clamp(std::log(progress.kkt) / std::log(tolerance_), 0.0, 1.0));
  if (progress.kkt <= 0) furthest_ = 1;
  if (Clock::now() - drawn_ < redraw_interval) return;
  drawn_ = Clock::now();
  draw(progress.iteration, progress.kkt, progress.seconds);
}

void ProgressBar::draw(long long iteration, double residual, double seconds) {
  const int filled = static_cast<int>(furthest_ * progress_width);
  const std::string bar =
      std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(progress_width - filled), '.');
  std::string line =
      format("step %d/%zu [%s] iteration %lld  residual %.1e  %.1f s", step_, steps_, bar.c_str(), iteration, residual, seconds);
  line.resize(std::min(line.size(), rc_platform::terminal_width() - 1));  // a wrapped line could not be overwritten
  std::fprintf(stderr, "\r%s\x1b[K", line.c_str());
  std::fflush(stderr);
  visible_ = true;
}

void ProgressBar::clear() {
  if (!std::exchange(visible_, false)) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
}

}  // namespace cli
