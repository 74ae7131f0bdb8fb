#include "core/text.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <numeric>

namespace rc {

std::string in_digits(double value, int significant) {
  char digits[32];
  return {digits, std::to_chars(digits, std::end(digits), value, std::chars_format::general, significant).ptr};
}

void TextPart::append_to(std::string& text) const {
  char digits[32];
  std::to_chars_result end{digits, {}};
  switch (kind_) {
    case Kind::text:
      text += text_;
      return;
    case Kind::letter:
      text += letter_;
      return;
    case Kind::real:
      text += in_digits(real_, 12);
      return;
    case Kind::integer:
      end = std::to_chars(digits, std::end(digits), integer_);
      break;
    case Kind::count:
      end = std::to_chars(digits, std::end(digits), count_);
      break;
    case Kind::address:
      text += "0x";
      end = std::to_chars(digits, std::end(digits), reinterpret_cast<std::uintptr_t>(address_), 16);
  }
  text.append(digits, end.ptr);
}

std::string joined(std::initializer_list<TextPart> parts) {
  std::string text;
  for (const TextPart& part : parts) part.append_to(text);
  return text;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (size_t begin = 0;;) {
    const size_t end = text.find(separator, begin);
    parts.emplace_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

namespace {

template <class Number> std::optional<Number> parse(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Levenshtein distance, one row at a time.
size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 0; i < a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i + 1;
    for (size_t j = 0; j < b.size(); ++j) {
      const size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::optional<double> parse_real(std::string_view text) { return parse<double>(text); }
std::optional<long long> parse_int(std::string_view text) { return parse<long long>(text); }

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
  const std::string* nearest = nullptr;
  const size_t letters = word.size() - std::min(word.find_first_not_of('-'), word.size());
  size_t least = std::max<size_t>(1, (letters + 2) / 3) + 1;  // a third of the letters may be wrong
  for (const std::string& candidate : candidates) {
    const bool abbreviated = word.size() >= 3 && std::string_view(candidate).starts_with(word);
    const size_t distance = abbreviated ? 1 : edit_distance(word, candidate);
    if (distance < least) {
      least = distance;
      nearest = &candidate;
    }
  }
  return nearest ? join("; did you mean \"", *nearest, "\"?") : std::string();
}

}  // namespace rc
