#include "input.h"

#include <roughcontact/analysis.h>
#include <yaml.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "topography.h"

namespace MIRCO {

namespace {

// Parameters by name, in whatever section they stand.
class Parameters {
 public:
  explicit Parameters(const std::string& path) : path_(path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) refuse("", "cannot be opened");
    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser)) throw std::bad_alloc();
    yaml_parser_set_input_file(&parser, file.get());
    const bool read = yaml_parser_load(&parser, &document_) != 0;
    const std::string problem = parser.problem ? parser.problem : "";
    const std::size_t line = parser.problem_mark.line + 1;
    yaml_parser_delete(&parser);
    if (!read) refuse("no YAML can be read, line " + std::to_string(line) + ": ", problem);
  }
  Parameters(const Parameters&) = delete;
  Parameters& operator=(const Parameters&) = delete;
  ~Parameters() { yaml_document_delete(&document_); }

  bool has(const char* name) const { return find(name) != nullptr; }
  std::string text(const char* name) const {
    const yaml_node_t* node = find(name);
    if (!node) refuse(name, " is missing");
    return scalar(node);
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
  int whole(const char* name, int lower, int upper) const {
    const double value = number(name);
    if (!(value >= lower && value <= upper) || value != static_cast<int>(value))
      refuse(name, " = " + text(name) + " must be a whole number, " + std::to_string(lower) + " .. " + std::to_string(upper));
    return static_cast<int>(value);
  }
  bool flag(const char* name) const {
    const std::string value = text(name);
    const bool yes = value == "true" || value == "True" || value == "1";
    if (!yes && value != "false" && value != "False" && value != "0")
      refuse(name, " = \"" + value + "\" is neither true nor false");
    return yes;
  }
  bool flag(const char* name, bool otherwise) const { return has(name) ? flag(name) : otherwise; }
  [[noreturn]] void refuse(const std::string& what, const std::string& why) const {
    throw std::runtime_error(path_ + ": " + what + why);
  }

 private:
  static std::string scalar(const yaml_node_t* node) {
    if (node->type != YAML_SCALAR_NODE) return "";
    return {reinterpret_cast<const char*>(node->data.scalar.value), node->data.scalar.length};
  }
  const yaml_node_t* find(const char* name) const {
    auto* document = const_cast<yaml_document_t*>(&document_);
    for (int i = 1; const yaml_node_t* node = yaml_document_get_node(document, i); ++i) {
      if (node->type != YAML_MAPPING_NODE) continue;
      for (const yaml_node_pair_t* pair = node->data.mapping.pairs.start; pair < node->data.mapping.pairs.top; ++pair)
        if (scalar(yaml_document_get_node(document, pair->key)) == name) return yaml_document_get_node(document, pair->value);
    }
    return nullptr;
  }

  std::string path_;
  yaml_document_t document_;
};

Heights heights(const Parameters& given, const std::string& path) {
  if (given.flag("RandomTopologyFlag", false)) {
    if (given.flag("RandomSeedFlag", false))
      given.refuse("RandomSeedFlag = true: ",
                   "a surface of no known seed can not be made again; set it to false, and RandomGeneratorSeed");
    return random_topography(given.whole("Resolution", 1, 14), given.number("InitialTopologyStdDeviation"),
                             given.number("HurstExponent"),
                             static_cast<unsigned>(given.whole("RandomGeneratorSeed", 0, 2147483647)));
  }
  std::filesystem::path file = given.text("TopologyFilePath");
  if (file.is_relative()) file = std::filesystem::path(path).parent_path() / file;
  Topography map = read_topography(file.string());
  return {map.side, std::move(map.heights)};
}

double punch_stiffness(const InputParameters& input) {
  rc_options* made = nullptr;
  rc_status status = rc_options_create(nullptr, &made);
  const std::unique_ptr<rc_options, void (*)(rc_options*)> options(made, rc_options_destroy);
  if (status == RC_OK)
    status = rc_options_set_text(options.get(), RC_OPT_KERNEL, input.pressure_green_funct_flag ? "love" : "eq9");
  if (status == RC_OK) status = rc_options_set_number(options.get(), RC_OPT_TOL, 1e-12);
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = input.topology.side;
  system.hx = system.hy = input.grid_size;
  system.modulus = input.composite_youngs;
  double stiffness = 0;
  if (status == RC_OK) status = rc_punch_stiffness(&system, {}, options.get(), &stiffness, nullptr, nullptr);
  if (status < 0) throw std::runtime_error(std::string("the square as a flat punch: ") + rc_last_error());
  return stiffness;
}

}  // namespace

double Heights::highest() const { return *std::max_element(values.begin(), values.end()); }

InputParameters::InputParameters(const std::string& file) {
  const Parameters given(file);
  if (!given.has("mirco_input")) given.refuse("there is no mirco_input: ", "give an input file of MIRCO's");
  if (given.flag("ExportVisualization", false)) given.refuse("ExportVisualization = true: ", "no VTK files are written");
  const auto softness = [&](const char* modulus, const char* poisson) {
    const double nu = given.number(poisson);
    return (1 - nu * nu) / given.positive(modulus);
  };
  composite_youngs = 1 / (softness("E1", "nu1") + softness("E2", "nu2"));
  lateral_length = given.positive("LateralLength");
  delta = given.positive("Delta");
  tolerance = given.positive("Tolerance");
  if (given.has("MaxIteration")) max_iteration = given.whole("MaxIteration", 1, 2147483647);
  warm_starting_flag = given.flag("WarmStartingFlag", true);
  pressure_green_funct_flag = given.flag("PressureGreenFunFlag");
  if (given.has("ExpectedPressure")) expected_pressure = given.number("ExpectedPressure");
  if (given.has("ExpectedEffectiveContactAreaFraction"))
    expected_area_fraction = given.number("ExpectedEffectiveContactAreaFraction");
  topology = heights(given, file);
  grid_size = lateral_length / static_cast<double>(topology.side);
  elastic_compliance_correction = punch_stiffness(*this);
}

}  // namespace MIRCO
