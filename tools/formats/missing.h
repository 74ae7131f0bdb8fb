// Points that were not measured: NaN in the heights.
#pragma once

#include <cstdint>
#include <string_view>

#include "formats/surface.h"

namespace cli {

enum class MissingRule { reject, fill, exclude };
inline constexpr std::string_view missing_rule_names[] = {"reject", "fill", "exclude"};

// "reject", "fill" or "exclude", given for --missing.
MissingRule parse_missing_rule(std::string_view name);

std::int64_t count_missing(const Surface& surface);

// Throws an Error that counts the missing points and says what can be done. can_exclude: whether --missing exclude is possible.
[[noreturn]] void reject_missing(const Surface& surface, std::int64_t count, bool can_exclude);

// Harmonic interpolation: every missing point becomes the mean of its neighbours, weighted by distance^-2, like a soap film over
// a hole. Filled heights lie between those around the hole, so no summit is invented. The pitch must be known.
void fill_missing(Surface& surface);

}  // namespace cli
