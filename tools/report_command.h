// `roughcontact report`, whose page Python makes.
#pragma once

#include <string>
#include <vector>

namespace cli {

// Becomes Python. words: of the sub-command, checked. Throws an Error if there is no Python.
int run_report(const std::vector<std::string>& words);

}  // namespace cli
