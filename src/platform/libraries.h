// Libraries that are opened while the program runs, and the folders that hold them. Paths are UTF-8.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rc_platform {

// How this system names them.
extern const std::string_view library_suffix;  // of a plugin's file
extern const std::string_view own_library;     // beginning of the file's name of this library
extern const char path_separator;              // between the folders of a list

bool is_absolute(std::string_view path);  // also false for a path on another machine

// Value of an environment variable; null if it is not set, or if the program has more rights than its user.
const char* trusted_environment(const char* name);

// Path of the file that holds this code, absolute; "" if the system does not say.
std::string file_of(const void* code);

bool exists(const std::string& path);
std::vector<std::string> names_in(const std::string& folder);  // empty if it cannot be read

bool loads_plugins();  // false for a program that is linked statically, C library included

// A plugin once opened stays open to the end of the program. What others can write to is refused, and so is what is incomplete,
// since the system's own loader may end the process over it.
struct OpenedPlugin {
  void* code = nullptr;
  std::string error;  // whole sentence, if code is null
};
OpenedPlugin open_plugin(const std::string& path);

void* symbol_of(void* code, const char* name);  // null if there is none

}  // namespace rc_platform
