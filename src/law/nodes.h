// The nodes of a law while it is made: in order, with what is proven between neighbours.
#pragma once

#include <vector>

#include "law/patch.h"

namespace rc {

class LawNodes {
 public:
  explicit LawNodes(const LawPatch& patch) : patch_(patch), samples_{patch.origin()} {}

  // Places them by approach and finds what holds in the intervals that are new. Two at the same overclosure count as one,
  // and one whose pressure is not between those of its neighbours is left out.
  void add(std::vector<LawSample> fresh);

  // A copy of node i - 1 with the bounds that hold up to node i + 1, as if node i were not there.
  LawSample skipping(std::size_t i) const;
  // Leaves out node i; `before` is the one that skips it.
  void leave_out(std::size_t i, LawSample before);

  std::size_t size() const { return samples_.size(); }
  const LawSample& operator[](std::size_t i) const { return samples_[i]; }

 private:
  void bound(LawSample& sample, const LawSample& next) const;

  const LawPatch& patch_;
  std::vector<LawSample> samples_;
};

}  // namespace rc
