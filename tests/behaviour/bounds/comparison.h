// Compares an answer's proven bounds with the exact solution at its approach.
#pragma once

#include "support/contact.h"

namespace pairs {

/** Solves the problem at the given approach to round-off. Without a solution there (periodic, at the mean plane): status < 0. */
Answer exact_at(const Problem& problem, double approach);

/** Fails if a statement of the answer is not true of the exact solution. */
void check_proofs(const Problem& problem, const Answer& answer, const Answer& exact);

/** Half the width of the load interval over the error of the load, and undecided points over contacts. */
struct Tightness {
  double load = 0, undecided = 0;
};
Tightness tightness(const Answer& answer, const Answer& exact);

}  // namespace pairs
