#include "formats/column_names.h"

#include <algorithm>
#include <optional>
#include <string>

#include "core/text.h"
#include "formats/numbers.h"
#include "formats/text_rows.h"
#include "formats/units.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

constexpr std::string_view opening = "[({<", closing = "])}>";

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
}

bool is_one_of(std::string_view word, std::string_view list) { return list.find(join("|", word, "|")) != list.npos; }

constexpr std::string_view of_heights =
    "|height|heights|hoehe|hoehen|h\xc3\xb6he|h\xf6he|h\xc3\xb6hen|h\xf6hen|topography|topographie|elevation|hauteur|altezza|"
    "altura|";
constexpr std::string_view of_all = "|all|length|lengths|coordinates|unit|units|einheit|";
constexpr std::string_view of_values = "|value|values|data|";
constexpr std::string_view of_time = "|am|pm|";
constexpr std::string_view known_words[] = {of_heights, of_all, of_values, "|of|the|are|is|given|surface|der|"};

// Words in lower case: runs of letters and digits.
std::vector<std::string> letters_of(std::string_view name) {
  std::vector<std::string> found;
  const std::string lower = lower_case(name);
  for (auto first = std::ranges::find_if(lower, is_letter); first != lower.end();) {
    const auto end = std::find_if_not(first, lower.end(), is_letter);
    found.emplace_back(first, end);
    first = std::find_if(end, lower.end(), is_letter);
  }
  return found;
}

Axis axis_of(std::string_view name) {
  bool x = false, y = false, z = false, heights = false, all = false, values = false;
  for (const std::string& word : letters_of(name)) {
    x |= word == "x";
    y |= word == "y";
    z |= word == "z";
    heights |= is_one_of(word, of_heights);
    all |= is_one_of(word, of_all);
    values |= is_one_of(word, of_values);
  }
  if (x + y + z == 1) return x ? Axis::x : y ? Axis::y : Axis::z;
  if (x || y || z) return Axis::none;
  if (heights) return Axis::z;
  return all ? Axis::all : values ? Axis::z : Axis::none;
}

Label labelled(std::string_view name, std::string_view unit) {
  name = trimmed(name);
  while (name.ends_with(':') || name.ends_with('=')) name = trimmed(name.substr(0, name.size() - 1));
  return {name, trimmed(unit), axis_of(name)};
}

bool is_word(std::string_view text) { return !text.empty() && text.find_first_of(" \t0123456789") == text.npos; }

// Whether a word beside a name is a unit: "m" and "A" are names as well.
bool is_sure_unit(std::string_view word) { return word.size() > 1 && metres_per(word); }

std::size_t first_bracket(std::string_view text) { return std::min(text.find_first_of(opening), text.size()); }

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> found;
  while (!(line = trimmed(line)).empty()) {
    found.push_back(line.substr(0, line.find(' ')));
    line.remove_prefix(found.back().size());
  }
  return found;
}

// Words, with the units that follow each of them; units alone, if there is nothing else.
std::vector<std::string_view> words_with_units(std::string_view line) {
  const auto words = words_of(line);
  if (std::ranges::all_of(words, [](std::string_view word) { return metres_per(word).has_value(); })) return words;
  std::vector<std::string_view> found;
  bool attach = false;
  for (const std::string_view word : words) {
    const bool slash = word == "/" || word == "in";
    if (!found.empty() && (attach || slash || word.front() == '/' || is_sure_unit(word))) {
      std::string_view& last = found.back();
      last = std::string_view(last.data(), static_cast<std::size_t>(word.data() + word.size() - last.data()));
    } else {
      found.push_back(word);
    }
    attach = slash || word.ends_with('/');
  }
  return found;
}

// Pieces that end with a closing bracket.
std::vector<std::string_view> bracketed(std::string_view line) {
  std::vector<std::string_view> found;
  while (!(line = trimmed(line)).empty()) {
    const auto end = line.find_first_of(closing, first_bracket(line));
    found.push_back(line.substr(0, end == line.npos ? end : end + 1));
    line.remove_prefix(found.back().size());
  }
  return found;
}

std::vector<Label> all_of(const std::vector<std::string_view>& pieces) {
  std::vector<Label> labels;
  for (const std::string_view piece : pieces) labels.push_back(label_of(piece));
  return labels;
}

}  // namespace

Label label_of(std::string_view text) {
  text = without_quotes(text);
  if (!text.empty()) {
    const auto kind = closing.find(text.back());
    const auto open = kind == closing.npos ? text.npos : text.rfind(opening[kind]);
    if (open != text.npos) {
      const auto inner = trimmed(text.substr(open + 1, text.size() - open - 2));
      if (!inner.empty() && !to_number(inner)) return labelled(text.substr(0, open), inner);
    }
  }
  for (const std::string_view mark : {"/", " in ", " ", "_"}) {
    const auto at = text.rfind(mark);
    if (at == text.npos || at == 0) continue;
    const auto name = text.substr(0, at), unit = trimmed(text.substr(at + mark.size()));
    const bool asked = mark == "/" || mark == " in ";
    if ((asked && is_word(unit) && axis_of(name) != Axis::none) || (asked ? metres_per(unit).has_value() : is_sure_unit(unit)))
      return labelled(name, unit);
  }
  if (axis_of(text) == Axis::none && text != "A" && metres_per(text)) return {"", text, Axis::none};
  return labelled(text, "");
}

bool Labels::all_named() const {
  return std::ranges::none_of(each, [](const Label& label) { return label.axis == Axis::none; });
}

bool Labels::all_clear() const { return std::ranges::all_of(each, is_clear); }

bool Labels::all_or_no_units() const {
  const auto with = [](const Label& label) { return label.axis != Axis::none && !label.unit.empty(); };
  const auto without = [](const Label& label) { return label.axis != Axis::none && label.unit.empty(); };
  return !std::ranges::any_of(each, with) || !std::ranges::any_of(each, without);
}

Labels labels_of(std::string_view line) {
  for (const char separator : {';', '\t', ','}) {
    if (line.find(separator) == line.npos) continue;
    auto parts = split(line, separator);
    if (trimmed(parts.back()).empty()) parts.pop_back();
    return {all_of(parts), separator};
  }
  const bool brackets = first_bracket(line) < line.size();
  Labels labels{all_of(brackets ? bracketed(line) : words_with_units(line)), ' '};
  const auto with_unit = [](const Label& label) { return metres_per(label.unit).has_value(); };
  const bool one_name = std::ranges::any_of(labels.each, [](const Label& label) { return label.axis == Axis::all; });
  if (one_name || (!labels.all_named() && !std::ranges::all_of(labels.each, with_unit))) labels.each = {label_of(line)};
  return labels;
}

bool is_clear(const Label& label) {
  const auto words = letters_of(label.name);
  if (!words.empty() && words.back().find_first_not_of("0123456789") == std::string::npos) return false;
  const auto is_axis = [](const std::string& word) { return is_one_of(word, "|x|y|z|"); };
  return std::ranges::any_of(words, is_axis) || std::ranges::all_of(words, [](const std::string& word) {
           return std::ranges::any_of(known_words, [&](std::string_view list) { return is_one_of(word, list); });
         });
}

bool mentions_unit(std::string_view line) {
  for (std::string_view rest = line.substr(first_bracket(line)); !rest.empty(); rest = rest.substr(first_bracket(rest))) {
    rest.remove_prefix(1);
    if (is_sure_unit(trimmed(rest.substr(0, rest.find_first_of(closing))))) return true;
  }
  const auto begins_with_digit = [](std::string_view word) {
    return !word.empty() && word.front() >= '0' && word.front() <= '9';
  };
  const auto words = letters_of(line);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool of_number =
        (i > 0 && begins_with_digit(words[i - 1])) || (i + 1 < words.size() && begins_with_digit(words[i + 1]));
    if (!of_number && is_sure_unit(words[i]) && !is_one_of(words[i], of_time)) return true;
  }
  return false;
}

}  // namespace rc::formats
