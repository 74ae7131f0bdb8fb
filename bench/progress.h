// How far a long run has come, on standard error: a bar where that is a terminal, else a line for each part.
#pragma once

#include <string>

#include "stopwatch.h"

namespace bench {

class Progress {
 public:
  // total: of the costs of all parts, in any unit.
  explicit Progress(double total);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void begin(const std::string& part);
  void done(double cost);
  // A line above the bar.
  void say(const std::string& line);

 private:
  void draw();
  void clear();
  double share() const { return total_ > 0 ? done_ / total_ : 1; }

  const bool terminal_;
  const double total_;
  double done_ = 0;
  bool visible_ = false;
  std::string part_;
  const Clock::time_point begun_ = Clock::now();
  Clock::time_point part_begun_ = begun_;
};

}  // namespace bench
