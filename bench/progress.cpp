#include "progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "format.h"

namespace bench {

namespace {

constexpr int bar_width = 24;

std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string minutes(double seconds) {
  const auto whole = static_cast<long long>(seconds);
  return formatted("%lld:%02lld", whole / 60, whole % 60);
}

}  // namespace

Progress::Progress(double total) : terminal_(isatty(STDERR_FILENO) != 0), total_(total) {}

void Progress::begin(const std::string& part) {
  part_ = part;
  part_begun_ = Clock::now();
  if (terminal_) draw();
}

void Progress::done(double cost) {
  done_ += cost;
  if (!terminal_)
    std::fprintf(stderr, "%3.0f %%  %s  %.1f s\n", 100 * share(), part_.c_str(), seconds_since(part_begun_));
  else
    draw();
}

void Progress::say(const std::string& line) {
  clear();
  std::fprintf(stderr, "%s\n", line.c_str());
}

void Progress::draw() {
  const int filled = std::clamp(static_cast<int>(share() * bar_width), 0, bar_width);
  const std::string bar =
      std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(bar_width - filled), '.');
  const double spent = seconds_since(begun_);
  const std::string left = share() > 0.02 ? minutes(spent * (1 - share()) / share()) + " left" : minutes(spent);
  std::string line = formatted("[%s] %3.0f %%  %s  %s", bar.c_str(), 100 * share(), left.c_str(), part_.c_str());
  line.resize(std::min(line.size(), terminal_width() - 1));  // a wrapped line could not be overwritten
  std::fprintf(stderr, "\r%s\x1b[K", line.c_str());
  std::fflush(stderr);
  visible_ = true;
}

void Progress::clear() {
  if (!std::exchange(visible_, false)) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
}

}  // namespace bench
