// Steps in time.
#pragma once

#include <string>

#include "request/request.h"
#include "request/words.h"

namespace rc::request {

// The columns of the file that the word steps names, as the words of their names would be given.
struct StepTable {
  std::string file;
  std::string loading;  // "approach", "load", "pressure" or "area"; "": the word is not given
  std::string targets;
  std::string times;  // "": there is no such column

  static Given as_word(std::string_view name, const std::string& texts) {
    return {std::string(name), find_word(name), texts.c_str(), {}};
  }
};

StepTable step_table(const Words& words);

// The times of the steps; a single target becomes that of all times. needed: whether it is an error if bodies that creep have
// none.
void set_times(const Words& words, const StepTable& table, bool needed, rc_request& request);

}  // namespace rc::request
