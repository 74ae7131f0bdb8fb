#include "registry/shared_objects.h"

namespace rc {

std::shared_ptr<void> SharedObjects::find(const std::string& key, const std::function<std::shared_ptr<void>()>& make) {
  const std::shared_ptr<Slot> place = slot(key);
  const std::lock_guard lock(place->making);
  if (std::shared_ptr<void> object = place->object.lock()) return object;
  std::shared_ptr<void> object = make();
  place->object = object;
  return object;
}

std::shared_ptr<SharedObjects::Slot> SharedObjects::slot(const std::string& key) {
  const std::lock_guard lock(mutex_);
  if (const auto it = slots_.find(key); it != slots_.end()) return it->second;
  if (slots_.size() >= sweep_at_) {
    std::erase_if(slots_, [](const auto& entry) {
      if (entry.second.use_count() > 1) return false;  // somebody is about to use it: only this function hands slots out
      const std::lock_guard still(entry.second->making);
      return entry.second->object.expired();
    });
    sweep_at_ = 2 * slots_.size() + 64;
  }
  return slots_.emplace(key, std::make_shared<Slot>()).first->second;
}

}  // namespace rc
