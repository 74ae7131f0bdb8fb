#include "support/reference_cases.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace pairs {

namespace {

using nlohmann::json;

const std::string folder = RC_TEST_DATA "/cases/";

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
template <class Values> Values spread(const Values& values, const ReferenceCase& reference, typename Values::value_type filling) {
  if (reference.spacing == 1) return values;
  Values result(reference.problem.points(), filling);
  for (std::int64_t i = 0; i < reference.rows; ++i)
    for (std::int64_t j = 0; j < reference.columns; ++j)
      result[static_cast<std::size_t>((i * reference.problem.system.nx + j) * reference.spacing)] =
          values[static_cast<std::size_t>(i * reference.columns + j)];
  return result;
}

ReferenceCase read_case(const json& entry) {
  ReferenceCase reference;
  reference.name = entry["name"];
  reference.rows = entry["n1"];
  reference.columns = entry["n2"];
  reference.spacing = entry["spacing"];
  reference.load = entry["total_load"];
  reference.contacts = entry["contacts"];
  reference.candidates = entry["n_trial"];
  reference.count_is_robust = margin(entry, "margin_p") > 1e-6 && margin(entry, "margin_w") > 1e-6;
  const auto n = static_cast<std::size_t>(reference.rows * reference.columns);

  Problem& problem = reference.problem;
  problem.kernel = entry["kernel"];
  rc_system& system = problem.system;
  system.nx = reference.columns * reference.spacing;
  system.ny = reference.rows * reference.spacing;
  system.hx = system.hy = entry["delta"];
  system.modulus = entry["Es"];

  Field gap = read_table(entry["input_file"], n);
  const double highest = *std::max_element(gap.begin(), gap.end());
  if (entry["input"] == "ubar") {
    for (double& value : gap) value = -value;
    reference.depth = highest;
  } else {
    for (double& value : gap) value = highest - value;
    problem.target = reference.depth = entry["Delta"];
  }
  Field pressure = read_table(entry["p_file"], n);
  for (double& value : pressure) value /= problem.cell_area();

  problem.gap = spread(gap, reference, 0.0);
  if (reference.spacing > 1) problem.mask = spread(std::vector<std::uint8_t>(n, 1), reference, 0);
  reference.p = spread(pressure, reference, 0.0);
  return reference;
}

}  // namespace

ReferenceCases read_reference_cases() {
  std::ifstream in(folder + "index.json");
  check(static_cast<bool>(in), folder + "index.json cannot be read");
  const json index = json::parse(in);
  ReferenceCases result;
  for (const json& entry : index["cases"]) result.cases.push_back(read_case(entry));
  for (const json& entry : index["load_control"])
    result.load_control.push_back(
        {entry["name"], entry["same_inputs_as"], entry["target_load"], entry["expected_Delta"], entry["expected_contacts"]});
  return result;
}

Field stored_points(const ReferenceCase& reference, const Field& values) {
  Field result;
  for (std::int64_t i = 0; i < reference.rows; ++i)
    for (std::int64_t j = 0; j < reference.columns; ++j)
      result.push_back(values[static_cast<std::size_t>((i * reference.problem.system.nx + j) * reference.spacing)]);
  return result;
}

// NumPy's format 1.0: ten bytes, of which the last two are the length of a header, then the values.
Field read_npy(const std::string& name, std::size_t expected) {
  std::ifstream in(name, std::ios::binary);
  char head[10] = {};
  in.read(head, sizeof head);
  const int length = static_cast<unsigned char>(head[8]) + 256 * static_cast<unsigned char>(head[9]);
  std::string header(static_cast<std::size_t>(length), ' ');
  in.read(header.data(), length);
  check(static_cast<bool>(in) && header.find("'<f8'") != std::string::npos &&
            header.find("'fortran_order': False") != std::string::npos,
        name + " is not an array of doubles");
  Field values(expected);
  in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(expected * sizeof(double)));
  check(static_cast<bool>(in) && in.peek() == std::ifstream::traits_type::eof(), name + " has another length");
  return values;
}

}  // namespace pairs
