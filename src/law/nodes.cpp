#include "law/nodes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "law/law.h"

namespace rc {

void LawNodes::add(std::vector<LawSample> fresh) {
  for (LawSample& sample : fresh) {
    const auto at =
        std::find_if(samples_.begin(), samples_.end(), [&](const LawSample& other) { return !(other.node.x < sample.node.x); });
    const bool last = at == samples_.end();
    if (!(sample.node.p > 0) || (!last && !(at->node.x > sample.node.x))) continue;
    if (sample.node.p < std::prev(at)->node.p || (!last && sample.node.p > at->node.p)) continue;  // round-off
    samples_.insert(at, std::move(sample));
  }
  for (std::size_t i = 0; i + 1 < samples_.size(); ++i)
    if (samples_[i].bounded_to != samples_[i + 1].approach) bound(samples_[i], samples_[i + 1]);
}

LawSample LawNodes::skipping(std::size_t i) const {
  LawSample before = samples_[i - 1];
  bound(before, samples_[i + 1]);
  return before;
}

void LawNodes::leave_out(std::size_t i, LawSample before) {
  samples_[i - 1] = std::move(before);
  samples_.erase(samples_.begin() + static_cast<std::ptrdiff_t>(i));
}

void LawNodes::bound(LawSample& sample, const LawSample& next) const {
  sample.bounded_to = next.approach;
  rc_law_point& node = sample.node;
  node.bounds = RC_LAW_MONOTONE;
  node.between_lower = 0;
  node.between_upper = HUGE_VAL;
  if (!sample.proven || !next.proven || !sample.contacts.within(next.contacts) || !sample.capped.within(next.capped)) return;
  if (!next.capped.empty()) {
    // Points below the hardness: at least those that touch already and do not reach it, at most those that touch by the next
    // node.
    const auto slopes = patch_.slopes(sample.contacts.without(next.capped), next.contacts.without(sample.capped));
    if (!slopes) return;
    double lower = slopes->lower;
    if (!next.capped.within(sample.contacts)) {  // what points change that touch and reach the hardness is bounded by all slopes
      lower = std::min(lower, std::min(node.slope_upper, next.node.slope_upper) - (slopes->upper - lower));
      if (lower < 0 && patch_.bulk_yield() > 0) return;
    }
    node.bounds = RC_LAW_SLOPES;
    node.between_lower = lower;
    node.between_upper = slopes->upper;
    admit_chord(node, next.node);
    return;
  }
  // The intervals of load and stiffness must not contradict chords between the slopes.
  const double h = next.node.x - node.x, slack = 1e-6;
  const double chord_lower = (next.node.p_lower - node.p_upper) / h, chord_upper = (next.node.p_upper - node.p_lower) / h;
  if (next.node.slope_upper < node.slope_lower * (1 - 1e-9) || chord_upper < node.slope_lower * (1 - slack) ||
      chord_lower > next.node.slope_upper * (1 + slack))
    return;
  node.bounds = RC_LAW_CONVEX;
  node.between_lower = node.slope_lower;
  node.between_upper = std::max(node.slope_lower, next.node.slope_upper);
  admit_chord(node, next.node);
}

}  // namespace rc
