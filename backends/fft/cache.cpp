#include "cache.h"

#include <algorithm>

namespace rc_fft {

void Cache::fit(std::unique_ptr<Transforms>& present, Lengths needed, Lengths largest) {
  if (present && suits(present->lengths, needed, period_)) return;
  auto best = idle_.end();
  for (auto it = idle_.begin(); it != idle_.end(); ++it)
    if (suits((*it)->lengths, needed, period_) && (best == idle_.end() || points((*it)->lengths) < points((*best)->lengths)))
      best = it;
  std::unique_ptr<Transforms> next;
  if (best != idle_.end()) {
    next = std::move(*best);
    idle_.erase(best);
  } else {
    next = std::make_unique<Transforms>(choose_lengths(needed, largest, present ? present->lengths : Lengths{}, period_));
  }
  retire(present);
  present = std::move(next);
}

void Cache::retire(std::unique_ptr<Transforms>& present) {
  if (present && present->bytes() > 0 && present->bytes() <= limit_) {
    idle_.push_back(std::move(present));
    trim(idle_, limit_);
  }
  present.reset();
}

void Cache::forget(std::unique_ptr<Transforms>& box, std::unique_ptr<Transforms>& grid) {
  for (auto& each : idle_) put_away(std::move(each));
  idle_.clear();
  put_away(std::move(grid));
  put_away(std::move(box));
}

// Drops those that have not been used for the longest time.
void Cache::trim(List& list, std::size_t limit) {
  std::size_t total = 0;
  for (const auto& each : list) total += each->bytes();
  while (total > limit) {
    total -= list.front()->bytes();
    list.erase(list.begin());
  }
}

void Cache::put_away(std::unique_ptr<Transforms> present) {
  if (!present) return;
  const auto same =
      std::find_if(forgotten_.begin(), forgotten_.end(), [&](const auto& f) { return f->lengths == present->lengths; });
  if (same != forgotten_.end()) {  // it may hold the other precision
    if (!present->in<double>()) present->in<double>() = std::move((*same)->in<double>());
    if (!present->in<float>()) present->in<float>() = std::move((*same)->in<float>());
    forgotten_.erase(same);
  }
  if (present->bytes() > 0) forgotten_.push_back(std::move(present));
}

}  // namespace rc_fft
