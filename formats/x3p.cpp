// X3P of ISO 25178-72 (ISO 5436-2): a zip archive with main.xml, which holds the axes, the size and the heights or the name of a
// binary file with them. Maps on incremental axes x and y are read; z stands alone there, x fastest. Namespaces and folders
// differ between writers, and so does what they call an integer: the length of the data decides how wide the numbers are.
#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <string>

#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/readers.h"
#include "formats/wording.h"
#include "formats/zip_archive.h"

namespace rc::formats {

namespace {

using pugi::xml_node;

constexpr std::uint64_t longest_xml = std::uint64_t{1} << 28, small_xml = std::uint64_t{1} << 22;
constexpr std::uint64_t most_xml_ratio = 32;  // lists of heights shrink to a tenth

// The parsed document takes 40 to 128 bytes for each tag and attribute, of which a height in a list has two, in some packed
// bytes.
constexpr std::uint64_t few_marks = std::uint64_t{1} << 19, most_marks = std::uint64_t{1} << 24, marks_per_byte = 4;

constexpr std::size_t least_width = 2, largest_width = 8;  // bytes of a number
constexpr std::uint64_t slack = 1024;                      // bytes after the bits of valid points

std::string_view local_name(const xml_node& node) {
  const std::string_view name = node.name();
  const auto colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

// The element below, by names without their namespace, "Record1/Axes/CX"; empty if there is none.
xml_node below(xml_node node, std::string_view path) {
  for (const auto name : split(path, '/')) {
    node = node.find_child([&](const xml_node& child) { return local_name(child) == name; });
  }
  return node;
}

std::string_view text_of(const xml_node& node, std::string_view path) { return trimmed(below(node, path).child_value()); }

std::string_view needed_text(const xml_node& node, std::string_view path) {
  const auto text = text_of(node, path);
  if (text.empty()) throw Error("main.xml has no ", path);
  return text;
}

std::int64_t size_of(const xml_node& record, std::string_view path) { return whole_number(path, needed_text(record, path)); }

double pitch(const xml_node& axes, const std::string& axis) {
  const auto type = needed_text(axes, axis + "/AxisType");
  if (type != "I") {
    throw Error(axis, " has AxisType ", in_quotes(type),
                ", only maps on a grid (I, incremental) can be read; resample the points on a grid first");
  }
  const std::string key = axis + "/Increment";
  return file_length(key, finite_number(key, needed_text(axes, key)));
}

struct HeightAxis {
  char type;  // I and L integers, F and D floating point
  double increment, offset;
};

HeightAxis height_axis(const xml_node& axes) {
  const auto type = needed_text(axes, "CZ/DataType");
  if (type.size() != 1 || std::string_view("ILFD").find(type[0]) == std::string_view::npos)
    throw Error("CZ/DataType ", in_quotes(type), " is not known, known are I, L, F and D");
  const auto increment = text_of(axes, "CZ/Increment"), offset = text_of(axes, "CZ/Offset");
  HeightAxis axis{type[0], 1, 0};
  if (!increment.empty()) axis.increment = file_length("CZ/Increment", finite_number("CZ/Increment", increment));
  if (!offset.empty()) axis.offset = finite_number("CZ/Offset", offset);
  return axis;
}

// Bounds the number of tags and attributes before the document is parsed, which takes many times its length.
void check_marks(std::string_view xml, std::uint64_t file_size) {
  const auto marks = static_cast<std::uint64_t>(std::ranges::count_if(xml, [](char c) { return c == '<' || c == '='; }));
  const std::uint64_t most = std::min(most_marks, few_marks + marks_per_byte * file_size);
  if (marks <= most) return;
  throw Error("main.xml has ", marks, " tags and attributes, at most ", most,
              " can be read of a file of that size; store the heights in a binary file");
}

// Paths in main.xml are relative to it.
std::size_t linked_entry(const std::vector<std::string>& names, const std::string& folder, std::string_view given) {
  std::string slashes{given};
  std::ranges::replace(slashes, '\\', '/');
  std::string_view link = slashes;
  while (link.starts_with("./") || link.starts_with('/')) link.remove_prefix(link.starts_with('/') ? 1 : 2);
  const std::string path = folder + std::string(link);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == path) return i;
  }
  throw Error("main.xml names the data file ", in_quotes(given), ", which is not in the archive");
}

// One bit a point, the lowest first; 0: missing.
void apply_valid_bits(std::string_view bits, std::vector<double>& heights) {
  piece(bits, 0, (heights.size() + 7) / 8, "the bits of valid points");
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!(static_cast<unsigned char>(bits[i / 8]) >> (i % 8) & 1)) heights[i] = missing_height;
  }
}

void read_binary(std::string_view data, const HeightAxis& z, Surface& surface) {
  const std::size_t points = data_size(surface.nx, surface.ny, 1, data.size());
  const std::size_t width = data.size() / points;
  if (width * points != data.size() || (width != least_width && width != 4 && width != largest_width)) {
    throw Error("the header says ", surface.nx, " x ", surface.ny, " points, but the data file has ", data.size(),
                " bytes, not 2, 4 or 8 for each; it is truncated");
  }
  const auto height = [&z](auto raw) { return z.increment * static_cast<double>(raw) + z.offset; };
  const bool whole = z.type == 'I' || z.type == 'L';
  if (width == 2) append_numbers<std::int16_t>(data, std::endian::little, surface.heights, height);
  if (width == 4 && whole) append_numbers<std::int32_t>(data, std::endian::little, surface.heights, height);
  if (width == 4 && !whole) append_numbers<float>(data, std::endian::little, surface.heights, height);
  if (width == 8) append_numbers<double>(data, std::endian::little, surface.heights, height);
}

// Datum: coordinates separated by semicolons, without those of incremental axes. An empty one is missing.
void read_list(const xml_node& list, const HeightAxis& z, std::size_t points, Surface& surface) {
  for (const xml_node& datum : list.children()) {
    if (local_name(datum) != "Datum") continue;
    const auto text = trimmed(split(datum.child_value(), ';').back());
    const auto value = text.empty() ? missing_height : to_number(text);
    if (!value) throw Error("Datum ", surface.heights.size() + 1, ": ", in_quotes(text), " is not a number");
    surface.heights.push_back(z.increment * *value + z.offset);
  }
  if (surface.heights.size() != points) {
    throw Error("the header says ", surface.nx, " x ", surface.ny, " points, but the list has ", surface.heights.size());
  }
}

}  // namespace

Surface read_x3p(std::string_view file, const BareUnit& unit) {
  const ZipArchive archive{file};
  const std::size_t main = main_xml_entry(archive.names());
  if (main == archive.names().size()) throw Error("the zip archive holds no main.xml, so it is no X3P");
  const std::string& path = archive.names()[main];
  const std::string folder = path.substr(0, path.size() - std::string_view("main.xml").size());

  std::string xml = archive.contents(main, std::min(longest_xml, small_xml + most_xml_ratio * file.size()));
  check_marks(xml, file.size());
  pugi::xml_document document;  // it keeps pointers into `xml`
  if (const auto parsed = document.load_buffer_inplace(xml.data(), xml.size()); !parsed) {
    throw Error("main.xml is not XML: ", parsed.description(), " at byte ", parsed.offset);
  }
  const xml_node root = document.document_element();
  const xml_node axes = below(root, "Record1/Axes"), record = below(root, "Record3");
  if (const auto type = needed_text(root, "Record1/FeatureType"); type != "SUR") {
    throw Error("FeatureType is ", in_quotes(type), ", only SUR (a surface) can be read",
                type == "PRF" ? "; PRF is a profile" : "");
  }

  Surface surface;
  surface.nx = size_of(record, "MatrixDimension/SizeX");
  surface.ny = size_of(record, "MatrixDimension/SizeY");
  if (const auto layers = size_of(record, "MatrixDimension/SizeZ"); layers != 1)
    throw Error("the file has ", layers, " layers, one is needed");
  file_unit(surface, "lengths", "m", unit);
  surface.hx = pitch(axes, "CX");
  surface.hy = pitch(axes, "CY");
  const HeightAxis z = height_axis(axes);

  if (const auto link = text_of(record, "DataLink/PointDataLink"); !link.empty()) {
    const std::size_t points = packed_data_size(surface.nx, surface.ny, least_width, file.size()) / least_width;
    read_binary(archive.contents(linked_entry(archive.names(), folder, link), largest_width * points), z, surface);
  } else if (const xml_node list = below(record, "DataList")) {
    // A Datum takes more bytes than a number does.
    read_list(list, z, data_size(surface.nx, surface.ny, 1, xml.size()), surface);
  } else {
    throw Error("main.xml has neither DataLink/PointDataLink nor DataList");
  }
  if (const auto link = text_of(record, "DataLink/ValidPointsLink"); !link.empty()) {
    const std::uint64_t most = surface.heights.size() / 8 + slack;
    apply_valid_bits(archive.contents(linked_entry(archive.names(), folder, link), most), surface.heights);
  }
  return surface;
}

}  // namespace rc::formats
