// Where the greedy method fails it says so: 20 draws of the paper's first example whose dropped points overlap with kernel eq9.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "support/contact.h"
#include "support/registry.h"

namespace pairs {

namespace {

constexpr std::int64_t side = 10;

struct Draw {
  std::string seed;
  Problem problem;
};

// seed, then the penetrations row by row; E* = 0.01, cells of side 1.
std::vector<Draw> read_draws() {
  std::ifstream in(RC_TEST_DATA "/cases/ex1_eq9_N10_failing_ubar.csv");
  std::vector<Draw> draws;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream cells(line);
    Draw draw;
    std::getline(cells, draw.seed, ',');
    for (std::string cell; std::getline(cells, cell, ',');) draw.problem.gap.push_back(-std::stod(cell));
    draw.problem.kernel = "eq9";
    draw.problem.system.nx = draw.problem.system.ny = side;
    draw.problem.system.modulus = 0.01;
    check_equal(static_cast<std::int64_t>(draw.problem.gap.size()), side * side, "values of draw " + draw.seed);
    draws.push_back(draw);
  }
  return draws;
}

void failure_is_told(const Problem& problem, const std::string& inner, const std::string& backend) {
  const Answer answer = solve(problem, {"greedy", backend}, {{"greedy.inner", inner}, {"greedy.repair", "0"}});
  check_status(answer, RC_UNCERTIFIED);
  const rc_result& r = answer.result;
  long long points = 0;
  double worst = 0;
  check(std::sscanf(r.note, "greedy: %lld points overlap, worst w = %lf", &points, &worst) == 2, std::string("note: ") + r.note);
  const double depth = -*std::min_element(problem.gap.begin(), problem.gap.end());
  std::int64_t overlapping = 0;
  double deepest = 0;
  for (const double gap : answer.gap) {
    overlapping += gap < -1e-12 * depth;
    deepest = std::max(deepest, -gap / depth);
  }
  check_equal(points, overlapping, "points that overlap");
  check_near(-worst, deepest, 0.06 * deepest, "the worst overlap, two digits");
  check(r.kkt_dual > 1e-6, "kkt_dual does not show it: " + text(r.kkt_dual));
}

void others_solve_it(const Problem& problem, const Answer& reference) {
  for (const Pair& pair : all_pairs()) {
    if (pair.solver == "greedy" || !obstacle(pair, problem.system, RC_CONTROL_APPROACH).empty()) continue;
    check_near(solved(problem, pair).p, reference.p, 1e-9, pair.name());
  }
}

void repair_solves_it(const Problem& problem, const Answer& reference) {
  for (const char* backend : {"dense", "fft"}) {
    if (!obstacle({"greedy", backend}, problem.system, RC_CONTROL_APPROACH).empty()) continue;
    const Answer answer = solved(problem, {"greedy", backend}, {{"greedy.repair", "1"}});
    check_near(answer.p, reference.p, 1e-9, "p");
    check(std::string(answer.result.note).find("nnls has repaired it") != std::string::npos,
          std::string("no remark on the repair: ") + answer.result.note);
  }
}

void repair_solves_load_control(const Problem& problem, const Answer& reference) {
  const Answer answer = solved(at_load(problem, reference.result.load), {"greedy", "dense"}, {{"greedy.repair", "1"}});
  check_near(answer.p, reference.p, 1e-9, "p");
}

void refusals() {
  Problem problem;
  problem.system.nx = 70;
  problem.system.ny = 60;
  problem.gap.assign(problem.points(), 0.0);
  problem.target = 1;
  const auto refused = [&](const Settings& settings, const std::string& word) {
    const Answer answer = solve(problem, {"greedy", "fft"}, settings);
    check_status(answer, RC_ERR_INCOMPATIBLE);
    check(answer.message.find(word) != std::string::npos, "the message does not name " + word + ": " + answer.message);
  };
  if (!obstacle({"greedy", "fft"}, problem.system, RC_CONTROL_APPROACH).empty()) throw Skipped("there is no backend fft");
  refused({{"greedy.inner", "gauss-seidel"}}, "4200 of at most 4096");
  refused({{"greedy.inner", "cholesky"}, {RC_OPT_ALLOW_FALLBACK, "0"}}, "greedy.inner = cg");
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  std::vector<Test> tests = {{"unfit_inner_methods_are_refused", refusals}};
  const std::vector<Draw> draws = read_draws();
  tests.push_back({"there_are_20_draws", [&] { check_equal(static_cast<std::int64_t>(draws.size()), 20, "draws"); }});
  for (const Draw& draw : draws) {
    for (const char* inner : {"cg", "gauss-seidel", "cholesky"})
      tests.push_back(
          {"failure_is_told/" + draw.seed + "/" + inner, [&, inner] { failure_is_told(draw.problem, inner, "dense"); }});
    tests.push_back({"others_solve_it/" + draw.seed, [&] {
                       others_solve_it(draw.problem, solved(draw.problem, {"nnls", "dense"}));
                     }});
    tests.push_back({"repair_solves_it/" + draw.seed, [&] {
                       repair_solves_it(draw.problem, solved(draw.problem, {"nnls", "dense"}));
                     }});
    tests.push_back({"repair_solves_load_control/" + draw.seed, [&] {
                       repair_solves_load_control(draw.problem, solved(draw.problem, {"nnls", "dense"}));
                     }});
  }
  return run_group("solvers.greedy", tests, argc, argv);
}
