// The parts of a law that slip needs, and the numbers of friction.
#pragma once

#include "law/law.h"

namespace rc {

void check_slips(const Law& law);                           // throws for a law from which no slip follows
void check_friction(double mu, double nu, const char* of);  // of: the struct, for the message

}  // namespace rc
