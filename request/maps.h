// Height maps as they come: from files or from the caller's memory, with lengths in metres where their unit is known.
#pragma once

#include <roughcontact/request.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "request/words.h"

namespace rc::request {

// The unit of lengths that have none.
struct BareUnit {
  const char* name = nullptr;  // null: not given
  double metres = 1;
};

struct Map {
  std::string name;  // of its file, or the word, for messages
  std::int64_t nx = 0, ny = 0, maps = 1;
  double hx = 0, hy = 0;      // 0: not known
  const double* z = nullptr;  // of the caller, or own; null: the caller has them
  const std::uint8_t* mask = nullptr;
  std::vector<double> own;
  std::vector<std::uint8_t> own_mask;
  std::int32_t periodic = -1;
  std::string format, note;
  std::string bare;           // the lengths for which no unit is known, "heights"; "": none
  bool has_unit = false;      // it names one for its lengths
  double unit = 1;            // metres in it, of a map in memory
  std::string contradiction;  // of the unit that was given and that of the file; "": none
  bool of_file = false;       // its name is that of a file
  bool rounded = false;       // hx and hy are
  bool scaled = false;        // its heights are by the height range

  std::size_t points() const { return static_cast<std::size_t>(nx * ny * maps); }
  // Its heights, to be changed.
  std::vector<double>& writable();
};

// The map in memory of this word, the first or one after it; null if there is none.
const rc_map* map_of(const rc_request_spec& spec, std::string_view word, std::int64_t which = 0);

// The map that a word names; nothing if it was not given. memory: may be null. height_range: of pictures [m], 0: not given.
std::optional<Map> load_map(const rc_map* memory, const Words& words, std::string_view word, const BareUnit& unit,
                            double height_range);

// Refuses a unit that was given where all files name others for all their lengths. other: null if there is none.
void check_unit(const Map& surface, const Map* other);

}  // namespace rc::request
