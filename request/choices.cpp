#include "request/choices.h"

#include <algorithm>

#include "request/names.h"

namespace rc::request {

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  constexpr std::size_t least = 3;  // letters of a name that begins the word, as --tol does --tolerance
  const auto letters = [](std::string_view name) { return name.substr(std::min(name.find_first_not_of('-'), name.size())); };
  const std::string near = rc::suggestion(word, names);
  if (!near.empty()) return near;
  for (const std::string& name : names) {
    if (letters(name).size() >= least && letters(word).starts_with(letters(name))) return rc::suggestion(name, {&name, 1});
  }
  return "";
}

std::size_t choice(std::string_view option, std::string_view name, std::span<const std::string_view> names) {
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string all;
  for (std::size_t k = 0; k < names.size(); ++k) {
    all += (k == 0 ? "" : k + 1 < names.size() ? ", " : " or ") + std::string(names[k]);
  }
  throw Error(option, ": ", in_quotes(name), " is not known", did_you_mean(name, {names.begin(), names.end()}), "; give ", all);
}

}  // namespace rc::request
