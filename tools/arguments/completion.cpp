#include "arguments/completion.h"

#include <algorithm>
#include <cstdio>
#include <span>
#include <string_view>

#include "files/step_writers.h"
#include "formats/registry.h"
#include "law/law_arguments.h"
#include "library.h"
#include "request/words.h"
#include "text.h"

namespace cli {

namespace {

using Names = std::vector<std::string>;

Names or_auto(int32_t kind) {
  const Context context;
  Names names{"auto"};
  for (const rc_component& each : components(context, kind)) names.emplace_back(each.name);
  return names;
}

Names keys() {
  const Context context;
  Names names;
  for (const rc_component& each : components(context, RC_COMPONENT_OPTION)) names.push_back(std::string(each.name) + "=");
  return names;
}

Names texts(std::span<const std::string_view> names) { return {names.begin(), names.end()}; }

// Possible values of an option, by its name, or of a key after KEY= in --set.
Names values(std::string_view option) {
  while (option.starts_with('-')) option.remove_prefix(1);
  if (option == "solver") return or_auto(RC_COMPONENT_SOLVER);
  if (option == "backend") return or_auto(RC_COMPONENT_BACKEND);
  if (option == "kernel") return or_auto(RC_COMPONENT_KERNEL);
  if (const Word* const word = find_word(option); word && !word->choices.empty()) return texts(names_in(word->choices));
  if (option == "write") return texts(step_formats);
  if (option == "set") return keys();
  if (option == "bulk") return {"auto", "none", "mean"};
  if (option == "export") {
    Names formats = texts(law_format_names);
    for (std::string& name : formats) name += '=';
    return formats;
  }
  Names names;
  if (option == "format") {
    for (const Format& format : surface_formats()) names.emplace_back(format.name);
  }
  return names;
}

// bash takes KEY=VALUE apart.
void join_at_equals(std::vector<std::string>& words) {
  for (std::size_t k = 1; k < words.size(); ++k) {
    if (words[k] != "=" && !words[k - 1].ends_with('=')) continue;
    words[k - 1] += words[k];
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(k--));
  }
}

bool takes_value(const Command& command, const std::string& word) {
  return word.starts_with("-") && std::ranges::any_of(command.options, [&](const Option& option) {
           return std::ranges::count(names_of(option), word) > 0 && !std::holds_alternative<bool*>(option.target);
         });
}

// Completions of the last word.
Names candidates(const Command& command, const std::vector<std::string>& words) {
  const Command* at = &command;
  std::string waiting;  // the option whose value comes next
  for (std::size_t k = 0; k + 1 < words.size(); ++k) {
    const auto below = std::ranges::find(at->commands, words[k], &Command::name);
    const bool goes_down = waiting.empty() && below != at->commands.end();
    waiting = waiting.empty() && takes_value(*at, words[k]) ? words[k] : "";
    if (goes_down) at = &*below;
  }
  const std::string& word = words.back();
  if (const auto equals = word.find('='); equals != std::string::npos) {
    Names found;
    for (const std::string& value : values(word.substr(0, equals))) found.push_back(word.substr(0, equals + 1) + value);
    return found;
  }
  if (!waiting.empty()) return values(waiting);
  return word.starts_with("-") ? option_names(*at) : command_names(*at);
}

}  // namespace

void complete(const Command& command, Names words) {
  join_at_equals(words);
  if (words.empty()) words.emplace_back();
  for (const std::string& each : candidates(command, words)) {
    if (each.starts_with(words.back())) std::printf("%s\n", each.c_str());
  }
}

}  // namespace cli
