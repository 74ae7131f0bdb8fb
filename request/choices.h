// Names from which one is to be chosen.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rc::request {

// `; did you mean "x"?` for the name nearest to the word, "" if none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

// The place of a name in the list. The Error for one that is not there lists all and suggests the nearest.
std::size_t choice(std::string_view option, std::string_view name, std::span<const std::string_view> names);

}  // namespace rc::request
