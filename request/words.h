// The table of words, and those that a caller gave.
#pragma once

#include <roughcontact/request.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "request/names.h"
#include "request/quantities.h"
#include "request/variation.h"

namespace rc::request {

constexpr std::int32_t every_call =
    RC_CALL_SOLVE | RC_CALL_HISTORY | RC_CALL_BATCH | RC_CALL_LAW | RC_CALL_ANALYZE | RC_CALL_ROWS;

struct Word {
  std::string_view name;
  std::int32_t kind, most;
  std::string_view group, form, help, choices, example;
  std::int32_t calls;
  std::string_view why_not;
};

std::span<const Word> all_words();
const Word* find_word(std::string_view name);  // null: the table does not have it

// Names between spaces.
std::vector<std::string_view> names_in(std::string_view choices);

// How messages spell a word, "--nu2", and a word with its value, "--missing fill".
struct Spelling {
  std::int32_t kind = RC_SPELLING_PLAIN;

  std::string word(std::string_view name) const;
  std::string value(std::string_view name, std::string_view value) const;
};

// A word with its value.
struct Given {
  std::string name;            // as the caller wrote it
  const Word* word = nullptr;  // null: an option of the library
  const char* text = nullptr;  // null: numbers
  std::span<const double> numbers{};

  std::string shown() const;  // the value, for messages
};

// The words of a call, checked against the table; their order is the table's. Throws at the first that is wrong.
class Words {
 public:
  Words(const rc_request_spec& spec, const Variation& variation);

  Spelling spelling;
  std::int32_t call;

  const Given* find(std::string_view name) const;
  std::span<const Given> all() const { return given_; }
  std::string spelt(std::string_view name) const { return spelling.word(name); }

  // The numbers of a length, pressure, force or share; of a length without a unit in `unit`.
  std::vector<Quantity> quantities(const Given& given, Dimension dimension, double unit = 1) const;
  // By which the numbers of a word are multiplied.
  double factor(std::string_view word) const { return word == factor_.first ? factor_.second : 1; }
  // A pressure above 0.
  Quantity positive(const Given& given, Dimension dimension, double unit = 1) const;
  // The place of a word's value among its choices; `otherwise` if it was not given.
  std::size_t chosen(std::string_view name, std::size_t otherwise = 0) const;

 private:
  std::vector<Given> given_;
  std::pair<std::string, double> factor_;
};

}  // namespace rc::request
