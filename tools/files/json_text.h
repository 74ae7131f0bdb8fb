// JSON as text, without a tree of values: nlohmann's trees allocate while they are destroyed, which ends the process if memory
// has run out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cli {

using JsonValue = std::variant<std::nullptr_t, bool, std::int64_t, double, std::string>;
using JsonField = std::pair<const char*, JsonValue>;

// The value as a number; otherwise: where it is none.
double number_in(const JsonValue& value, double otherwise);

// The value as it stands in a document. A number that is not finite is null. Text need not be UTF-8.
std::string dumped(const JsonValue& value);

// A document in the making, indented by two.
class JsonText {
 public:
  JsonText() { begin(nullptr); }

  // Begins an object or array of this name, which lasts up to its end(). key: null within an array.
  void begin(const char* key, char bracket = '{');
  void end();
  void add(const char* key, const JsonValue& value);
  void add(std::initializer_list<JsonField> fields);
  template <class Number> void add(const char* key, const std::vector<Number>& values) {
    begin(key, '[');
    for (const Number& value : values) add(nullptr, JsonValue(value));
    end();
  }

  // The document, with every object and array ended.
  std::string text() const;

 private:
  void next(const char* key);

  std::string text_;
  std::string closing_;  // brackets, the outermost first
  bool empty_ = true;    // the innermost object or array is empty
};

// A value of a document and its place: "/steps/0/load".
struct JsonEntry {
  std::string place;
  JsonValue value;
};

// The values of a document in their order; nothing if the text is no JSON, or nested more deeply than anything written here.
std::optional<std::vector<JsonEntry>> read_json(const std::string& text);

}  // namespace cli
