#include "refusal.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "choices.h"
#include "completion.h"
#include "text.h"

namespace cli {

std::string refusal(const CLI::App& app, const std::vector<std::string>& words, const CLI::ParseError& error) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  std::string place = at->get_display_name();
  for (const CLI::App* up = at->get_parent(); up; up = up->get_parent()) place = up->get_display_name() + " " + place;
  const std::string see = "; see " + place + " --help";

  const std::vector<std::string> extra = app.remaining(true);
  const bool unexpected = dynamic_cast<const CLI::ExtrasError*>(&error) || dynamic_cast<const CLI::RequiredError*>(&error);
  const auto found =
      std::find_if(words.begin(), words.end(), [&](const std::string& word) { return std::ranges::count(extra, word) > 0; });
  if (!unexpected || found == words.end()) return error.what() + see;
  const std::string word = found->substr(0, found->find('='));
  if (word.starts_with("-") && word.size() > 1)
    return place + " has no option " + in_quotes(word) + did_you_mean(word, option_names(*at)) + see;
  if (const auto names = subcommand_names(*at); !names.empty())
    return place + " has no command " + in_quotes(word) + did_you_mean(word, names) + see;
  return in_quotes(word) + " is not expected here" + see;
}

}  // namespace cli
