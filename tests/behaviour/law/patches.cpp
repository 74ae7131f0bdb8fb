#include "patches.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "support/surfaces.h"

namespace laws {

namespace {

using pairs::Field;

// A rough patch of n by n cells, with slopes of about a tenth; its pressures span a factor of 500.
Patch patch(std::string name, std::int32_t boundary, std::int64_t n) {
  Patch made;
  made.name = std::move(name);
  made.problem = pairs::rough_problem(n, n, boundary);
  const double scale = 0.25 * static_cast<double>(n) / 16;
  for (double& gap : made.problem.gap) gap *= scale;
  made.spec.p_lower = 2e-5;
  made.spec.p_upper = 1e-2;
  return made;
}

}  // namespace

rc_law_spec Patch::asked() const {
  rc_law_spec whole = spec;
  whole.undeformed_gap = RC_IN(problem.gap.data());
  whole.mask = RC_IN(problem.mask.empty() ? nullptr : problem.mask.data());
  return whole;
}

Patch usual_patch(std::int64_t n) { return patch("usual", RC_BOUNDARY_PERIODIC, n); }

Patch patch_named(const std::string& name) {
  Patch made = patch(name, name == "hardness" ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE, 16);
  if (name != "disc") {
    made.problem.system.hardness = 0.03;
    return made;
  }
  for (int i = 0; i < 256; ++i) made.problem.mask.push_back(std::hypot(i % 16 - 8, i / 16 - 8) < 7.2);
  const double lowest = made.problem.lowest_gap();  // the gap counts from there, as a law's does
  for (double& gap : made.problem.gap) gap -= lowest;
  return made;
}

MadeLaw make(const Patch& patch) {
  const rc_law_spec spec = patch.asked();
  const auto options = pairs::make_options(pairs::automatic, patch.problem.kernel);
  MadeLaw result;
  rc_law* law = nullptr;
  result.status = rc_law_create(&patch.problem.system, options.get(), &spec, &law);
  result.message = rc_last_error();
  result.law.reset(law);
  return result;
}

LawHandle made(const Patch& patch) {
  MadeLaw result = make(patch);
  pairs::check(result.status >= 0, patch.name + ": " + result.message);
  return std::move(result.law);
}

rc_law_info describe(const rc_law* law) {
  rc_law_info info = RC_LAW_INFO_INIT;
  pairs::check_equal(rc_law_describe(law, &info), RC_OK, "rc_law_describe");
  return info;
}

rc_law_point evaluate(const rc_law* law, double x) {
  rc_law_point point = RC_LAW_POINT_INIT;
  pairs::check(rc_law_evaluate(law, x, &point) >= 0, "rc_law_evaluate");
  return point;
}

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

const rc_law* usual_law() {
  static const LawHandle law = made(usual_patch(32));
  return law.get();
}

void refuses(rc_status status, const std::string& part, const std::string& what) {
  pairs::check_equal(status, RC_ERR_ARGUMENT, what);
  pairs::check(std::string(rc_last_error()).find(part) != std::string::npos, what + ": " + rc_last_error());
}

std::vector<double> overclosures(const rc_law* law) {
  const rc_law_info info = describe(law);
  std::vector<double> all{-1, 0, info.x_lower / 3, info.x_upper, 2 * info.x_upper};
  for (int i = 0; i <= 1000; ++i) all.push_back(info.x_lower * std::pow(info.x_upper / info.x_lower, i / 1000.0));
  return all;
}

}  // namespace laws
