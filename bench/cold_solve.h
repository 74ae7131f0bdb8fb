// One scene solved cold again and again, for the benchmarks of what surrounds a solve.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "library.h"
#include "scene.h"

namespace bench {

struct ColdScene {
  std::int64_t n = 1024;  // points a side
  double area = 0.1;      // share of the grid in contact, about
  double tol = 1e-8;
  std::string solver = "auto", backend = "auto";
};

class ColdSolve {
 public:
  explicit ColdSolve(const ColdScene& scene);

  // Seconds of a whole call, its set-up included, with these options besides the scene's. Throws unless certified.
  double seconds(std::int64_t threads, const std::vector<std::pair<std::string, std::string>>& more = {});
  // From now on the approach that the last solve found is prescribed instead of the load.
  void prescribe_approach();
  const rc_step& step() const { return step_; }
  const rc_result& result() const { return result_; }
  const Field& pressure() const { return pressure_; }
  double area() const { return static_cast<double>(result_.contacts) / static_cast<double>(result_.points); }

 private:
  const ColdScene scene_;
  const Field gap_;
  Field pressure_;
  rc_step step_ = RC_STEP_INIT;
  rc_result result_{};
};

inline double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace bench
