#include "core/company.h"

#include <algorithm>
#include <vector>

namespace rc {

rc_status Company::agreed(rc_status mine) const {
  if (const Ranks* const ranks = rows_.ranks()) {
    // One rank's clock stops all of them, at the same iteration. The number of iterations is the same everywhere.
    ++ranks->counts().iterations;
    if (mine != RC_STOP_MAX_ITER) ranks->ask_stop(mine);
    return ranks->stop() != RC_OK ? ranks->stop() : mine == RC_STOP_MAX_ITER ? mine : RC_OK;
  }
  const Ranks* const ranks = replicated_.ranks();
  if (!ranks) return mine;
  ++ranks->counts().iterations;
  const std::vector<rc_status> all = ranks->of_each(mine);
  return *std::max_element(all.begin(), all.end());
}

}  // namespace rc
