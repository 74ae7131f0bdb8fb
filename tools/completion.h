// Completion of command lines, from the option parser itself. The shells' scripts in completions/ ask `roughcontact complete`.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace cli {

std::vector<std::string> subcommand_names(const CLI::App& app);
std::vector<std::string> option_names(const CLI::App& app);

// Prints, one a line, what the last of the words may become; nothing where it is a file, a number, or anything goes. The words
// are those after the command's name. "=" may be a word of its own, as in bash.
void complete(CLI::App& app, std::vector<std::string> words);

}  // namespace cli
