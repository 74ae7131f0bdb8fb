#include "files/step_table.h"

#include <iomanip>
#include <sstream>

#include "files/step_fields.h"
#include "text.h"

namespace cli {

namespace {

// As RFC 4180 has it: a text that could be taken apart stands in quotes, and a quote in it is doubled.
std::string cell(const JsonValue& value) {
  if (!std::holds_alternative<std::string>(value)) {
    const std::string number = dumped(value);
    return number == "null" ? "" : number;  // also where it is not finite
  }
  const auto& text = std::get<std::string>(value);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::ostringstream quoted;
  quoted << std::quoted(text, '"', '"');
  return quoted.str();
}

}  // namespace

void StepTable::add(std::span<const JsonEntry> step) {
  std::string header = "step", row = std::to_string(++rows_);
  for (const JsonEntry& field : step) {
    const std::string name{name_of(field)}, unit{unit_of(name)};
    header += format(unit.empty() ? ",%s" : ",%s [%s]", name.c_str(), unit.c_str());
    row.append(1, ',').append(cell(field.value));
  }
  if (text_.empty()) text_ = header + "\n";
  text_ += row + "\n";
}

}  // namespace cli
