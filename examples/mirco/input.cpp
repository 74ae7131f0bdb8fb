#include "input.h"

#include <cstdlib>
#include <filesystem>
#include <pugixml.hpp>
#include <stdexcept>

namespace {

// Parameters by name, in whatever list they stand.
class Parameters {
 public:
  explicit Parameters(const std::string& path) : path_(path) {
    const pugi::xml_parse_result read = document_.load_file(path.c_str());
    if (!read) refuse("no XML can be read: ", read.description());
    if (!document_.child("ParameterList")) refuse("there is no ParameterList: ", "give an input file of MIRCO's");
  }

  bool has(const char* name) const { return find(name) != nullptr; }
  std::string text(const char* name) const {
    const pugi::xml_node node = find(name);
    if (!node) refuse(name, " is missing");
    return node.attribute("value").value();
  }
  double number(const char* name) const {
    const std::string value = text(name);
    char* end = nullptr;
    const double result = std::strtod(value.c_str(), &end);
    if (value.empty() || *end != '\0') refuse(name, " = \"" + value + "\" is not a number");
    return result;
  }
  double positive(const char* name) const {
    const double value = number(name);
    if (!(value > 0)) refuse(name, " = " + text(name) + " must be positive");
    return value;
  }
  bool flag(const char* name) const {
    const std::string value = text(name);
    if (value != "true" && value != "false") refuse(name, " = \"" + value + "\" is neither true nor false");
    return value == "true";
  }
  [[noreturn]] void refuse(const std::string& what, const std::string& why) const {
    throw std::runtime_error(path_ + ": " + what + why);
  }

 private:
  pugi::xml_node find(const char* name) const {
    return document_.find_node([&](const pugi::xml_node& node) {
      return std::string(node.name()) == "Parameter" && std::string(node.attribute("name").value()) == name;
    });
  }

  std::string path_;
  pugi::xml_document document_;
};

}  // namespace

MircoInput read_mirco_input(const std::string& path) {
  const Parameters given(path);
  if (given.has("RandomTopologyFlag") && given.flag("RandomTopologyFlag"))
    given.refuse("RandomTopologyFlag = true: ",
                 "random heights are those of one program; write them to a file, and name it in TopologyFilePath");
  MircoInput input;
  const auto softness = [&](const char* modulus, const char* poisson) {
    const double nu = given.number(poisson);
    return (1 - nu * nu) / given.positive(modulus);
  };
  input.modulus = 1 / (softness("E1", "nu1") + softness("E2", "nu2"));
  input.lateral_length = given.positive("LateralLength");
  input.delta = given.positive("Delta");
  input.tolerance = given.positive("Tolerance");
  if (given.has("MaxIteration")) input.max_iteration = static_cast<int>(given.positive("MaxIteration"));
  if (given.has("WarmStartingFlag")) input.warm_starting = given.flag("WarmStartingFlag");
  input.pressure_green_function = given.flag("PressureGreenFunFlag");
  if (given.has("ExpectedPressure")) input.expected_pressure = given.number("ExpectedPressure");
  std::filesystem::path file = given.text("TopologyFilePath");
  if (file.is_relative()) file = std::filesystem::path(path).parent_path() / file;
  input.topography = read_topography(file.string());
  return input;
}
