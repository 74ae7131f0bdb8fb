// For stand-ins of rc_host: each share() and keep() makes an object of its own.
#pragma once

#include <roughcontact/plugin.h>

#include <map>
#include <mutex>
#include <new>

namespace support {

class Unshared {
 public:
  Unshared() = default;
  ~Unshared() {
    for (const auto& [object, destroy] : objects_) destroy(object);
  }
  Unshared(const Unshared&) = delete;
  Unshared& operator=(const Unshared&) = delete;

  rc_status add(rc_status (*make)(void*, void**), void (*destroy)(void*), void* argument, void** object) {
    const rc_status status = make(argument, object);
    if (status != RC_OK) return status;
    try {
      const std::lock_guard lock(mutex_);
      objects_.emplace(*object, destroy);
      return RC_OK;
    } catch (const std::bad_alloc&) {
      destroy(*object);
      return RC_ERR_MEMORY;
    }
  }
  void remove(void* object) {
    const std::lock_guard lock(mutex_);
    const auto it = objects_.find(object);
    it->second(object);
    objects_.erase(it);
  }

 private:
  std::mutex mutex_;
  std::map<void*, void (*)(void*)> objects_;
};

}  // namespace support
