// The compliance of bodies that creep, over that at once: 1 + sum of ratio (1 - exp(-t / time)) over the terms.
#pragma once

#include <roughcontact/roughcontact.h>

#include <vector>

namespace rc {

struct PronyTerm {
  double ratio;  // >= 0
  double time;   // [time]
};

// The terms of this system, with moduli turned into compliances; empty: it is elastic. Throws Error(ARGUMENT).
std::vector<PronyTerm> prony_terms(const rc_system& system);

}  // namespace rc
