#include "request/budget/sources.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "request/choices.h"

namespace rc::request {

namespace {

using Key = std::pair<std::string_view, Kind>;
constexpr Key keys[] = {{"noise", Kind::noise},   {"pitch", Kind::pitch},
                        {"height", Kind::height}, {"modulus", Kind::word},
                        {"E", Kind::word},        {"nu", Kind::word},
                        {"E2", Kind::word},       {"nu2", Kind::word},
                        {"hardness", Kind::word}, {"approach", Kind::word},
                        {"load", Kind::word},     {"pressure", Kind::word},
                        {"area", Kind::word},     {"bandwidth", Kind::bandwidth},
                        {"remove", Kind::remove}, {"missing", Kind::missing},
                        {"shift", Kind::shift},   {"window", Kind::window},
                        {"maps", Kind::maps},     {"grid", Kind::grid}};
constexpr std::string_view settings[] = {"correlation", "samples", "seed"};

struct Setting {
  std::string_view key, value;
};

Setting setting_of(std::string_view text) {
  const auto equals = std::min(text.find('='), text.size());
  return {trimmed(text.substr(0, equals)), trimmed(text.substr(std::min(equals + 1, text.size())))};
}

// Reads the text of a source in the units of the request.
class Reader {
 public:
  Reader(const rc_request_spec& spec, const rc_request& base) : spec_(spec), words_(spec, {}), base_(base) {}

  Source source(const Key& key, std::string_view value) const {
    Source made{.kind = key.second, .name = std::string(key.first), .given = std::string(value)};
    const std::string where = spelt(key.first);
    const bool bare = value.empty(),
               may_be_bare = made.kind == Kind::missing || made.kind == Kind::maps || made.kind == Kind::grid;
    if (bare && !may_be_bare) throw Error(where, " has no value, give its uncertainty as in noise=20nm,pitch=1%,E=5%");
    if (!bare && made.kind == Kind::grid) throw Error(where, " takes no value");
    switch (made.kind) {
      case Kind::noise:
      case Kind::bandwidth:
        made.size = length(where, value);
        break;
      case Kind::shift:
        made.size = length(where, value);
        if (!given("against")) throw Error(where, " moves the other body, but ", words_.spelt("against"), " is not given");
        break;
      case Kind::pitch:
      case Kind::height:
      case Kind::word:
        made.size = relative(key, value);
        if (!(made.size < 1)) throw Error(where, " = ", value, " is not below 100 %");
        break;
      case Kind::window:
        made.size = parts(where, value);
        break;
      case Kind::maps:
        set_maps(where, made);
        break;
      case Kind::remove:
        made.value =
            std::string(names_in(find_word("remove")->choices)[choice(where, value, names_in(find_word("remove")->choices))]);
        break;
      case Kind::missing:
        if (base_.view.missing == 0) throw Error(where, ": no point of the map is missing");
        made.value = words_.chosen("missing") == 1 ? "exclude" : "fill";
        if (!bare && value != made.value)
          throw Error(where, " compares with ", made.value, " here, give ", made.value, " or nothing");
        made.given = made.value;
        break;
      default:
        check_halves(where);
    }
    return made;
  }

  // With a unit, or counted as the lengths of the request are.
  double length(const std::string& where, std::string_view text) const {
    const bool si = base_.view.si == 1;
    const Quantity found = read_positive(where, text, Dimension::length, base_.view.metres);
    if (!si && !found.bare) throw Error(where, " = ", text, " has a unit, but none of the words and maps has one");
    return found.si();
  }

  std::int64_t whole(const std::string& where, std::string_view text, std::int64_t least, std::int64_t most) const {
    const auto found = to_integer(std::string(text));
    if (!found || *found < least || *found > most)
      throw Error(where, " = ", text, " is not a whole number in ", least, " .. ", most);
    return *found;
  }

  static std::string spelt(std::string_view key) { return join("source ", key); }

 private:
  bool given(std::string_view word) const { return words_.find(word) != nullptr || (word == "against" && base_.against); }

  double parts(const std::string& where, std::string_view text) const {
    constexpr std::int64_t least_side = 16;
    const std::int64_t found = whole(where, text, 2, 8);
    const rc_system& system = base_.view.system;
    if (base_.shape || base_.shaped) throw Error(where, ": a nominal shape has no parts that stand for the whole");
    if (std::min(system.nx, system.ny) / found < least_side)
      throw Error(where, " = ", text, ": parts of ", system.nx, " x ", system.ny, " points have sides below ", least_side);
    return static_cast<double>(found);
  }

  void set_maps(const std::string& where, Source& made) const {
    if (map_of(spec_, "gap")) throw Error(where, " is of heights, but ", words_.spelt("gap"), " is given");
    std::int64_t count = 0;
    while (map_of(spec_, "maps", count)) ++count;
    if (!made.given.empty()) {
      if (count > 0) throw Error(where, " = ", made.given, " is also given in memory");
      for (const std::string_view each : split(made.given, ';')) made.files.emplace_back(trimmed(each));
      if (std::ranges::find(made.files, "") != made.files.end())
        throw Error(where, " = ", made.given, " has an empty name, give it as in maps=second.gsf;third.gsf");
      count = std::ssize(made.files);
    }
    if (count == 0) throw Error(where, " names no map, give at least one other as in maps=second.gsf;third.gsf");
    made.size = static_cast<double>(count);
    if (made.given.empty()) made.given = join(count, count == 1 ? " map" : " maps");
  }

  void check_halves(const std::string& where) const {
    constexpr std::int64_t least_side = 32;
    const rc_system& system = base_.view.system;
    if (std::min(system.nx, system.ny) < least_side)
      throw Error(where, ": ", system.nx, " x ", system.ny, " points cannot be halved twice, sides of ", least_side,
                  " are needed");
  }

  double relative(const Key& key, std::string_view value) const {
    const std::string where = spelt(key.first);
    const Given* const word = words_.find(key.first);
    if (key.second == Kind::word && !word)
      throw Error(where, " is uncertain by ", value, ", but ", words_.spelt(key.first), " is not given");
    if (value.ends_with('%')) return read_positive(where, value, Dimension::share).si();
    const bool ratio = key.first == "nu" || key.first == "nu2";
    if (key.second == Kind::height || key.first == "area") throw Error(where, " = ", value, " is not a share, give it as in 2%");
    if (ratio) {
      const double size = finite_number(where, value),
                   of = word->text ? finite_number(where, split(word->text, ',').front()) : word->numbers.front();
      if (!(size > 0) || of == 0) throw Error(where, " = ", value, " must be positive, of a ratio that is not 0");
      return size / std::abs(of);
    }
    if (key.second == Kind::pitch) return length(where, value) / base_.view.system.hx;
    const Dimension dimension = key.first == "load"       ? Dimension::force
                                : key.first == "approach" ? Dimension::length
                                                          : Dimension::pressure;
    if (dimension == Dimension::length) return length(where, value) / base_.targets.back();
    const Quantity size = read_positive(where, value, dimension);
    if (base_.view.si != 1 && !size.bare) throw Error(where, " = ", value, " has a unit, but none of the words and maps has one");
    const std::vector<Quantity> of = words_.quantities(*word, dimension);
    return size.si() / (key.first == "load" || key.first == "pressure" ? of.back() : of.front()).si();
  }

  const rc_request_spec& spec_;
  const Words words_;
  const rc_request& base_;
};

}  // namespace

std::int64_t solves_of(const Source& source, std::int64_t samples) {
  switch (source.kind) {
    case Kind::noise:
    case Kind::shift:
      return samples;
    case Kind::word:
    case Kind::pitch:
    case Kind::height:
    case Kind::grid:
      return 2;
    case Kind::window:
      return static_cast<std::int64_t>(source.size * source.size);
    case Kind::maps:
      return static_cast<std::int64_t>(source.size);
    case Kind::solver:
      return 0;
    default:
      return 1;
  }
}

std::int64_t Sources::solves() const {
  std::int64_t sum = 1;
  for (const Source& each : all) sum += solves_of(each, samples);
  return sum;
}

Sources read_sources(const char* text, const rc_request_spec& spec, const rc_request& base) {
  constexpr std::int64_t most_samples = 100000;
  const Reader reader{spec, base};
  std::vector<std::string_view> names;
  for (const Key& key : keys) names.push_back(key.first);
  names.insert(names.end(), std::begin(settings), std::end(settings));
  Sources found;
  double correlation = 0;
  for (const std::string_view each : split(text, ',')) {
    const Setting setting = setting_of(each);
    const std::string_view key = setting.key, value = setting.value;
    const std::size_t place = choice("source", key, names);
    if (place < std::size(keys)) {
      if (std::ranges::any_of(found.all, [&](const Source& other) { return other.name == key; }))
        throw Error(Reader::spelt(key), " is given twice");
      found.all.push_back(reader.source(keys[place], value));
    } else if (key == "correlation") {
      correlation = reader.length(Reader::spelt(key), value);
    } else if (key == "samples") {
      found.samples = reader.whole(Reader::spelt(key), value, 2, most_samples);
    } else {
      found.seed = static_cast<std::uint64_t>(reader.whole(Reader::spelt(key), value, 0, INT64_C(1) << 53));
    }
  }
  const auto noise = std::ranges::find(found.all, Kind::noise, &Source::kind);
  if (correlation > 0 && noise == found.all.end()) throw Error("source correlation is of noise, which is not given");
  if (correlation > 0) noise->correlation = correlation;
  found.all.push_back({.kind = Kind::solver, .name = "solver"});
  return found;
}

}  // namespace rc::request
