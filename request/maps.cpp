#include "request/maps.h"

#include <roughcontact/formats.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.h"

namespace rc::request {

namespace {

// A surface file, until its heights are copied.
struct File : rc_surface_file {
  File() : rc_surface_file RC_SURFACE_FILE_INIT {}
  ~File() { rc_surface_file_free(this); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
};

struct Reading {
  const char* path;  // null: from memory
  const rc_map* memory;
  const char* format;
  double height_range;  // [m]
};

// unit: of lengths for which the file names none; null: m.
rc_status read_in(const Reading& how, const BareUnit& unit, File& file) {
  rc_surface_read_spec spec = RC_SURFACE_READ_SPEC_INIT;
  spec.format = how.format;
  spec.unit = unit.name;
  spec.height_range = how.height_range / unit.metres;
  rc_surface_file_free(&file);
  return how.path ? rc_surface_read(how.path, &spec, &file)
                  : rc_surface_read_memory(how.memory->contents, how.memory->size, how.memory->name, &spec, &file);
}

// The fault of the file, without the function's name and in the caller's words.
std::string file_error(const Words& words) {
  constexpr std::string_view format = "format: ", give_range = "; give height_range";
  std::string_view message = rc_surface_read_last_error();
  message.remove_prefix(message.find(": ") + 2);
  if (const auto place = message.rfind(give_range); place != message.npos)
    return join(message.substr(0, place), "; give ", words.spelt("height-range"), message.substr(place + give_range.size()));
  if (!message.starts_with(format)) return std::string(message);
  return join(words.spelt("format"), ": ", message.substr(format.size()));
}

Map map_of_file(const Reading& how, const BareUnit& unit, const Words& words) {
  File file;
  rc_status status = read_in(how, {}, file);
  // A file that names its units is read without the one that was given, which is perhaps that of another map.
  const bool bare = status == RC_OK ? file.unit_assumed == 1 : unit.name != nullptr;
  Map map;
  if (bare && unit.name) status = read_in(how, unit, file);
  if (status != RC_OK) fail(status, file_error(words));
  if (!bare && unit.name) {
    File again;
    if (read_in(how, unit, again) != RC_OK) map.contradiction = file_error(words);
  }
  map.name = how.path ? how.path : how.memory->name ? how.memory->name : "the file";
  map.of_file = true;
  map.nx = file.nx;
  map.ny = file.ny;
  map.hx = file.hx;
  map.hy = file.hy;
  map.own.assign(file.heights, file.heights + file.nx * file.ny);
  map.z = map.own.data();
  map.periodic = file.periodic;
  map.format = file.format;
  map.has_unit = !bare;
  map.scaled = file.full_scale > 0;
  map.note = file.assumed;
  if (how.memory && how.memory->mask) {
    if (how.memory->nx != map.nx || how.memory->ny != map.ny)
      fail(RC_ERR_SHAPE, map.name, " has ", map.nx, " x ", map.ny, " points, its mask ", how.memory->nx, " x ", how.memory->ny);
    map.mask = how.memory->mask;
  }
  return map;
}

// Takes the sentence on units out of what a file leaves open, which the request says in its own words, and returns its lengths.
std::string take_bare_lengths(std::string& note) {
  constexpr std::string_view begin = "the file names none of its ";
  std::string rest, found;
  std::string_view text = note;
  while (!text.empty()) {
    const auto end = text.find("; ");
    const std::string_view sentence = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 2);
    const auto place = sentence.find(begin);
    if (place != sentence.npos) {
      found = sentence.substr(place + begin.size());
    } else if (!sentence.starts_with("lengths without a unit") && !sentence.starts_with("the pitch is not known")) {
      rest += join(rest.empty() ? "" : "; ", sentence);
    }
  }
  note = rest;
  return found;
}

void check_grid(const rc_map& map) {
  constexpr std::int64_t most = std::int64_t{1} << 40;
  const std::int64_t maps = std::max<std::int64_t>(map.maps, 1);
  if (map.nx < 1 || map.ny < 1 || map.maps < 0 || map.nx > most / map.ny || map.nx * map.ny > most / maps)
    fail(RC_ERR_SHAPE, "rc_map: nx = ", map.nx, ", ny = ", map.ny, ", maps = ", map.maps, ": 1 x 1 to 2^40 points are needed");
  for (const double h : {map.hx, map.hy})
    if (!(h >= 0) || !std::isfinite(h)) fail(RC_ERR_ARGUMENT, "hx = ", map.hx, ", hy = ", map.hy, " must be positive and finite");
}

Map map_in_memory(const rc_map& given, const Words& words, std::string_view word, const BareUnit& unit) {
  check_grid(given);
  Map map;
  map.name = given.name ? given.name : words.spelt(word);
  map.of_file = given.name != nullptr;
  map.nx = given.nx;
  map.ny = given.ny;
  map.maps = std::max<std::int64_t>(given.maps, 1);
  map.hx = given.hx;
  map.hy = given.hy;
  map.z = given.heights;
  map.mask = given.mask;
  map.periodic = given.periodic;
  map.rounded = given.rounded == 1;
  map.has_unit = given.unit != nullptr;
  if (!map.has_unit) map.bare = word == "gap" ? "gap" : "heights";
  if (map.has_unit) {
    const auto metres = metres_in(given.unit);
    if (!metres) fail(RC_ERR_ARGUMENT, map.name, " are in ", in_quotes(given.unit), ", which is no length");
    if (unit.name && (unit.metres != 1 || *metres != 1))
      fail(RC_ERR_ARGUMENT, words.spelt("unit"), " is ", in_quotes(unit.name), ", but ", map.name, " say ", in_quotes(given.unit),
           ": ", words.spelt("unit"), " is that of lengths without a unit, and a map with a unit is pressed in metres; leave ",
           words.spelt("unit"), " out, or give heights and pitch as numbers");
    map.unit = *metres;
  }
  const double factor = map.has_unit ? map.unit : unit.metres;
  map.hx *= factor;
  map.hy *= factor;
  if (factor != 1 && map.z)
    for (double& z : map.writable()) z *= factor;
  return map;
}

}  // namespace

std::vector<double>& Map::writable() {
  if (own.empty()) {
    own.assign(z, z + points());
    z = own.data();
  }
  return own;
}

const rc_map* map_of(const rc_request_spec& spec, std::string_view word, std::int64_t which) {
  for (std::int64_t k = 0; k < spec.n_maps; ++k) {
    const auto* const map = reinterpret_cast<const rc_map*>(reinterpret_cast<const char*>(spec.maps) +
                                                            static_cast<std::size_t>(k) * spec.maps->struct_size);
    if (map->word && word == map->word && which-- == 0) return map;
  }
  return nullptr;
}

std::optional<Map> load_map(const rc_map* memory, const Words& words, std::string_view word, const BareUnit& unit,
                            double height_range) {
  const Given* const given = words.find(word);
  if (!given && !memory) return std::nullopt;
  if (given && memory) fail(RC_ERR_ARGUMENT, words.spelt(word), " is given twice");
  std::optional<Map> map;
  const Given* const format = word == "surface" ? words.find("format") : nullptr;
  if (given || memory->contents) {
    map = map_of_file({given ? given->text : nullptr, memory, format ? format->text : nullptr, height_range}, unit, words);
    map->bare = take_bare_lengths(map->note);
  } else {
    map = map_in_memory(*memory, words, word, unit);
  }
  return map;
}

void check_unit(const Map& surface, const Map* other) {
  if (!surface.has_unit || (other && !other->has_unit)) return;
  for (const Map* const map : {&surface, other})
    if (map && !map->contradiction.empty()) fail(RC_ERR_ARGUMENT, map->contradiction);
}

}  // namespace rc::request
