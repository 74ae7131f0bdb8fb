// The text file of a law.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "law/law.h"

namespace rc {

inline constexpr std::string_view law_file_begins = "roughcontact-law ";
inline constexpr std::uint64_t law_file_most = 4'000'000'000;  // bytes: a law has at most ten million nodes

std::string text_of(const Law& law);
std::unique_ptr<Law> law_of(std::string_view text);  // evaluates to the same bits; throws Error(ARGUMENT)

}  // namespace rc
