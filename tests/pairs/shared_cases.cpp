#include "shared_cases.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace pairs {

namespace {

using nlohmann::json;

const std::string folder = std::string(RC_SHARED_DIR) + "/cases/";

Field read_table(const std::string& file, std::size_t expected) {
  std::ifstream in(folder + file);
  Field values;
  double value = 0;
  while (in >> value) {
    values.push_back(value);
    if (in.peek() == ',') in.ignore();
  }
  check(in.eof() && values.size() == expected, file + " cannot be read");
  return values;
}

double margin(const json& entry, const char* key) { return entry[key].is_null() ? 1 : entry[key].get<double>(); }

// On a grid with `spacing` times as many points along both directions; the points between get `filling`.
template <class Values> Values spread(const Values& values, const SharedCase& shared, typename Values::value_type filling) {
  if (shared.spacing == 1) return values;
  Values result(shared.problem.points(), filling);
  for (std::int64_t i = 0; i < shared.rows; ++i)
    for (std::int64_t j = 0; j < shared.columns; ++j)
      result[static_cast<std::size_t>((i * shared.problem.system.nx + j) * shared.spacing)] =
          values[static_cast<std::size_t>(i * shared.columns + j)];
  return result;
}

SharedCase read_case(const json& entry) {
  SharedCase shared;
  shared.name = entry["name"];
  shared.rows = entry["n1"];
  shared.columns = entry["n2"];
  shared.spacing = entry["spacing"];
  shared.load = entry["total_load"];
  shared.contacts = entry["contacts"];
  shared.candidates = entry["n_trial"];
  shared.count_is_robust = margin(entry, "margin_p") > 1e-6 && margin(entry, "margin_w") > 1e-6;
  const auto n = static_cast<std::size_t>(shared.rows * shared.columns);

  Problem& problem = shared.problem;
  problem.kernel = entry["kernel"];
  rc_system& system = problem.system;
  system.nx = shared.columns * shared.spacing;
  system.ny = shared.rows * shared.spacing;
  system.hx = system.hy = entry["delta"];
  system.modulus = entry["Es"];

  Field gap = read_table(entry["input_file"], n);
  const double highest = *std::max_element(gap.begin(), gap.end());
  if (entry["input"] == "ubar") {
    for (double& value : gap) value = -value;
    shared.depth = highest;
  } else {
    for (double& value : gap) value = highest - value;
    problem.target = shared.depth = entry["Delta"];
  }
  Field pressure = read_table(entry["p_file"], n);
  for (double& value : pressure) value /= problem.cell_area();

  problem.gap = spread(gap, shared, 0.0);
  if (shared.spacing > 1) problem.mask = spread(std::vector<std::uint8_t>(n, 1), shared, 0);
  shared.p = spread(pressure, shared, 0.0);
  return shared;
}

}  // namespace

std::optional<SharedCases> read_shared_cases() {
  std::ifstream in(folder + "index.json");
  if (!in) return std::nullopt;
  const json index = json::parse(in);
  SharedCases result;
  for (const json& entry : index["cases"]) result.cases.push_back(read_case(entry));
  for (const json& entry : index["load_control"])
    result.load_control.push_back(
        {entry["name"], entry["same_inputs_as"], entry["target_load"], entry["expected_Delta"], entry["expected_contacts"]});
  return result;
}

Field stored_points(const SharedCase& shared, const Field& values) {
  Field result;
  for (std::int64_t i = 0; i < shared.rows; ++i)
    for (std::int64_t j = 0; j < shared.columns; ++j)
      result.push_back(values[static_cast<std::size_t>((i * shared.problem.system.nx + j) * shared.spacing)]);
  return result;
}

}  // namespace pairs
