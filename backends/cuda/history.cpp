// Pressures of the last two steps stay on the device as long as nothing else needs the memory.
#include "history.h"

#include <memory>
#include <utility>

#include "failure.h"
#include "kernels/passes.h"

namespace rc_cuda {

struct History::Kept {
  Index index;  // of the device
  rc_common::Box box;
  Memory memory;  // of pressures [box.points()]; empty: they went

  StoredPressures stored() const { return {memory.as<const double>(), box.x, box.y, box.nx, box.ny}; }
};

History::History(const rc_problem& problem, Index index) : given_(problem.kept), index_(index) {
  const auto on_device = [&](void* object) {
    auto* const kept = static_cast<Kept*>(object);
    return kept && kept->index == index && kept->memory.bytes() > 0 ? kept : nullptr;
  };
  if (!given_) return;
  last_ = on_device(given_->last);
  before_ = on_device(given_->before);
}

std::size_t History::bytes() const { return (last_ ? last_->memory.bytes() : 0) + (before_ ? before_->memory.bytes() : 0); }

void History::give_way() {
  for (Kept** const each : {&last_, &before_}) {
    if (*each) (*each)->memory = Memory();
    *each = nullptr;
  }
}

bool History::write(Device& device, const Start& start) const {
  if (!last_ || (given_->ahead != 0 && !before_)) return false;
  const rc_common::Box& box = start.box;
  const StoredPressures none{};
  device.each(box.points(), Restart{last_->stored(), before_ ? before_->stored() : none, given_->ahead, start.unit, start.cap,
                                    start.p, box.x, box.y, box.nx});
  return true;
}

// Pressures of two steps ago are not needed again: their memory is reused.
void History::keep(Device& device, const Start& answer, std::size_t held, double limit) {
  if (!given_) return;
  auto kept = std::make_unique<Kept>(Kept{index_, answer.box, {}});
  const std::size_t bytes = static_cast<std::size_t>(answer.box.points()) * sizeof(double);
  if (before_) kept->memory = std::move(before_->memory);
  if (kept->memory.bytes() < bytes) {
    kept->memory = Memory();
    const std::size_t all = held + (last_ ? last_->memory.bytes() : 0) + bytes;
    if (static_cast<double>(all) > limit || bytes > device.free_bytes()) return;
    kept->memory = Memory(device, bytes);
  }
  device.each(answer.box.points(), Store{answer.p, answer.unit, answer.cap, given_->hardness, kept->memory.as<double>()});
  given_->keep(given_, kept.release(), [](void* object) { delete static_cast<Kept*>(object); });
}

}  // namespace rc_cuda
