// Functions of the system that tests need beyond the standard library; one folder for each system has them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace support {

extern const char* const device;            // a path that is no file
extern const char* const device_refused;    // what the readers of surfaces say of it
extern const long machine_in_library;       // where the file of a shared object says what it runs on [bytes]
extern const char* const needed_by_all;     // the name in there of a library that every shared object needs
extern const char* const folder_separator;  // in a list of folders
// How the same folder may be called that a path names, by words that plugins are not looked for by.
std::vector<std::string> other_names(const std::string& path);
extern const char* const writable_to_all;  // how the refusal of a plugin calls a file that everybody can write to
void let_everybody_write(const std::string& path);
void let_owner_alone_write(const std::string& path);
extern const char* const owned_by_another;  // how it calls one that was given away
bool give_away(const std::string& path);    // to another user; false where that is not possible
bool make_pipe(const std::string& path);    // false where pipes are not files

void set_variable(const char* name, const char* value);  // of the environment; null: not set

// For blocks of memory that are given back by free_aligned.
void* aligned_memory(std::size_t alignment, std::size_t bytes);
void free_aligned(void* memory);

// Ends this process when it has more memory [bytes, 0: no limit] or has run for so long [s].
void limit_process(std::size_t bytes, unsigned seconds);

// Ends this process when it has taken so much more processor time; not where limit_process alone can.
void limit_processor_time(unsigned seconds);

}  // namespace support
