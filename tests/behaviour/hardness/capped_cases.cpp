#include "capped_cases.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/reference_cases.h"
#include "support/registry.h"

namespace pairs {

namespace {

using nlohmann::json;

const std::string folder = RC_TEST_DATA "/cases/capped/";

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
  problem.gap = read_npy(folder + result.name + "_gap.npy", problem.points());
  for (const json& given : entry["steps"]) {
    const std::string number = std::to_string(result.steps.size() + 1);
    CappedStep step{
        given["target"], given["approach"], given["load"], given["plastic_volume"], given["contacts"], given["capped"], {}, {}};
    step.p = read_npy(folder + result.name + "_p" + number + ".npy", problem.points());
    step.overlap = read_npy(folder + result.name + "_plastic" + number + ".npy", problem.points());
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
