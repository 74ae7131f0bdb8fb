#include "arguments/command.h"

#include <sstream>

namespace cli {

std::vector<std::string> names_of(const Option& option) {
  std::vector<std::string> names;
  std::istringstream text(option.name);
  for (std::string name; std::getline(text, name, ',');) names.push_back(name);
  return names;
}

bool given(const Option& option) {
  if (const auto* const text = std::get_if<std::optional<std::string>*>(&option.target)) return (*text)->has_value();
  if (const auto* const texts = std::get_if<std::vector<std::string>*>(&option.target)) return !(*texts)->empty();
  const auto* const flag = std::get_if<bool*>(&option.target);
  return flag && **flag;
}

void Command::add(const char* group, std::initializer_list<Option> rows) {
  for (Option row : rows) {
    row.group = group;
    options.push_back(row);
  }
}

std::vector<std::string> command_names(const Command& command) {
  std::vector<std::string> names;
  for (const Command& below : command.commands) names.push_back(below.name);
  return names;
}

std::vector<std::string> option_names(const Command& command) {
  std::vector<std::string> names{"--help"};
  if (!command.version.empty()) names.emplace_back("--version");
  for (const Option& option : command.options) {
    if (option.name[0] != '-') continue;
    for (const std::string& name : names_of(option)) names.push_back(name);
  }
  return names;
}

}  // namespace cli
