#include "support/registry.h"

#include <cstdlib>

#include "support/unit_system.h"

namespace pairs {

namespace {

std::vector<std::string> names(std::int32_t kind) {
  std::vector<std::string> result;
  for (std::int64_t i = 0; i < rc_component_count(nullptr, kind); ++i) {
    rc_component component{};
    component.struct_size = sizeof component;
    check(rc_component_describe(nullptr, kind, i, &component) == RC_OK, rc_last_error());
    result.emplace_back(component.name);
  }
  return result;
}

}  // namespace

std::vector<std::string> solver_names() { return names(RC_COMPONENT_SOLVER); }
std::vector<std::string> backend_names() { return names(RC_COMPONENT_BACKEND); }
std::vector<std::string> kernel_names() {
  std::vector<std::string> result = names(RC_COMPONENT_KERNEL);
  std::erase(result, "layer");
  return result;
}

std::vector<Pair> all_pairs() {
  const char* const only = std::getenv("RC_TEST_SOLVER");
  std::vector<Pair> result;
  for (const std::string& solver : solver_names())
    for (const std::string& backend : backend_names())
      if (!only || solver == only) result.push_back({solver, backend});
  return result;
}

std::string obstacle(const Pair& pair, const rc_system& system, std::int32_t control) {
  const rc_status status = rc_pair_supported(nullptr, pair.solver.c_str(), pair.backend.c_str(), &system, control, nullptr);
  if (status == RC_OK) return "";
  return std::string(rc_status_name(status)) + ": " + rc_last_error();
}

std::string kind_of(const rc_system& system) {
  if (system.op == RC_OPERATOR_DENSE) return "matrix";
  if (system.op == RC_OPERATOR_CALLBACK) return "product";
  static const char* const names[] = {"free", "periodic", "periodic-x", "periodic-y"};
  return names[system.boundary - RC_BOUNDARY_FREE];
}

std::string group_name(const Pair& pair, const rc_system& system, std::int32_t control) {
  return pair.name() + "/" + kind_of(system) + "/" + (control == RC_CONTROL_LOAD ? "load" : "approach");
}

bool multiplies_often(const Pair& pair) { return pair.solver == "gp" || pair.solver == "admm" || pair.solver == "greedy"; }

bool gains_from_a_start(const Pair& pair) { return pair.solver != "greedy"; }

bool may_fail(const Pair& pair, const Problem& problem) {
  if (pair.solver != "greedy") return false;
  const bool inverse_m = problem.kernel == "love" || problem.kernel == "disc" || problem.kernel == "auto";
  return problem.system.op != RC_OPERATOR_HALFSPACE || problem.periodic() || !inverse_m;
}

bool is_told_failure(const Pair& pair, const Problem& problem, const Answer& answer) {
  return may_fail(pair, problem) && answer.status == RC_UNCERTIFIED &&
         std::string(answer.result.note).find("overlap") != std::string::npos;
}

void add_for_pairs(std::vector<Test>& tests, const std::string& name, std::int32_t boundary,
                   const std::function<void(const Pair&)>& body) {
  rc_system system = support::unit_system();
  system.boundary = boundary;
  for (const Pair& pair : all_pairs()) {
    bool supported = true;
    for (const std::int32_t control : controls) supported = supported && obstacle(pair, system, control).empty();
    if (supported) tests.push_back({pair.name() + "/" + kind_of(system) + "/" + name, [=] { body(pair); }});
  }
}

}  // namespace pairs
