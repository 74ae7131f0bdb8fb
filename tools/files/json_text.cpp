#include "files/json_text.h"

#include <nlohmann/json.hpp>

namespace cli {

namespace {

// Collects the values in the order in which the parser meets them.
class Collector {
 public:
  std::vector<JsonEntry> entries;

  bool null() { return put(nullptr); }
  bool boolean(bool value) { return put(value); }
  bool number_integer(std::int64_t value) { return put(value); }
  bool number_unsigned(std::uint64_t value) {
    return std::in_range<std::int64_t>(value) ? put(static_cast<std::int64_t>(value)) : put(static_cast<double>(value));
  }
  bool number_float(double value, const std::string&) { return put(value); }
  bool string(std::string& value) { return put(std::move(value)); }
  bool binary(nlohmann::json::binary_t&) { return false; }
  bool key(std::string& name) {
    levels_.back().name = std::move(name);
    return true;
  }
  bool start_object(std::size_t) { return open(false); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(true); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) { return false; }

 private:
  struct Level {
    bool array;
    std::string name;        // of the value to come
    std::int64_t index = 0;  // of it in an array
  };
  static constexpr std::size_t deepest = 8;

  bool open(bool array) {
    levels_.push_back({array, {}});
    return levels_.size() <= deepest;
  }
  bool close() {
    levels_.pop_back();
    count();
    return true;
  }
  void count() {
    if (!levels_.empty()) ++levels_.back().index;
  }
  bool put(JsonValue value) {
    std::string place;
    for (const Level& level : levels_) place += "/" + (level.array ? std::to_string(level.index) : level.name);
    entries.push_back({std::move(place), std::move(value)});
    count();
    return true;
  }

  std::vector<Level> levels_;
};

}  // namespace

double number_in(const JsonValue& value, double otherwise) {
  if (const auto* const whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  const auto* const real = std::get_if<double>(&value);
  return real ? *real : otherwise;
}

std::string dumped(const JsonValue& value) {
  const auto json = std::visit([](const auto& held) { return nlohmann::json(held); }, value);
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void JsonText::next(const char* key) {
  if (closing_.empty()) return;
  text_ += empty_ ? "\n" : ",\n";
  text_.append(2 * closing_.size(), ' ');
  if (key) text_ += dumped(key) + ": ";
  empty_ = false;
}

void JsonText::begin(const char* key, char bracket) {
  next(key);
  text_ += bracket;
  closing_ += bracket == '{' ? '}' : ']';
  empty_ = true;
}

void JsonText::end() {
  const char bracket = closing_.back();
  closing_.pop_back();
  if (!empty_) text_.append("\n").append(2 * closing_.size(), ' ');
  text_ += bracket;
  empty_ = false;
}

void JsonText::add(const char* key, const JsonValue& value) {
  next(key);
  text_ += dumped(value);
}

void JsonText::add(std::initializer_list<JsonField> fields) {
  for (const auto& [key, value] : fields) add(key, value);
}

std::string JsonText::text() const {
  JsonText ended = *this;
  while (!ended.closing_.empty()) ended.end();
  return std::move(ended.text_) + "\n";
}

std::optional<std::vector<JsonEntry>> read_json(const std::string& text) {
  Collector collector;
  if (!nlohmann::json::sax_parse(text, &collector)) return std::nullopt;
  return std::move(collector.entries);
}

}  // namespace cli
