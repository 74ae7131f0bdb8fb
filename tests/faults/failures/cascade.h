// Cascade multi-resolution on one surface, judged against the whole problem.
#pragma once

#include "atlas.h"

namespace failures {

struct Cascade {
  Answer full, plain, certified;
  double plain_error = 0;  // of the load, relative
  long long rounds = 0;    // of the certified one
};

// Three grids, radius 1.5 cells, as for the measured surfaces of the paper. Fails unless the certified answer is that of the
// whole problem, found within three rounds, and the plain one admits what it is.
Cascade check_cascade(const Problem& problem, const std::string& filter);

}  // namespace failures
