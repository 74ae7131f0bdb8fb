// The manual page roughcontact(1), from the same data as the parser.
#pragma once

#include <string>

#include "arguments/command.h"

namespace cli {

// As troff reads it: commands with their options, and the options that the library has with its backends.
std::string manual(const Command& command);

}  // namespace cli
