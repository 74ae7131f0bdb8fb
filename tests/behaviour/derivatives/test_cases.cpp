// Gradients against the stored adjoints of an independent program.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "calls.h"
#include "support/reference_cases.h"

namespace pairs {

namespace {

using nlohmann::json;

const std::string folder = RC_TEST_DATA "/cases/capped/";

struct Case {
  Problem problem;
  Cotangents cotangents;
  Field p, by_gap[2];  // at the approach, and at the load
  double by_target[2], load = 0, stiffness = 0;
};

Case read_case(const json& entry) {
  const std::string name = entry["name"];
  Case result;
  Problem& problem = result.problem;
  problem.system.nx = entry["nx"];
  problem.system.ny = entry["ny"];
  problem.system.hx = entry["hx"];
  problem.system.hy = entry["hy"];
  problem.system.modulus = entry["modulus"];
  problem.kernel = entry["kernel"];
  problem.target = entry["steps"][0]["approach"];
  const auto read = [&](const char* what) { return read_npy(folder + name + "_" + what + ".npy", problem.points()); };
  problem.gap = read("gap");
  result.cotangents.p = read("Jp");
  result.cotangents.gap = read("Jg");
  result.p = read("elastic_p");
  result.by_gap[0] = read("dJ_dgap_at_displacement");
  result.by_gap[1] = read("dJ_dgap_at_load");
  result.by_target[0] = entry["dJ_dtarget_at_displacement"];
  result.by_target[1] = entry["dJ_dtarget_at_load"];
  result.load = entry["elastic"]["load"];
  result.stiffness = entry["elastic"]["stiffness"];
  return result;
}

void gradients_are_those_of(const Case& reference, const Pair& pair) {
  constexpr double tolerance = 1e-8;
  for (const bool by_load : {false, true}) {
    const Problem problem = by_load ? at_load(reference.problem, reference.load) : reference.problem;
    const Contact contact(problem, pair, {{RC_OPT_STIFFNESS, "2"}});
    const Answer answer = contact.solve(problem);
    check_status(answer, RC_OK);
    check_near(answer.p, reference.p, tolerance, "pressures");
    check_near(answer.result.stiffness, reference.stiffness, tolerance * reference.stiffness, "stiffness");
    check(answer.result.stiffness_lower <= reference.stiffness * (1 + 1e-14) &&
              reference.stiffness * (1 - 1e-14) <= answer.result.stiffness_upper,
          "the stiffness is outside its interval");
    const Gradient found = gradient(contact, problem.points(), reference.cotangents);
    check_equal(found.status, RC_OK, found.message);
    check_near(found.by_gap, reference.by_gap[by_load], tolerance, by_load ? "dJ/dh at the load" : "dJ/dh at the approach");
    const double expected = reference.by_target[by_load];
    check_near(found.result.dJ_dtarget, expected, tolerance * std::abs(expected), "dJ/dtarget");
    check(found.result.error <= tolerance * norm(found.by_gap), "error bound " + text(found.result.error));
  }
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  std::ifstream in(folder + "index.json");
  std::vector<Test> tests;
  const nlohmann::json index = nlohmann::json::parse(in);
  for (const auto& entry : index["cases"]) {
    if (!entry.contains("elastic")) continue;
    for (const Pair& pair : {Pair{"haar-cg", "fft"}, Pair{"nnls", "dense"}, automatic})
      tests.push_back(
          {entry["name"].get<std::string>() + "/" + pair.name(), [=] { gradients_are_those_of(read_case(entry), pair); }});
  }
  return run_group("derivatives.cases", tests, argc, argv);
}
