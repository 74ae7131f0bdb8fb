// `roughcontact backends`, `solvers`, `kernels` and `options`: what the library has, and `formats`: what surfaces it reads, as
// tables on standard output.
#pragma once

#include <string>
#include <vector>

namespace cli {

// Key, type, default, allowed values and meaning of every option.
std::vector<std::vector<std::string>> option_rows();

void list_backends();
void list_solvers();
void list_kernels();
void list_options();
void list_formats();

}  // namespace cli
