// The table of bad input: one list for the test that runs it and for the document that prints it.
#pragma once

#include <roughcontact/roughcontact.h>

#include <functional>
#include <string>
#include <vector>

namespace errors {

inline constexpr double untouched = -7;  // what outputs hold before a call

// The status that a call returned, with the calling thread's message at that moment.
struct Outcome {
  Outcome(rc_status given) : status(given), message(rc_last_error()) {}
  rc_status status;
  std::string message;
};

struct Case {
  const char* input;
  rc_status status;
  std::vector<std::string> says;  // parts of the message, in this order
  std::function<Outcome()> call;
  const char* plugin = nullptr;  // a backend that must be there as a plugin, else the case is skipped
};

struct Section {
  const char* title;
  std::vector<Case> cases;
};

// How a message goes on after "struct_size = ". The size follows the width of pointers; the document, which is compared with this
// table where they have 64 bits, has the numbers.
template <class Struct> std::string too_small(std::size_t size) {
  return std::to_string(size) + " is smaller than " + std::to_string(sizeof(Struct));
}

Section null_pointers();
Section struct_sizes();
Section shapes();
Section values();
Section dense_matrices();
Section callbacks();
Section steps();
Section options();
Section names();
Section plugins();
Section order_of_calls();
Section paths();
Section restores();
Section batches();
Section direct_routines();
Section analyses();
Section derivatives();
Section laws();
Section products();

}  // namespace errors
