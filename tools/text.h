// Text for people.
#pragma once

#include <string_view>

#include "formats/wording.h"

namespace cli {

using namespace rc::formats;

// The name that begins what a command says; each command defines its own.
extern const char command_name[];

// Writes "NAME: text" as exactly one line to standard error. Allocates nothing.
void report(std::string_view text);

// Whether everything printed to standard output was written; reports it if not.
bool finish_standard_output();

}  // namespace cli
