// A change of a request: what a budget varies.
#pragma once

#include <roughcontact/request.h>

#include <cstdint>
#include <string>
#include <utility>

namespace rc::request {

struct Variation {
  std::pair<std::string, double> factor;         // of the numbers of a word; "": none
  std::pair<std::string, const char*> replaced;  // a word and its value in place of the given one, null: left out; "": none
  const rc_map* surface = nullptr;               // in place of the given one, which is replaced; null: none
  double pitch = 1, height = 1;                  // factors, of heights before the nominal shape is added
  double cutoff = 0;                             // waves below this length are filtered out [length]; 0: none
  std::int64_t cells_x = 0, cells_y = 0;         // by which the other body is moved, cyclically
};

}  // namespace rc::request
