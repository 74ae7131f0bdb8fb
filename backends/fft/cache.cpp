#include "cache.h"

#include <algorithm>

namespace rc_fft {

namespace {

constexpr std::size_t most_forgotten = std::size_t{1} << 24;  // bytes

}  // namespace

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

void Cache::forget(std::unique_ptr<Transforms>& box, std::unique_ptr<Transforms>& grid) {
  for (auto& each : idle_) put_away(std::move(each));
  idle_.clear();
  put_away(std::move(grid));
  put_away(std::move(box));
}

void Cache::trim_forgotten() {
  std::size_t total = 0;
  for (const auto& each : forgotten_) total += each->bytes();
  while (total > most_forgotten) {
    total -= forgotten_.front()->bytes();
    forgotten_.erase(forgotten_.begin());
  }
}

void Cache::put_away(std::unique_ptr<Transforms> present) {
  if (!present) return;
  const auto same =
      std::find_if(forgotten_.begin(), forgotten_.end(), [&](const auto& f) { return f->lengths == present->lengths; });
  if (same != forgotten_.end()) {  // it may hold the other precision
    if (!present->in_double) present->in_double = std::move((*same)->in_double);
    if (!present->in_float) present->in_float = std::move((*same)->in_float);
    forgotten_.erase(same);
  }
  if (present->bytes() > 0) forgotten_.push_back(std::move(present));
}

}  // namespace rc_fft
