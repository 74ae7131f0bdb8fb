#include "core/company.h"

namespace rc {

double Company::largest(double mine) const {
  if (!rows_) return mine;
  const std::vector<double> all = rows_->of_each(mine);
  return *std::max_element(all.begin(), all.end());
}

rc_status Company::agreed(rc_status mine) const {
  if (rows_) {
    // One process's clock stops all of them, at the same iteration. The number of iterations is the same everywhere.
    ++rows_->counts().iterations;
    if (mine != RC_STOP_MAX_ITER) rows_->ask_stop(mine);
    return rows_->stop() != RC_OK ? rows_->stop() : mine == RC_STOP_MAX_ITER ? mine : RC_OK;
  }
  if (!alike_) return mine;
  ++alike_->counts().iterations;
  const std::vector<rc_status> all = alike_->of_each(mine);
  return *std::max_element(all.begin(), all.end());
}

}  // namespace rc
