// gnuplot as a child process.
#pragma once

#include <cstdio>
#include <string>

namespace cli {

struct Gnuplot {
  bool drawn = false;
  bool missing = false;  // there is no gnuplot on the search path
  std::string message;   // why it failed
};

// Runs gnuplot on a script with inline data. What it draws without `set output` goes to the picture. Throws an Error if
// that is cut off.
Gnuplot run_gnuplot(const std::string& script, std::FILE* picture);

}  // namespace cli
