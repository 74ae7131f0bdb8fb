// A command and its options as data, which the parser of command lines and completion read.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cli {

struct Option {
  // The variable for the value: a required text, an optional one, texts of an option that may be repeated, or a flag.
  using Target = std::variant<std::string*, std::optional<std::string>*, std::vector<std::string>*, bool*>;

  std::string name;  // without dashes: of an argument known by its place; "-o,--output": a short and a long one
  Target target;
  const char* type;  // of the value, for --help; flags have none
  const char* help;
  const char* group = "Options";
};

// Short and long, in the order of its name.
std::vector<std::string> names_of(const Option& option);
// Whether a command line had it. One whose value is required counts as not given.
bool given(const Option& option);

struct Command {
  std::string name;
  std::string help;
  const char* footer = "";  // what --help ends with
  bool needs_command = false;
  std::vector<Option> options{};
  std::vector<Command> commands{};
  std::string version{};  // what --version says; "": there is no such option

  void add(const char* group, std::initializer_list<Option> rows);
};

// In the order of --help.
std::vector<std::string> command_names(const Command& command);
std::vector<std::string> option_names(const Command& command);

}  // namespace cli
