#include "capped_cases.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/registry.h"

namespace pairs {

namespace {

using nlohmann::json;

const std::string folder = RC_TEST_DATA "/cases/capped/";

// Doubles, row by row. NumPy's format 1.0: ten bytes, of which the last two are the length of a header, then the values.
Field read_npy(const std::string& name, std::size_t expected) {
  std::ifstream in(folder + name, std::ios::binary);
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

CappedCase read_case(const json& entry) {
  CappedCase result;
  result.name = entry["name"];
  Problem& problem = result.problem;
  rc_system& system = problem.system;
  system.nx = entry["nx"];
  system.ny = entry["ny"];
  system.hx = entry["hx"];
  system.hy = entry["hy"];
  system.modulus = entry["modulus"];
  system.hardness = entry["hardness"];
  system.boundary = entry["boundary"] == "periodic" ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE;
  problem.kernel = entry["kernel"];
  problem.control = entry["control"] == "load" ? RC_CONTROL_LOAD : RC_CONTROL_APPROACH;
  problem.gap = read_npy(result.name + "_gap.npy", problem.points());
  for (const json& given : entry["steps"]) {
    const std::string number = std::to_string(result.steps.size() + 1);
    CappedStep step{
        given["target"], given["approach"], given["load"], given["plastic_volume"], given["contacts"], given["capped"], {}, {}};
    step.p = read_npy(result.name + "_p" + number + ".npy", problem.points());
    step.overlap = read_npy(result.name + "_plastic" + number + ".npy", problem.points());
    result.steps.push_back(step);
  }
  problem.target = result.steps.front().target;
  return result;
}

}  // namespace

std::vector<CappedCase> read_capped_cases() {
  std::ifstream in(folder + "index.json");
  check(static_cast<bool>(in), folder + "index.json cannot be read");
  const json index = json::parse(in);
  std::vector<CappedCase> cases;
  for (const json& entry : index["cases"]) cases.push_back(read_case(entry));
  return cases;
}

std::vector<std::string> capped_solvers(const std::string& backend, const rc_system& system) {
  std::vector<std::string> solvers;
  for (const std::string& solver : solver_names()) {
    bool can = true;
    for (const std::int32_t control : controls) can = can && obstacle({solver, backend}, system, control).empty();
    if (can) solvers.push_back(solver);
  }
  return solvers;
}

}  // namespace pairs
