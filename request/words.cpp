#include "request/words.h"

#include <roughcontact/registry.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "request/choices.h"
#include "request/targets.h"

namespace rc::request {

namespace {

constexpr std::int32_t every = every_call;
constexpr std::int32_t presses = every & ~RC_CALL_ANALYZE;
constexpr std::int32_t whole = every & ~RC_CALL_ROWS;
constexpr std::int32_t steps = RC_CALL_SOLVE | RC_CALL_HISTORY;
constexpr std::int32_t in_time = RC_CALL_HISTORY | RC_CALL_BATCH | RC_CALL_ROWS;
constexpr std::int32_t most_terms = 2000;  // numbers of a series
constexpr std::string_view alone = "a rank has some rows, and this needs others";
constexpr std::string_view elastic = "Elasticity (modulus, or E and nu)", loading = "Loading (one of)",
                           nothing = "nothing presses when a surface is analysed",
                           no_time = "one step alone, a law and an analysed surface have no time";

constexpr Word table[] = {
#define RC_REQUEST_WORD(name, kind, most, group, form, help, choices, example, calls, why_not) \
  {name, kind, most, group, form, help, choices, example, calls, why_not},
#include "request/words.def"
#undef RC_REQUEST_WORD
};

// Words of the field that are none of the table's, and those that mean the same.
constexpr std::pair<std::string_view, std::string_view> others[] = {
    {"force", "load"},    {"displacement", "approach"}, {"indentation", "approach"}, {"young", "E"},
    {"poisson", "nu"},    {"detrend", "remove"},        {"level", "remove"},         {"ball", "shape"},
    {"method", "solver"}, {"heights", "surface"}};

std::string as_key(std::string_view name) {
  std::string key(name);
  std::ranges::replace(key, '-', '_');
  std::ranges::replace(key, '.', '_');
  return key;
}

const char* call_name(std::int32_t call) {
  switch (call) {
    case RC_CALL_LAW:
      return "law";
    case RC_CALL_ANALYZE:
      return "analyze";
    case RC_CALL_BATCH:
      return "batch";
    case RC_CALL_ROWS:
      return "a contact of ranks";
    default:
      return "solve";
  }
}

// The key of an option of the library; the error for a word that is none names the nearest.
std::string option_key(const Spelling& spelling, const std::string& name, rc_context* context) {
  const std::string key = as_key(name);
  std::vector<std::string> known;
  const std::int64_t count = rc_component_count(context, RC_COMPONENT_OPTION);
  for (std::int64_t i = 0; i < count; ++i) {
    rc_component option = RC_COMPONENT_INIT;
    if (rc_component_describe(context, RC_COMPONENT_OPTION, i, &option) != RC_OK) continue;
    if (as_key(option.name) == key) return option.name;
    known.emplace_back(option.name);
  }
  for (const Word& word : table) known.emplace_back(word.name);
  std::string near = did_you_mean(name, known);
  for (const auto& [other, word] : others)
    if (name == other) near = join("; did you mean ", in_quotes(spelling.word(word)), "?");
  fail(RC_ERR_OPTION, spelling.word(name), " is neither a word nor an option of the library", near);
}

}  // namespace

std::span<const Word> all_words() { return table; }

const Word* find_word(std::string_view name) {
  const auto letter = [](char c) { return c == '-' ? '_' : c; };
  const auto found = std::ranges::find_if(
      table, [&](const Word& word) { return std::ranges::equal(word.name, name, std::ranges::equal_to{}, letter, letter); });
  return found == std::end(table) ? nullptr : found;
}

std::vector<std::string_view> names_in(std::string_view choices) {
  return choices.empty() ? std::vector<std::string_view>{} : split(choices, ' ');
}

std::string Spelling::word(std::string_view name) const {
  if (kind == RC_SPELLING_OPTION) return name == "surface" ? "SURFACE" : join("--", name);
  if (kind == RC_SPELLING_FIELD) return name == "surface" ? "z" : "opts." + as_key(name);
  if (kind == RC_SPELLING_KEYWORD) return name == "surface" ? "heights" : name == "gap" ? "undeformed_gap" : as_key(name);
  return std::string(name);
}

std::string Spelling::value(std::string_view name, std::string_view value) const {
  if (kind == RC_SPELLING_KEYWORD) return join(word(name), "='", value, "'");
  if (kind == RC_SPELLING_FIELD) return join(word(name), " = '", value, "'");
  return join(word(name), " ", value);
}

std::string Given::shown() const {
  if (text) return in_quotes(text);
  std::string list;
  for (std::size_t k = 0; k < std::min<std::size_t>(numbers.size(), 3); ++k) list += join(k == 0 ? "" : ", ", numbers[k]);
  return list + (numbers.size() > 3 ? ", ..." : "");
}

Words::Words(const rc_request_spec& spec, const Variation& variation)
    : spelling{spec.spelling}, call(spec.call), factor_(variation.factor) {
  for (std::int64_t k = 0; k < spec.n_words; ++k) {
    const rc_given& each = spec.words[k];
    if (!each.word || each.n < 0 || (!each.text && !(each.numbers && each.n > 0)))
      fail(RC_ERR_ARGUMENT, "rc_given: word ", k, " has ", each.word ? "no value" : "no name");
    Given given{each.word, find_word(each.word), each.text, {}};
    given.name = given.word ? std::string(given.word->name) : option_key(spelling, given.name, spec.context);
    if (!each.text) given.numbers = {each.numbers, static_cast<std::size_t>(each.n)};
    if (given.name != variation.replaced.first) given_.push_back(std::move(given));
  }
  if (variation.replaced.second)
    given_.push_back({variation.replaced.first, find_word(variation.replaced.first), variation.replaced.second, {}});
  const auto place = [](const Given& given) { return given.word ? given.word - table : std::ssize(table); };
  std::ranges::stable_sort(given_, {}, place);
  for (std::size_t k = 0; k < given_.size(); ++k) {
    const Given& given = given_[k];
    if (k > 0 && given.name == given_[k - 1].name) fail(RC_ERR_ARGUMENT, spelt(given.name), " is given twice");
    if (!given.word) continue;
    if ((given.word->calls & call) == 0)
      fail(RC_ERR_ARGUMENT, spelt(given.name), " is not a word of ", call_name(call), ": ", given.word->why_not);
    const bool numeric =
        (given.word->kind >= RC_WORD_LENGTH && given.word->kind <= RC_WORD_NUMBER) || given.word->kind == RC_WORD_TIME;
    if (!numeric && !given.text && given.word->kind != RC_WORD_OPTION)
      fail(RC_ERR_ARGUMENT, spelt(given.name), " is ", given.shown(), ", a text is needed, such as ",
           in_quotes(given.word->example));
    if (!given.word->choices.empty() && given.word->kind == RC_WORD_NAME && given.word->name != "unit") chosen(given.word->name);
    if (numeric) {
      const std::size_t limit =
          call == RC_CALL_SOLVE && given.word->most == most_targets ? 1 : static_cast<std::size_t>(given.word->most);
      const std::size_t count =
          given.text ? (limit == 1 || given.word->most <= 2 ? split(given.text, ',').size() : 0) : given.numbers.size();
      if (count > limit && given.word->most == most_targets && call == RC_CALL_SOLVE)
        fail(RC_ERR_ARGUMENT, spelt(given.name), " has ", count,
             " values, and one step is solved here; a history solves one step for each");
      if (count > limit && given.word->most <= 2)
        fail(RC_ERR_ARGUMENT, spelt(given.name), ": ", given.shown(), " has ", count, " numbers, give ",
             given.word->form.empty() ? "one" : given.word->form);
    }
  }
}

const Given* Words::find(std::string_view name) const {
  const auto found = std::ranges::find_if(given_, [name](const Given& each) { return each.word && each.word->name == name; });
  return found == given_.end() ? nullptr : &*found;
}

std::vector<Quantity> Words::quantities(const Given& given, Dimension dimension, double unit) const {
  const std::string option = spelt(given.name);
  std::vector<Quantity> found;
  if (given.text && given.word->most == most_targets) {
    found = read_targets(option, given.text, dimension, unit);
  } else if (given.text) {
    found = read_quantities(option, split(given.text, ','), dimension, unit);
  }
  for (const double number : given.numbers) {
    if (!std::isfinite(number)) throw Error(option, ": ", number, " is not finite");
    found.push_back({number, unit, true});
  }
  for (Quantity& each : found) each.number *= factor(given.name);
  return found;
}

Quantity Words::positive(const Given& given, Dimension dimension, double unit) const {
  const std::vector<Quantity> found = quantities(given, dimension, unit);
  for (const Quantity& each : found)
    if (!(each.number > 0)) throw Error(spelt(given.name), ": ", given.shown(), " is not positive");
  return found.front();
}

std::size_t Words::chosen(std::string_view name, std::size_t otherwise) const {
  const Given* const given = find(name);
  return given ? choice(spelt(name), given->text, names_in(given->word->choices)) : otherwise;
}

}  // namespace rc::request
