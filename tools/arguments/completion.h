// Completion of command lines, from the same data as the parser. The shells' scripts in completions/ ask `roughcontact complete`.
#pragma once

#include <string>
#include <vector>

#include "arguments/command.h"

namespace cli {

// Prints, one a line, what the last of the words may become; nothing if it is a file, a number, or anything goes. The words
// are those after the command's name. "=" may be a word of its own, as in bash.
void complete(const Command& command, std::vector<std::string> words);

}  // namespace cli
