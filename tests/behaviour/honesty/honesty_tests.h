#pragma once

#include <vector>

#include "support/harness.h"

namespace pairs {

std::vector<Test> near_the_mean_plane();
std::vector<Test> far_datums();
std::vector<Test> remarks();
std::vector<Test> not_definite();
std::vector<Test> first_causes();

}  // namespace pairs
