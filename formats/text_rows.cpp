#include "formats/text_rows.h"

#include <algorithm>
#include <string>

#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/readers.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

constexpr std::string_view blanks = " \t\f\v";

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> found;
  for (auto first = line.find_first_not_of(blanks); first != std::string_view::npos;) {
    const auto end = std::min(line.find_first_of(blanks, first), line.size());
    found.push_back(line.substr(first, end - first));
    if (found.size() > 1 && lower_case(found.back()) == "data" && lower_case(found[found.size() - 2]) == "no") {  // one mark
      found.pop_back();
      found.back() = std::string_view(found.back().data(), static_cast<std::size_t>(line.data() + end - found.back().data()));
    }
    first = line.find_first_not_of(blanks, end);
  }
  return found;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Whether every comma of a line with white space between its fields is followed by a digit and no field has two.
bool has_decimal_commas(std::string_view line, const std::vector<std::string_view>& fields) {
  if (fields.size() < 2 || line.find('.') != std::string_view::npos) return false;
  return std::ranges::all_of(fields, [](std::string_view field) {
    const auto comma = field.find(',');
    return comma == std::string_view::npos ||
           (comma + 1 < field.size() && is_digit(field[comma + 1]) && field.find(',', comma + 1) == std::string_view::npos);
  });
}

// Refuses "0,5, 1,5": each comma may be a decimal mark, or separate two whole numbers.
void refuse_unclear_commas(std::string_view line) {
  if (line.find(',') == std::string_view::npos || line.find('.') != std::string_view::npos) return;
  const auto found = words(line);
  if (found.size() < 2) return;
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::string_view word = found[i];
    if (i + 1 < found.size() && !word.ends_with(',')) return;
    if (word.ends_with(',')) word.remove_suffix(1);
    const auto comma = word.find(',');
    if (comma == 0 || comma == std::string_view::npos || !is_digit(word[comma - 1]) || comma + 1 == word.size() ||
        word.find_first_not_of("0123456789eE+-", comma + 1) != std::string_view::npos)
      return;
  }
  throw Error("in ", in_quotes(line), " a comma may be a decimal mark or separate numbers: write decimal points");
}

}  // namespace

std::string_view without_quotes(std::string_view field) {
  field = trimmed(field);
  const bool quoted = field.size() > 1 && field.front() == '"' && field.back() == '"';
  return quoted ? trimmed(field.substr(1, field.size() - 2)) : field;
}

std::string_view take_line(std::string_view& text) { return trimmed(take_whole_line(text)); }

std::string_view take_whole_line(std::string_view& text) {
  const auto end = std::min(text.find_first_of("\r\n"), text.size());
  const auto line = text.substr(0, end);
  // CR CR LF, which editors make of CR LF, ends one line.
  const auto after = std::min(text.find_first_not_of('\r', end), text.size());
  const bool feed = after < text.size() && text[after] == '\n';
  text.remove_prefix(feed ? after + 1 : std::min(end + 1, text.size()));
  return line;
}

std::vector<std::string_view> row_fields(std::string_view line) {
  if (line.find(';') != std::string_view::npos) return split(line, ';');
  if (line.find('\t') != std::string_view::npos) {
    const auto fields = split(line, '\t');
    const auto single = [](std::string_view field) {
      field = trimmed(field);
      return field.find_first_of(field.starts_with('"') ? "," : " ,") == std::string_view::npos || field_number(field) ||
             is_missing_mark(field);
    };
    if (std::ranges::all_of(fields, single)) return fields;
  }
  const auto found = words(line);
  if (line.find(',') == std::string_view::npos || has_decimal_commas(line, found)) return found;
  refuse_unclear_commas(line);
  return split(line, ',');
}

std::optional<double> field_number(std::string_view field) {
  field = without_quotes(field);
  if (const auto value = to_number(field)) return value;
  std::string plain{field};
  if (plain.find('.') == std::string::npos && std::ranges::count(plain, ',') == 1) plain[plain.find(',')] = '.';
  const auto exponent = plain.find_first_of("dD");
  if (exponent != std::string::npos && exponent > 0 && (is_digit(plain[exponent - 1]) || plain[exponent - 1] == '.'))
    plain[exponent] = 'e';
  return to_number(plain);
}

bool is_missing_mark(std::string_view text) {
  text = without_quotes(text);
  if (text.size() > 9 || text.empty()) return false;
  const std::string lower = lower_case(text);
  // The last ones are what Microsoft's C library writes for NaN and infinity.
  for (const std::string_view mark : {"nan", "bad", "no data", "n/a", "#n/a", "void", "masked", "1.#qnan", "1.#ind", "1.#inf"}) {
    if (lower == mark || (lower.front() == '-' && lower.substr(1) == mark)) return true;
  }
  return lower.find_first_not_of('*') == std::string::npos ||
         (lower.size() > 1 && lower.find_first_not_of('-') == std::string::npos);
}

void check_text(std::string_view file) {
  constexpr std::size_t looked_at = 4096;
  const std::string_view begin = file.substr(0, looked_at);
  const auto odd = std::ranges::find_if(begin, [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 && std::string_view("\t\n\v\f\r\x1a").find(c) == std::string_view::npos;
  });
  if (odd == begin.end()) return;
  throw Error("the file is binary, not text: byte ", odd - begin.begin(), " is ", static_cast<unsigned char>(*odd), "; ",
              other_readers);
}

}  // namespace rc::formats
