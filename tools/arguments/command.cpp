#include "arguments/command.h"

namespace cli {

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
    if (option.name[0] == '-') names.emplace_back(option.name);
  }
  return names;
}

}  // namespace cli
