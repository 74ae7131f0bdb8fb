// The one file that includes CLI11, which takes long to compile.
#include "arguments/parser.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "request/choices.h"
#include "text.h"

namespace cli {

namespace {

void add(CLI::App& app, const Option& option) {
  if (bool* const* const flag = std::get_if<bool*>(&option.target)) {
    app.add_flag(option.name, **flag, option.help)->group(option.group);
    return;
  }
  CLI::Option* added = nullptr;
  if (auto* const* const texts = std::get_if<std::vector<std::string>*>(&option.target)) {
    added = app.add_option(option.name, **texts, option.help)->expected(1)->take_all();
  } else if (auto* const* const text = std::get_if<std::optional<std::string>*>(&option.target)) {
    added = app.add_option(option.name, **text, option.help);
  } else {
    added = app.add_option(option.name, *std::get<std::string*>(option.target), option.help)->required();
  }
  added->type_name(option.type)->group(option.group);
}

void fill(CLI::App& app, const Command& command) {
  app.footer(command.footer);
  for (const Option& option : command.options) add(app, option);
  if (!command.commands.empty()) app.require_subcommand(command.needs_command ? 1 : 0, 1);
  for (const Command& below : command.commands) fill(*app.add_subcommand(below.name, below.help), below);
}

std::vector<std::string> given_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
    at = at->get_subcommands().front();
    names.push_back(at->get_name());
  }
  return names;
}

// The parser's own text has neither the values of an option nor what is to be given instead.
std::string misuse(const Command& command, const std::vector<std::string>& words) {
  for (const Option& option : command.options) {
    const std::vector<std::string> names = names_of(option);
    const std::string& name = names.back();
    const auto is_it = [&](const std::string& word) { return std::ranges::count(names, word.substr(0, word.find('='))) > 0; };
    const auto given = std::ranges::count_if(words, is_it);
    const bool single = !std::holds_alternative<std::vector<std::string>*>(option.target);
    if (single && given > 1) {
      const bool several = std::string_view(option.type) == "TARGETS";
      return name + (given == 2 ? " is given twice" : format(" is given %d times", static_cast<int>(given))) +
             (several ? ", give several steps as a,b,c" : "");
    }
    if (given > 0 && std::ranges::count(names, words.back()) > 0 && !std::holds_alternative<bool*>(option.target))
      return name + " has no value, expected " + option.type;
  }
  return "";
}

std::string refusal(const CLI::App& app, const Command& command, const std::vector<std::string>& words,
                    const CLI::ParseError& error) {
  const Command* at = &command;
  std::string place = command.name;
  for (const std::string& name : given_commands(app)) {
    at = &*std::ranges::find(at->commands, name, &Command::name);
    place += " " + name;
  }
  const std::string see = "; see " + place + " --help";

  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    if (const std::string said = misuse(*at, words); !said.empty()) return said + see;
  }
  const std::vector<std::string> extra = app.remaining(true);
  const bool unexpected = dynamic_cast<const CLI::ExtrasError*>(&error) || dynamic_cast<const CLI::RequiredError*>(&error);
  const auto found =
      std::find_if(words.begin(), words.end(), [&](const std::string& word) { return std::ranges::count(extra, word) > 0; });
  if (!unexpected || found == words.end()) return error.what() + see;
  const std::string word = found->substr(0, found->find('='));
  if (word.starts_with("-") && word.size() > 1)
    return place + " has no option " + in_quotes(word) + did_you_mean(word, option_names(*at)) + see;
  if (!at->commands.empty()) return place + " has no command " + in_quotes(word) + did_you_mean(word, command_names(*at)) + see;
  return in_quotes(word) + " is not expected here" + see;
}

}  // namespace

Parsed parse(const Command& command, const std::vector<std::string>& words) {
  CLI::App app{command.help, command.name};
  app.allow_windows_style_options(false);  // "/x" is a path
  if (!command.version.empty()) app.set_version_flag("--version", command.version);
  fill(app, command);
  Parsed parsed;
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // it takes the last one first
  } catch (const CLI::Success& success) {
    std::ostringstream answer;
    app.exit(success, answer);
    parsed.answer = answer.str();
  } catch (const CLI::ParseError& error) {
    parsed.refusal = refusal(app, command, words, error);
  }
  parsed.commands = given_commands(app);
  return parsed;
}

}  // namespace cli
