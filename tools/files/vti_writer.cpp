#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "files/step_writers.h"
#include "text.h"

namespace cli {

namespace {

// The file is XML up to the raw values, which begin after an underscore.
constexpr std::string_view raw_begins = "_";

void add_number(pugi::xml_node parent, const StepImage::Number& number) {
  pugi::xml_node array = parent.append_child("DataArray");
  const auto* const text = std::get_if<std::string>(&number.value);
  const auto* const whole = std::get_if<std::int64_t>(&number.value);
  array.append_attribute("type") = text ? "String" : whole ? "Int64" : "Float64";
  const std::string name = number.unit.empty() ? number.name : number.name + " [" + number.unit + "]";
  array.append_attribute("Name") = name.c_str();
  array.append_attribute("NumberOfTuples") = 1;
  array.append_attribute("format") = "ascii";
  std::string values;
  if (text) {
    for (const char c : *text) values += format("%d ", static_cast<unsigned char>(c));
    values += "0";
  } else {
    values = whole ? std::to_string(*whole) : format("%.17g", std::get<double>(number.value));
  }
  array.text().set(values.c_str());
}

// Everything around the values.
std::string frame(const StepImage& image) {
  pugi::xml_document document;
  pugi::xml_node file = document.append_child("VTKFile");
  file.append_attribute("type") = "ImageData";
  file.append_attribute("version") = "1.0";
  file.append_attribute("byte_order") = "LittleEndian";
  file.append_attribute("header_type") = "UInt64";
  pugi::xml_node grid = file.append_child("ImageData");
  const std::string extent = format("0 %lld 0 %lld 0 0", static_cast<long long>(image.nx), static_cast<long long>(image.ny));
  grid.append_attribute("WholeExtent") = extent.c_str();
  grid.append_attribute("Origin") = "0 0 0";
  grid.append_attribute("Spacing") = format("%.17g %.17g 1", image.hx, image.hy).c_str();
  pugi::xml_node numbers = grid.append_child("FieldData");
  for (const StepImage::Number& number : image.numbers) {
    const auto* const real = std::get_if<double>(&number.value);
    if (!real || std::isfinite(*real)) add_number(numbers, number);  // VTK reads no nan from text
  }
  pugi::xml_node piece = grid.append_child("Piece");
  piece.append_attribute("Extent") = extent.c_str();
  pugi::xml_node cells = piece.append_child("CellData");
  cells.append_attribute("Scalars") = "pressure [Pa]";
  std::size_t offset = 0;
  for (const StepImage::Field& field : image.fields) {
    pugi::xml_node array = cells.append_child("DataArray");
    array.append_attribute("type") = "Float64";
    array.append_attribute("Name") = format("%s [%s]", field.name, field.unit).c_str();
    array.append_attribute("format") = "appended";
    array.append_attribute("offset") = static_cast<unsigned long long>(offset);
    offset += sizeof(std::uint64_t) + image.points() * sizeof(double);
  }
  pugi::xml_node values = file.append_child("AppendedData");
  values.append_attribute("encoding") = "raw";
  values.text().set(raw_begins.data());
  std::ostringstream text;
  document.save(text, "  ", pugi::format_indent);
  return text.str();
}

}  // namespace

void write_vti(const StepImage& image, std::FILE* file) {
  const std::string text = frame(image);
  const std::size_t begin = text.rfind(std::string(raw_begins) + "</AppendedData>") + raw_begins.size();
  std::fwrite(text.data(), 1, begin, file);
  for (const StepImage::Field& field : image.fields) {
    const std::uint64_t bytes = image.points() * sizeof(double);
    std::fwrite(&bytes, sizeof bytes, 1, file);
    std::fwrite(field.values, sizeof(double), image.points(), file);
  }
  std::fwrite(text.data() + begin, 1, text.size() - begin, file);
}

}  // namespace cli
