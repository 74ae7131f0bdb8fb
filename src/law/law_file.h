// The text file of a law.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "law/law.h"

namespace rc {

std::string text_of(const Law& law);
std::unique_ptr<Law> law_of(std::string_view text);  // evaluates to the same bits; throws Error(ARGUMENT)

}  // namespace rc
