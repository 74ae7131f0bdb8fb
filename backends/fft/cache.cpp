#include "cache.h"

#include <algorithm>

namespace rc_fft {

void Cache::fit(std::unique_ptr<Transforms>& present, Lengths needed, Lengths largest) {
  if (present && suits(present->lengths, needed)) return;
  auto best = idle_.end();
  for (auto it = idle_.begin(); it != idle_.end(); ++it)
    if (suits((*it)->lengths, needed) && (best == idle_.end() || points((*it)->lengths) < points((*best)->lengths))) best = it;
  std::unique_ptr<Transforms> next;
  if (best != idle_.end()) {
    next = std::move(*best);
    idle_.erase(best);
  } else {
    next = std::make_unique<Transforms>(choose_lengths(needed, largest, present ? present->lengths : Lengths{}));
  }
  retire(present);
  present = std::move(next);
}

void Cache::retire(std::unique_ptr<Transforms>& present) {
  if (present && present->bytes() > 0 && present->bytes() <= limit_) {
    idle_.push_back(std::move(present));
    std::size_t total = 0;
    for (const auto& each : idle_) total += each->bytes();
    while (total > limit_) {
      total -= idle_.front()->bytes();
      idle_.erase(idle_.begin());
    }
  }
  present.reset();
}

}  // namespace rc_fft
