// NumPy's .npy, versions 1 to 3: magic, version, header length, a Python dictionary with descr, fortran_order and shape, then
// data.
#include "formats/npy.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/readers.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

struct NpyHeader {
  std::string_view descr;
  std::string_view fortran_order;
  std::string_view shape;
};

// Splits "{'key': value, ...}". A value may be a quoted text, a word or a flat tuple, which is all that a plain array needs.
class Dictionary {
 public:
  explicit Dictionary(std::string_view text) : rest_(text) {}

  NpyHeader parse() {
    NpyHeader header;
    expect('{');
    while (!accept('}')) {
      const auto key = value();
      expect(':');
      const auto entry = value();
      if (key == "descr") header.descr = entry;
      if (key == "fortran_order") header.fortran_order = entry;
      if (key == "shape") header.shape = entry;
      if (!accept(',')) {
        expect('}');
        break;
      }
    }
    if (!trimmed(rest_).empty()) throw Error("the header goes on after its dictionary: ", in_quotes(trimmed(rest_)));
    return header;
  }

 private:
  bool accept(char c) {
    rest_ = rest_.substr(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void expect(char c) {
    if (!accept(c)) throw Error("the header has ", in_quotes(rest_.substr(0, 20)), " where '", c, "' should be");
  }

  // Takes the text up to `end`, and `end` itself.
  std::string_view until(char end) {
    const auto length = rest_.find(end);
    if (length == std::string_view::npos) throw Error("the header ends within ", in_quotes(rest_.substr(0, 20)));
    const auto text = rest_.substr(0, length);
    rest_.remove_prefix(length + 1);
    return text;
  }

  std::string_view value() {
    if (accept('\'')) return until('\'');
    if (accept('"')) return until('"');
    if (accept('(')) return until(')');
    const auto word = rest_.substr(0, rest_.find_first_of(",:{}[]() \n"));
    rest_.remove_prefix(word.size());
    return word;
  }

  std::string_view rest_;
};

std::pair<std::int64_t, std::int64_t> parse_shape(std::string_view text) {
  auto parts = split(text, ',');
  if (parts.size() == 3 && trimmed(parts.back()).empty()) parts.pop_back();  // a trailing comma
  const auto ny = to_integer(parts[0]);
  const auto nx = parts.size() == 2 ? to_integer(parts[1]) : std::nullopt;
  if (!ny || !nx) throw Error("shape ", in_quotes(join("(", text, ")")), " is not (ny, nx)");
  return {*ny, *nx};
}

bool parse_order(std::string_view text) {
  if (text != "True" && text != "False") throw Error("fortran_order ", in_quotes(text), " is neither True nor False");
  return text == "True";
}

template <class Number> double load(const char* bytes, std::endian order) {
  return static_cast<double>(stored_number<Number>(bytes, order));
}

// IEEE 754 binary16: a sign, 5 bits of exponent, 10 of the fraction.
double load_half(const char* bytes, std::endian order) {
  const auto bits = stored_number<std::uint16_t>(bytes, order);
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  double size = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  if (exponent == 31) size = fraction == 0 ? std::numeric_limits<double>::infinity() : missing_height;
  return bits >> 15 ? -size : size;
}

struct NumberType {
  std::string_view code;
  std::size_t size;
  double (*load)(const char* bytes, std::endian order);
};
constexpr NumberType number_types[] = {
    {"f2", 2, load_half},           {"f4", 4, load<float>},         {"f8", 8, load<double>},       {"i1", 1, load<std::int8_t>},
    {"i2", 2, load<std::int16_t>},  {"i4", 4, load<std::int32_t>},  {"i8", 8, load<std::int64_t>}, {"u1", 1, load<std::uint8_t>},
    {"u2", 2, load<std::uint16_t>}, {"u4", 4, load<std::uint32_t>}, {"u8", 8, load<std::uint64_t>}};

const NumberType& number_type(std::string_view descr) {
  if (descr.size() == 3 && std::string_view("<>=|").find(descr[0]) != std::string_view::npos) {
    for (const auto& type : number_types) {
      if (type.code == descr.substr(1)) return type;
    }
  }
  throw Error("data type ", in_quotes(descr), descr == "|b1" ? " is truth values, not heights" : " cannot be read",
              "; known are f2, f4, f8, i1 to i8 and u1 to u8, into which astype() of NumPy converts");
}

std::endian byte_order(char mark) {
  if (mark == '<') return std::endian::little;
  return mark == '>' ? std::endian::big : std::endian::native;
}

// Cuts the dictionary off the front of the file.
std::string_view take_header(std::string_view& file) {
  if (!file.starts_with(npy_magic)) throw Error("the file does not begin with \\x93NUMPY");
  const int version = file.size() > npy_magic.size() ? static_cast<unsigned char>(file[npy_magic.size()]) : 0;
  if (version < 1 || version > 3) throw Error("version ", version, " of the format, known are 1 to 3");

  const std::size_t preamble = version == 1 ? 10 : 12;
  if (file.size() < preamble) throw Error("the file ends within the header");
  const std::size_t length = version == 1 ? stored_number<std::uint16_t>(file.data() + 8, std::endian::little)
                                          : stored_number<std::uint32_t>(file.data() + 8, std::endian::little);
  if (length > npy_longest_header) throw Error("the header has ", length, " bytes, at most ", npy_longest_header);
  if (length > file.size() - preamble) throw Error("the file ends within the header");

  const auto header = file.substr(preamble, length);
  file.remove_prefix(preamble + length);
  return header;
}

}  // namespace

NpyLayout npy_layout(std::string_view file) {
  std::string_view rest = file;
  const NpyHeader header = Dictionary{take_header(rest)}.parse();
  const NumberType& type = number_type(header.descr);
  const auto [ny, nx] = parse_shape(header.shape);
  return {ny,        nx,        parse_order(header.fortran_order), type.code[0] == 'f',
          type.size, type.load, byte_order(header.descr[0]),       file.size() - rest.size()};
}

Surface read_npy(std::string_view file, const BareUnit& unit) {
  const NpyLayout layout = npy_layout(file);
  file.remove_prefix(layout.data);
  const std::int64_t nx = layout.nx, ny = layout.ny;
  check_data_size(nx, ny, layout.size, file.size());

  Surface surface;
  const double metres = file_unit(surface, "heights", "", unit);
  surface.nx = nx;
  surface.ny = ny;
  surface.heights.reserve(file.size() / layout.size);
  const std::int64_t row = layout.fortran_order ? 1 : nx, column = layout.fortran_order ? ny : 1;
  for (std::int64_t iy = 0; iy < ny; ++iy) {
    for (std::int64_t ix = 0; ix < nx; ++ix) {
      const auto index = static_cast<std::size_t>(iy * row + ix * column);
      surface.heights.push_back(metres * layout.number(file.data() + index * layout.size));
    }
  }
  return surface;
}

}  // namespace rc::formats
