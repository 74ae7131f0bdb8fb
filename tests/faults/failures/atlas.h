// Problems, trusted answers and checks that the tests of this folder share.
#pragma once

#include <string>
#include <vector>

#include "failure_scenes.h"
#include "support/contact.h"
#include "support/registry.h"

namespace failures {

// The trusted answer: by nnls on the dense backend, to 1e-12.
Answer truth_of(const Problem& problem);

// Every solver of the registry that runs on this backend.
std::vector<std::string> solvers_on(const std::string& backend, const Problem& problem);

// Certified and right, or a status that says it is not: never RC_OK with pressures off by more than `tolerance` of the largest.
void check_honest(const Answer& answer, const Field& truth, double tolerance, const std::string& what);

double difference(const Field& a, const Field& b);  // largest |a - b| over largest |b|

}  // namespace failures
