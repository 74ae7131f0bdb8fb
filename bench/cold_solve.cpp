#include "cold_solve.h"

#include <cmath>
#include <numbers>

#include "stopwatch.h"

namespace bench {

ColdSolve::ColdSolve(const ColdScene& scene) : scene_(scene), gap_(self_affine_gap(scene.n, {})), pressure_(gap_.size()) {
  step_.gap = gap_.data();
  step_.control = RC_CONTROL_LOAD;
  // Bush, Gibson & Thomas (1975), as in light contact.
  step_.target = scene.area / std::sqrt(2 * std::numbers::pi) * SelfAffine{}.rms_slope;
}

double ColdSolve::seconds(std::int64_t threads, const std::vector<std::pair<std::string, std::string>>& more) {
  Options options;
  options.set(RC_OPT_SOLVER, scene_.solver).set(RC_OPT_BACKEND, scene_.backend).set(RC_OPT_TOL, scene_.tol);
  options.set(RC_OPT_THREADS, static_cast<double>(threads));
  for (const auto& [key, value] : more) options.set(key.c_str(), value);
  const auto start = Clock::now();
  result_ = Contact(unit_square(scene_.n), options).solve(step_, pressure_.data());
  const double seconds = seconds_since(start);
  if (result_.status != RC_OK) throw Failure(std::string("not certified: ") + result_.note);
  return seconds;
}

void ColdSolve::prescribe_approach() {
  step_.control = RC_CONTROL_DISPLACEMENT;
  step_.target = result_.displacement;
}

}  // namespace bench
