#include "formats/text_rows.h"

#include <algorithm>
#include <string>

#include "formats/numbers.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

std::vector<std::string_view> words(std::string_view line) {
  constexpr std::string_view space = " \t\r\f\v";
  std::vector<std::string_view> found;
  for (auto first = line.find_first_not_of(space); first != std::string_view::npos;) {
    const auto end = std::min(line.find_first_of(space, first), line.size());
    found.push_back(line.substr(first, end - first));
    first = line.find_first_not_of(space, end);
  }
  return found;
}

}  // namespace

std::string_view take_line(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  const auto line = trimmed(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::vector<std::string_view> row_fields(std::string_view line) {
  for (const char separator : {';', ','}) {
    if (line.find(separator) == std::string_view::npos) continue;
    auto parts = split(line, separator);
    if (trimmed(parts.back()).empty()) parts.pop_back();  // a separator may end the line
    return parts;
  }
  return words(line);
}

bool is_missing_mark(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 7 || text.empty()) return false;
  std::string lower{text};
  std::ranges::transform(lower, lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return lower == "nan" || lower == "bad" || lower == "no data" || lower.find_first_not_of('*') == std::string::npos;
}

}  // namespace rc::formats
