#include "core/usable_cores.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "core/limits.h"
#include "platform/cores.h"

namespace rc {

std::optional<std::int64_t> openmp_limit(std::string_view text) {
  constexpr std::string_view blanks = " \t\n\v\f\r";
  std::optional<std::int64_t> first;
  for (;;) {
    const auto comma = text.find(',');
    std::string_view word = text.substr(0, comma);
    word.remove_prefix(std::min(word.find_first_not_of(blanks), word.size()));
    word = word.substr(0, word.find_last_not_of(blanks) + 1);
    if (word.starts_with('+')) word.remove_prefix(1);
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || number < 1) return std::nullopt;
    if (!first) first = number;
    if (comma == std::string_view::npos) return first;
    text.remove_prefix(comma + 1);
  }
}

std::int64_t usable_cores(std::int64_t allowed) {
  std::int64_t cores = std::min<std::int64_t>(allowed > 0 ? allowed : rc_platform::allowed_cores(), most_threads);
  if (const std::int64_t granted = rc_platform::granted_cores(); granted > 0) cores = std::min(cores, granted);
  for (const char* const name : {"OMP_THREAD_LIMIT", "OMP_NUM_THREADS"})
    if (const char* const text = std::getenv(name)) cores = std::min(cores, openmp_limit(text).value_or(cores));
  return cores;
}

}  // namespace rc
