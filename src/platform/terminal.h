// The terminal, the standard streams, and what stops a program from outside.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace rc_platform {

// The command line in UTF-8.
std::vector<std::string> arguments(int argc, char** argv);

// A file opened later must not become a standard stream that the caller has closed: it would receive what is printed.
void open_standard_streams();

bool is_terminal(std::FILE* stream);
std::size_t terminal_width();  // columns of the terminal of the error stream; 80 if it does not say

// `handler` gets the number of every signal that asks the program to end and that its caller did not have ignored. It may run
// while the program runs, on a separate thread.
void when_asked_to_end(void (*handler)(int number));

// Ends the program as the signal does where nobody handles it.
void end_by(int number);

}  // namespace rc_platform
