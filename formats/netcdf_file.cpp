#include "formats/netcdf_file.h"

#include <limits>
#include <string>

#include "formats/binary.h"
#include "formats/error.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

enum Tag : std::uint32_t { absent = 0, dimension_list = 10, variable_list = 11, attribute_list = 12 };
enum Type : std::uint32_t { nc_char = 2, nc_short, nc_int, nc_float, nc_double };

template <class Number> std::vector<double> numbers(std::string_view values) {
  std::vector<double> found;
  append_numbers<Number>(values, std::endian::big, found, [](Number value) { return static_cast<double>(value); });
  return found;
}

struct NetcdfType {
  std::uint64_t size;
  std::vector<double> (*read)(std::string_view values);
};
// By their codes, which begin with 1: byte, char, short, int, float, double, ubyte, ushort, uint, int64, uint64.
constexpr NetcdfType netcdf_types[] = {{1, numbers<std::int8_t>},   {1, nullptr},
                                       {2, numbers<std::int16_t>},  {4, numbers<std::int32_t>},
                                       {4, numbers<float>},         {8, numbers<double>},
                                       {1, numbers<std::uint8_t>},  {2, numbers<std::uint16_t>},
                                       {4, numbers<std::uint32_t>}, {8, numbers<std::int64_t>},
                                       {8, numbers<std::uint64_t>}};

const NetcdfType& netcdf_type(std::uint32_t code) {
  if (code == 0 || code > std::size(netcdf_types)) throw Error("type ", code, " is not known; the file is damaged");
  return netcdf_types[code - 1];
}

struct Dimension {
  std::string_view name;
  std::uint64_t length;
};

// Reads the header from its beginning to its end. The version sets how wide counts and offsets are.
class NetcdfHeader {
 public:
  NetcdfHeader(std::string_view file, int version) : file_(file), wide_counts_(version == 5), wide_offsets_(version != 1) {}

  std::uint32_t word() { return take<std::uint32_t>(); }
  std::uint64_t count() { return wide_counts_ ? take<std::uint64_t>() : take<std::uint32_t>(); }
  std::uint64_t offset() { return wide_offsets_ ? take<std::uint64_t>() : take<std::uint32_t>(); }

  // Bytes, padded to a multiple of four.
  std::string_view bytes(std::uint64_t size) {
    const auto found = piece(file_, at_, size, "the header");
    at_ += size;
    at_ = std::min<std::uint64_t>((at_ + 3) / 4 * 4, file_.size());
    return found;
  }
  std::string_view name() { return bytes(count()); }

  // The number of entries in a list. Every entry takes some bytes of the file, which bounds the number.
  std::uint64_t list(Tag expected) {
    const std::uint32_t tag = word();
    const std::uint64_t entries = count();
    if (tag == absent && entries == 0) return 0;
    if (tag != expected)
      throw Error("the header has tag ", tag, " at byte ", at_, ", ", std::uint32_t{expected},
                  " is expected; the file is damaged");
    check_count(entries);
    return entries;
  }

  void check_count(std::uint64_t entries) const {
    if (entries > (file_.size() - at_) / 4)
      throw Error("the header claims ", entries, " entries, more than the file has room for; it is damaged");
  }

 private:
  template <class Number> Number take() {
    const auto value = field<Number>(file_, at_, "the header", std::endian::big);
    at_ += sizeof(Number);
    return value;
  }

  std::string_view file_;
  bool wide_counts_, wide_offsets_;
  std::uint64_t at_ = 4;  // after the magic
};

std::vector<NetcdfFile::Attribute> read_attributes(NetcdfHeader& header) {
  std::vector<NetcdfFile::Attribute> attributes;
  for (std::uint64_t left = header.list(attribute_list); left > 0; --left) {
    const auto name = header.name();
    const auto type = header.word();
    const auto count = header.count();
    header.check_count(count / 4);
    attributes.push_back({name, type, header.bytes(count * netcdf_type(type).size)});
  }
  return attributes;
}

std::vector<Dimension> read_dimensions(NetcdfHeader& header) {
  std::vector<Dimension> dimensions;
  for (std::uint64_t left = header.list(dimension_list); left > 0; --left) {
    const auto name = header.name();
    dimensions.push_back({name, header.count()});
  }
  return dimensions;
}

NetcdfFile::Variable read_variable(NetcdfHeader& header, const std::vector<Dimension>& dimensions, std::string_view file) {
  NetcdfFile::Variable variable;
  variable.name = header.name();
  const std::uint64_t rank = header.count();
  header.check_count(rank);
  bool record = false;
  for (std::uint64_t k = 0; k < rank; ++k) {
    const std::uint64_t id = header.count();
    if (id >= dimensions.size())
      throw Error("variable ", in_quotes(variable.name), " has dimension ", id, " of ", dimensions.size(),
                  "; the file is damaged");
    variable.dimensions.push_back(dimensions[id].name);
    variable.shape.push_back(static_cast<std::int64_t>(std::min<std::uint64_t>(dimensions[id].length, 1ull << 62)));
    record = record || dimensions[id].length == 0;
  }
  variable.attributes = read_attributes(header);
  variable.type = header.word();
  header.count();  // the size in bytes, which overflows for large variables and follows from the shape
  const std::uint64_t begin = header.offset();
  if (record) return variable;  // without values: records are scattered over the file and hold no map

  std::uint64_t size = netcdf_type(variable.type).size;
  for (const auto length : variable.shape) {
    if (static_cast<std::uint64_t>(length) > file.size() / size) {
      throw Error("variable ", in_quotes(variable.name), " has more values than the file of ", file.size(),
                  " bytes can hold; it is truncated or damaged");
    }
    size *= static_cast<std::uint64_t>(length);
  }
  variable.values = piece(file, begin, size, "the values of " + in_quotes(variable.name));
  return variable;
}

const NetcdfFile::Attribute* find_attribute(const NetcdfFile::Variable* variable, std::string_view name) {
  if (!variable) return nullptr;
  for (const auto& attribute : variable->attributes) {
    if (attribute.name == name) return &attribute;
  }
  return nullptr;
}

}  // namespace

NetcdfFile::NetcdfFile(std::string_view file) {
  if (file.starts_with("\x89HDF")) {
    throw Error("the file is NetCDF-4 (HDF5), only the classic formats can be read; convert it with \"nccopy -k cdf5\"");
  }
  const int version = file.starts_with("CDF") && file.size() > 3 ? file[3] : 0;
  if (version != 1 && version != 2 && version != 5) throw Error("the file does not begin with CDF and version 1, 2 or 5");

  NetcdfHeader header{file, version};
  header.count();  // of records
  const auto dimensions = read_dimensions(header);
  read_attributes(header);
  for (std::uint64_t left = header.list(variable_list); left > 0; --left) {
    variables_.push_back(read_variable(header, dimensions, file));
  }
}

const NetcdfFile::Variable* NetcdfFile::find(std::string_view name) const {
  for (const auto& variable : variables_) {
    if (variable.name == name) return &variable;
  }
  return nullptr;
}

std::vector<double> netcdf_numbers(std::uint32_t type, std::string_view values, std::string_view what) {
  if (const auto read = netcdf_type(type).read) return read(values);
  throw Error(what, " is of type ", type, ", a number is needed");
}

std::string_view netcdf_text(const NetcdfFile::Variable* variable, std::string_view attribute) {
  const auto* const found = find_attribute(variable, attribute);
  if (!found || found->type != nc_char) return {};
  return trimmed(found->values.substr(0, found->values.find('\0')));
}

std::optional<double> netcdf_number(const NetcdfFile::Variable* variable, std::string_view attribute) {
  const auto* const found = find_attribute(variable, attribute);
  if (!found || found->values.empty()) return std::nullopt;
  return netcdf_numbers(found->type, found->values, "attribute " + in_quotes(attribute)).front();
}

double netcdf_default_fill(std::uint32_t type) {
  if (type == nc_short) return -32767;
  if (type == nc_int) return -2147483647;
  return type == nc_float || type == nc_double ? 0x1.ep122 : std::numeric_limits<double>::quiet_NaN();  // none
}

}  // namespace rc::formats
