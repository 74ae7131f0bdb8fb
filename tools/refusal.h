// The answer to a command line that cannot be parsed.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace cli {

// What is wrong, with the nearest word that would be right. words: what follows the name of the command.
std::string refusal(const CLI::App& app, const std::vector<std::string>& words, const CLI::ParseError& error);

}  // namespace cli
