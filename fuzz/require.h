// A check in a fuzz target.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace fuzz {

/** Ends the process with these words where `holds` is false. */
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

}  // namespace fuzz
