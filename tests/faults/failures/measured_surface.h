// Surfaces from files, and the library's verdict on whether a cascade finds their contacts.
#pragma once

#include <string>

#include "failure_scenes.h"

namespace failures {

// Approach half of the height of the highest point above the mean. Any format that the command reads; throws.
Problem measured_problem(const std::string& file);

struct CmrVerdict {
  bool trustworthy = false;
  double unresolved = 0;
};
CmrVerdict cmr_verdict(const Problem& problem, std::int32_t halvings);

}  // namespace failures
