// The text file of a law.
#pragma once

#include <memory>
#include <string>

#include "law/law.h"

namespace rc {

std::string text_of(const Law& law);
std::unique_ptr<rc_law> read_law(const char* path);  // evaluates to the same bits; throws Error(ARGUMENT)

}  // namespace rc
