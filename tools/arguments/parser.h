// The parser of command lines.
#pragma once

#include <string>
#include <vector>

#include "arguments/command.h"

namespace cli {

struct Parsed {
  std::vector<std::string> commands;  // names of the commands that the line gives, the outermost first
  std::string answer;                 // to --help or --version, to be printed instead; "" if not asked for
  std::string refusal;                // what is wrong, with the nearest word that would be right; "" if nothing is
};

// Puts the values where the options of the command say. words: what follows its name.
Parsed parse(const Command& command, const std::vector<std::string>& words);

}  // namespace cli
