// The plastic indentation that certified steps leave, followed without the library: the overlap where the pressure is the
// hardness.
#pragma once

#include <algorithm>
#include <vector>

#include "oracle.h"
#include "require.h"

namespace fuzz {

class Indentation {
 public:
  explicit Indentation(const Scene& scene) : hardness_(scene.system.hardness), depth_(scene.points(), 0.0) {}

  /** The problem as the contact sees it: its gap is the given one and the indentation. The array lives until the next call. */
  Problem seen(const Problem& problem) {
    if (!problem.gap) return problem;
    gap_.resize(depth_.size());
    for (std::size_t i = 0; i < gap_.size(); ++i) gap_[i] = problem.gap[i] + depth_[i];
    return {gap_.data(), problem.mask, problem.control, problem.target};
  }
  void commit(const Answer& answer) {
    for (std::size_t i = 0; hardness_ > 0 && answer.status == RC_OK && i < depth_.size(); ++i)
      if (answer.p[i] >= hardness_) depth_[i] += std::max(0.0, -answer.gap[i]);
  }
  void forget() { std::ranges::fill(depth_, 0.0); }

  const double* depth() const { return depth_.data(); }
  void require_of(rc_contact* contact) const {
    Reals found(depth_.size(), -1.0);
    require(rc_contact_indentation(contact, RC_OUT(found.data())) == RC_OK, "a contact tells its indentation");
    require(found == depth_, "the indentation is the overlap of the certified steps");
  }

 private:
  double hardness_;
  Reals depth_, gap_;
};

}  // namespace fuzz
