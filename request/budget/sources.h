// The sources of a budget, read from their text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "request/request.h"

namespace rc::request {

enum class Kind { noise, word, pitch, height, bandwidth, remove, missing, shift, window, maps, grid, solver };

struct Source {
  Kind kind;
  std::string name, given{};
  double size = 0;  // noise, bandwidth, shift [length]; word, pitch, height: relative; window: parts a side; maps: how many
  double correlation = 0;            // of noise [length]; 0: independent
  std::string value{};               // remove, missing: in place of what the request has
  std::vector<std::string> files{};  // of maps; empty: they are in memory
};

struct Sources {
  std::vector<Source> all;  // the solver is the last
  std::int64_t samples = 16;
  std::uint64_t seed = 1;

  std::int64_t solves() const;
};
std::int64_t solves_of(const Source& source, std::int64_t samples);

// base: the request as it is, made from this specification. Throws an Error that says what was expected.
Sources read_sources(const char* text, const rc_request_spec& spec, const rc_request& base);

}  // namespace rc::request
