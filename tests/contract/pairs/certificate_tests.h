// A part of pairs.certificate.
#pragma once

#include <vector>

#include "support/harness.h"

namespace pairs {

std::vector<Test> tests_of_liars();

}  // namespace pairs
