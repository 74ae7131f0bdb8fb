// Text for people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "formats/wording.h"
#include "request/names.h"

namespace cli {

using namespace rc::formats;
using namespace rc::request;

// The name that begins what a command says; each command defines its own.
extern const char command_name[];

// In columns of a terminal, in which the bytes after the first of a character in UTF-8 take no place.
std::string right_aligned(const std::string& text, std::size_t width);

// Writes "NAME: text" as exactly one line to standard error. Allocates nothing.
void report(std::string_view text);

// Whether everything printed to standard output was written; reports it if not.
bool finish_standard_output();

}  // namespace cli
