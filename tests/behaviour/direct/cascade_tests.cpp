// rc_cmr on the height maps of the reference cases.
#include "direct_tests.h"
#include "support/reference_cases.h"

namespace direct {

namespace {

using namespace pairs;

constexpr double accurate = 1e-6;  // the routine's tolerance is 1e-8

struct Call {
  std::int64_t levels;
  double h;
  const char* inner;
};

void solves_height_maps(const Language& language, const Call& call) {
  const auto reference = read_reference_cases();
  int solved = 0;
  for (const ReferenceCase& each : reference.cases) {
    const Problem& problem = each.problem;
    const rc_system& s = problem.system;
    if (problem.kernel != "love" || problem.target <= 0 || each.spacing != 1 || (quick() && s.nx * s.ny > 2500)) continue;
    Field heights = problem.gap, p(problem.points(), -7.0);
    for (double& value : heights) value = 3 - value;  // the datum does not matter
    rc_direct result = RC_DIRECT_INIT;
    const rc_status status = language.cascade(s.nx, s.ny, s.hx, s.hy, s.modulus, heights.data(), problem.target, call.levels,
                                              call.h, call.inner, p.data(), &result);
    check(status == RC_OK, each.name + ": " + rc_last_error());
    check_near(p, each.p, accurate, each.name + ": p");
    check_near(result.load, each.load, accurate * each.load, each.name + ": load");
    check(result.kkt <= 1e-8 && result.contacts > 0 && result.energy < 0, each.name + ": certificate");
    ++solved;
  }
  report(std::to_string(solved) + " height maps");
  check(solved >= 3, "too few height maps");
}

}  // namespace

std::vector<Test> cascade_tests() {
  std::vector<Test> tests;
  for (const Language& language : languages())
    for (const Call& call : {Call{1, 2, "auto"}, Call{3, 2, "auto"}, Call{2, 1, "nnls"}, Call{3, 1.5, "polonsky-keer"}})
      tests.push_back({"cmr/" + language.name + "/" + std::to_string(call.levels) + "_levels_around_" + call.inner,
                       [=] { solves_height_maps(language, call); }});
  return tests;
}

}  // namespace direct
