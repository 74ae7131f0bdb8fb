// The reference cases of tests/data/cases/capped: loading histories with a hardness, solved by a dense active set elsewhere.
#pragma once

#include <string>
#include <vector>

#include "support/contact.h"

namespace pairs {

struct CappedStep {
  double target = 0, approach = 0, load = 0, plastic_volume = 0;
  std::int64_t contacts = 0, capped = 0;
  Field p, overlap;
};

struct CappedCase {
  std::string name;
  Problem problem;  // of the first step
  std::vector<CappedStep> steps;
};

std::vector<CappedCase> read_capped_cases();

/** Solvers that keep the hardness on this backend, in both controls; empty: the backend cannot do the system. */
std::vector<std::string> capped_solvers(const std::string& backend, const rc_system& system);

}  // namespace pairs
