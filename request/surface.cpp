// The surface as it is pressed, in this order: units, crop, missing points, spikes, form, the other body, the nominal shape.
#include <roughcontact/formats.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "request/budget/fields.h"
#include "request/registration.h"

namespace rc::request {

bool same_pitch(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * std::abs(b); }

void check_formats(rc_status status, const Map& map) {
  if (status == RC_OK) return;
  const std::string_view message = rc_surface_read_last_error();
  fail(status, map.name, ": ", message.substr(message.find(": ") + 2));
}

void mark_masked(Map& map) {
  if (!map.mask) return;
  std::vector<double>& z = map.writable();
  for (std::size_t i = 0; i < z.size(); ++i)
    if (!map.mask[i]) z[i] = std::numeric_limits<double>::quiet_NaN();
  map.mask = nullptr;
}

namespace {

enum class Missing { reject, fill, exclude };  // in the order of the table

std::string length_text(const Units& units, double length, int digits) {
  return units.si ? with_prefix(length, "m", digits) : in_digits(length, digits);
}

// Refuses metres that only a mistaken unit explains. length: a pitch or a range of heights without a unit.
void check_bare(const Words& words, const Units& units, const std::string& what, double length) {
  constexpr double largest = 1e-2;  // [m], of a map that is pressed as a rough surface
  if (!units.si || units.bare.name || !(length > largest)) return;
  throw Error(what, " would be ", with_prefix(length, "m"), ", as lengths without a unit are in m: give ", words.spelt("unit"),
              ", their unit (", words.spelling.value("unit", "m"), " if that is meant)");
}

void check_bare_heights(const Words& words, const Units& units, const Map& map) {
  if (map.bare.find("heights") == map.bare.npos && map.bare != "lengths") return;
  if (!map.z) return;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!std::isfinite(map.z[i])) continue;
    least = std::min(least, map.z[i]);
    most = std::max(most, map.z[i]);
  }
  check_bare(words, units, join("the range of heights of ", map.name), most - least);
}

// Puts the pitch that was given into a map that has none.
void settle_pitch(const Words& words, Units& units, Map& map, rc_request& request) {
  const Given* const given = words.find("pitch");
  const bool says = map.hx > 0 && map.hy > 0;
  const bool bare_pitch = map.format.empty() ? !map.has_unit : !map.bare.empty() && map.bare != "heights";
  if (says && bare_pitch) check_bare(words, units, join("the pitch of ", map.name), std::max(map.hx, map.hy));
  if (says && !map.format.empty())
    request.remarks.push_back(
        {RC_REMARK_PITCH,
         RC_FACT,
         "pitch",
         join("pitch ", length_text(units, map.hx, 7), ", ", length_text(units, map.hy, 7), ", as ", map.name, " says"),
         {map.hx, map.hy, 0}});
  if (!given) {
    if (!says)
      throw Error(map.name, ": ", map.format.empty() ? "the pitch is missing" : "the file does not say its pitch", ", give ",
                  words.spelt("pitch"), ", one number or two, along x and y");
    return;
  }
  words.positive(*given, Dimension::length);
  const std::vector<Quantity> pitch = words.quantities(*given, Dimension::length, units.bare.metres);
  units.see(pitch);
  const bool bare = std::ranges::any_of(pitch, &Quantity::bare);
  if (bare && map.unit != 1 && !units.bare.name && !(map.hx > 0 && map.hy > 0))
    throw Error(words.spelt("pitch"), " has no unit, but ", map.name, " have one: give the pitch its unit");
  if (bare) units.add(words.spelt("pitch"));
  const double sides[] = {pitch.front().si(), pitch.back().si()};
  double* const own[] = {&map.hx, &map.hy};
  for (int k = 0; k < 2; ++k) {
    if (*own[k] > 0 && !same_pitch(sides[k], *own[k], map.rounded ? 1e-3 : 1e-6))
      throw Error(words.spelt("pitch"), ": the pitch given is ", length_text(units, sides[0], 7), ", ",
                  length_text(units, sides[1], 7), ", but ", map.of_file ? map.name : "the map", " has its own, ",
                  length_text(units, map.hx, 7), ", ", length_text(units, map.hy, 7), "; leave the pitch out, or correct the ",
                  map.of_file ? "file" : "map");
    *own[k] = sides[k];
  }
  if (bare) check_bare(words, units, words.spelt("pitch"), std::max(sides[0], sides[1]));
}

bool present(const Map& map, std::size_t i) { return !map.mask || map.mask[i] != 0; }

// Points without a height where the mask leaves none out, and the first of them.
std::pair<std::int64_t, std::size_t> missing_points(const Map& map) {
  std::int64_t count = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (std::isfinite(map.z[i]) || !present(map, i)) continue;
    if (std::isinf(map.z[i])) {
      const auto place = static_cast<std::int64_t>(i) % (map.nx * map.ny);
      throw Error(map.name, ": the height at ix=", place % map.nx, ", iy=", place / map.nx,
                  " is infinite; a missing point is NaN");
    }
    if (count++ == 0) first = i;
  }
  return {count, first};
}

void reject_missing(const Words& words, const Map& map, std::int64_t count, std::size_t first) {
  const auto place = static_cast<std::int64_t>(first) % (map.nx * map.ny),
             which = static_cast<std::int64_t>(first) / (map.nx * map.ny);
  const bool excludes = words.call != RC_CALL_ANALYZE;
  throw Error(map.name, ": ", count, " missing value", count == 1 ? "" : "s", " of ", map.points(),
              ", first at ix=", place % map.nx, ", iy=", place / map.nx, map.maps > 1 ? join(" of map ", which) : "", "; give ",
              words.spelling.value("missing", "fill"), " to interpolate",
              excludes ? join(" or ", words.spelling.value("missing", "exclude"), " to keep them out of contact") : "");
}

void fill(Map& map) {
  double* z = map.writable().data();
  for (std::int64_t k = 0; k < map.maps; ++k, z += map.nx * map.ny)
    check_formats(rc_surface_fill(map.nx, map.ny, map.hx, map.hy, z), map);
}

// Crops, cleans and levels one map, and treats its missing points; returns how many there were.
std::int64_t prepare(const Words& words, Units& units, Map& map, rc_request& request) {
  const auto rule = static_cast<Missing>(words.chosen("missing"));
  const std::size_t form = words.chosen("remove");
  if (rule == Missing::exclude && words.call == RC_CALL_ANALYZE)
    throw Error(words.spelt("missing"), ": points cannot be excluded here, spectra need all of them; give reject or fill");
  if (!map.z) return 0;
  crop(words, units, map, request);
  const auto [count, first] = missing_points(map);
  if (count == static_cast<std::int64_t>(map.points()))
    throw Error(map.name, ": ", count == 1 ? "the only point is" : join("all ", count, " points are"), " missing");
  if (count > 0 && rule == Missing::reject) reject_missing(words, map, count, first);
  const std::int64_t spikes = despike(words, map, request);
  if (count > 0 || form > 0 || (map.mask && rule == Missing::fill)) mark_masked(map);
  if (form > 0) {
    double* z = map.writable().data();
    for (std::int64_t k = 0; k < map.maps; ++k, z += map.nx * map.ny)
      check_formats(rc_surface_remove_form(map.nx, map.ny, static_cast<std::int32_t>(form), z), map);
  }
  if (rule == Missing::fill || (spikes > 0 && rule == Missing::reject)) fill(map);
  if (count > 0) {
    const auto place = static_cast<std::int64_t>(first) % (map.nx * map.ny);
    const char* const done = rule == Missing::fill ? "filled" : "excluded";
    request.remarks.push_back(
        {RC_REMARK_MISSING,
         RC_FACT,
         "missing",
         join(map.name, ": ", count, " missing point", count == 1 ? " is " : "s are ", done),
         {static_cast<double>(count), static_cast<double>(place % map.nx), static_cast<double>(place / map.nx)}});
  }
  return count;
}

// Adds the heights of a body on the same grid, which face those of the surface at the same points.
void add_other(const Words& words, const Units& units, std::string_view word, Map& other, Map& map) {
  const double hx = other.hx > 0 ? other.hx : map.hx, hy = other.hy > 0 ? other.hy : map.hy;
  if (other.nx != map.nx || other.ny != map.ny || !same_pitch(hx, map.hx) || !same_pitch(hy, map.hy)) {
    const auto grid = [&units](const Map& each, double x, double y) {
      return join(each.nx, " x ", each.ny, " points, pitch ", length_text(units, x, 7), " x ", length_text(units, y, 7));
    };
    fail(RC_ERR_SHAPE, words.spelt(word), ": ", other.name, " has ", grid(other, hx, hy), ", ", map.name, " has ",
         grid(map, map.hx, map.hy), ": give two maps on the same grid, or ", words.spelling.value("resample", "cubic"), " and ",
         words.spelt("shift"));
  }
  if (other.periodic == 0 || map.periodic == 1) map.periodic = other.periodic;
  if (!map.z || !other.z) return;
  mark_masked(map);
  mark_masked(other);
  std::vector<double>& z = map.writable();
  for (std::size_t i = 0; i < z.size(); ++i) z[i] += other.z[i % (static_cast<std::size_t>(other.nx * other.ny))];
}

// The other body, moved by whole cells; what leaves at one edge comes in at the opposite one.
void move_cyclically(const Variation& variation, Map& other) {
  if (!other.z || (variation.cells_x == 0 && variation.cells_y == 0)) return;
  mark_masked(other);
  const std::vector<double> before = other.writable();
  std::vector<double>& z = other.writable();
  const auto wrapped = [](std::int64_t place, std::int64_t n) { return (place % n + n) % n; };
  for (std::int64_t iy = 0; iy < other.ny; ++iy)
    for (std::int64_t ix = 0; ix < other.nx; ++ix)
      z[static_cast<std::size_t>(iy * other.nx + ix)] = before[static_cast<std::size_t>(
          wrapped(iy - variation.cells_y, other.ny) * other.nx + wrapped(ix - variation.cells_x, other.nx))];
}

// Changes the map as a source of a budget does: its heights' scale and its shortest waves.
void vary(const Variation& variation, Map& map) {
  if (map.z && (variation.height != 1 || variation.cutoff > 0)) {
    std::vector<double>& z = map.writable();
    for (double& each : z) each *= variation.height;
    if (variation.cutoff > 0) low_pass({map.nx, map.ny, map.hx, map.hy}, variation.cutoff, map.periodic == 1, z);
  }
  map.hx *= variation.pitch;
  map.hy *= variation.pitch;
}

// The height between the smallest and the largest value of a picture [m]; 0: not given.
double height_range(const Words& words, Units& units) {
  const Given* const given = words.find("height-range");
  if (!given) return 0;
  const Quantity range = words.positive(*given, Dimension::length, units.bare.metres);
  units.see({range});
  if (range.bare) units.add(words.spelt("height-range"));
  return range.si();
}

// Whether it has a length without a unit.
bool name_shape(const Words& words, Units& units, rc_request& request) {
  const Given* const given = words.find("shape");
  if (!given) return false;
  bool bare = false;
  request.shape = parse_shape(words.spelt("shape"), given->text, units.bare.metres, bare);
  units.si = units.si || request.shape->name == "wedge" || !bare;
  return bare;
}

// A mask from the heights that are NaN.
void exclude(Map& map) {
  const std::span<const double> heights{map.z, map.z ? map.points() : 0};
  if (map.mask || std::ranges::none_of(heights, [](double z) { return std::isnan(z); })) return;
  map.own_mask.resize(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) map.own_mask[i] = std::isnan(heights[i]) ? 0 : 1;
  map.mask = map.own_mask.data();
}

}  // namespace

void set_surface(const rc_request_spec& spec, const Words& words, Units& units, const Variation& variation, rc_request& request) {
  rc_system& system = request.view.system;
  const bool bare_shape = name_shape(words, units, request), of_gap = map_of(spec, "gap") != nullptr;
  const std::string_view word = of_gap ? "gap" : "surface";
  for (const char* const change :
       {"crop", "despike", "remove", "against", "mirror", "shift", "resample", "shape", "format", "height-range"})
    if (of_gap && (words.find(change) || map_of(spec, change)))
      throw Error(words.spelt(change), " changes heights, but ", words.spelt("gap"), " is given");
  const double range = height_range(words, units);
  std::optional<Map> loaded =
      load_map(variation.replaced.first == "surface" ? variation.surface : map_of(spec, word), words, word, units.bare, range);
  if (!loaded && spec.system) return;  // a step on the surface of the step before
  if (!loaded) throw Error(words.spelt("surface"), " is missing");
  Map& map = request.maps.emplace_back(std::move(*loaded));
  std::optional<Map> other = load_map(map_of(spec, "against"), words, "against", units.bare, range), shaped;
  if (const rc_map* const shape = map_of(spec, "shape")) shaped = load_map(shape, words, "shape", units.bare, range);
  request.against = other.has_value();
  request.shaped = shaped.has_value();
  if (range > 0 && !map.scaled && !(other && other->scaled) && !(shaped && shaped->scaled))
    throw Error(words.spelt("height-range"), " is of TIFF and PNG of whole numbers, and ", map.name, " has heights");
  for (Map* const each : {&map, other ? &*other : nullptr}) {
    if (!each) continue;
    if (!each->note.empty()) request.remarks.push_back({RC_REMARK_FILE, RC_FACT, "", each->note});
    units.si = units.si || each->has_unit || !each->format.empty();
  }
  if (spec.system) {
    if (!(map.hx > 0)) map.hx = system.hx;
    if (!(map.hy > 0)) map.hy = system.hy;
    if (map.nx != system.nx || map.ny != system.ny)
      fail(RC_ERR_SHAPE, map.name, " have ", map.nx, " x ", map.ny, " points, the system has ", system.nx, " x ", system.ny);
    if (system.op == RC_OPERATOR_HALFSPACE && !(same_pitch(map.hx, system.hx) && same_pitch(map.hy, system.hy)))
      throw Error(map.name, " have the pitch ", map.hx, ", ", map.hy, ", the system ", system.hx, ", ", system.hy,
                  ": make the system with that of the surface");
  }
  for (const Map* const each : {&map, other ? &*other : nullptr})
    if (each && !each->bare.empty()) units.add(each->of_file ? join(each->bare, " of ", each->name) : each->name);
  settle_pitch(words, units, map, request);
  for (const Map* const each : {&map, other ? &*other : nullptr})
    if (each && !of_gap) check_bare_heights(words, units, *each);
  check_unit(map, other ? &*other : nullptr);
  if (bare_shape && map.unit != 1 && !units.bare.name)
    throw Error(words.spelt("shape"), ": R has no unit, but ", map.name, " have one: give R its unit");

  if (!of_gap) request.view.missing = prepare(words, units, map, request);
  for (auto& [name, body] : {std::pair{std::string_view("against"), &other}, std::pair{std::string_view("shape"), &shaped}}) {
    if (name == "shape") vary(variation, map);
    if (!*body) continue;
    const double pitch = name == "shape" ? variation.pitch : 1;
    (*body)->hx = (*body)->hx > 0 ? (*body)->hx * pitch : map.hx;
    (*body)->hy = (*body)->hy > 0 ? (*body)->hy * pitch : map.hy;
    request.view.missing += prepare(words, units, **body, request);
    if (name == "against") {
      mirror(words, **body);
      onto_grid(words, units, **body, map, request);
      move_cyclically(variation, **body);
    }
    add_other(words, units, name, **body, map);
    if (name == "shape") map.periodic = 0;  // a ball ends somewhere
  }
  if (request.shape && map.z) {
    std::span<double> z = map.writable();
    const auto size = static_cast<std::size_t>(map.nx * map.ny);
    for (std::int64_t k = 0; k < map.maps; ++k)
      add_shape(words.spelt("shape"), *request.shape, {map.nx, map.ny, map.hx, map.hy}, units.si,
                z.subspan(static_cast<std::size_t>(k) * size, size));
  }
  if (!of_gap) exclude(map);

  if (!spec.system) {
    system.nx = map.nx;
    system.ny = map.ny;
    system.hx = map.hx;
    system.hy = map.hy;
  }
  request.format = map.format;
  request.view.periodic = map.periodic;
}

}  // namespace rc::request
