// Objects that contacts of one context share, each under a key: made by the first who asks, kept as long as anybody holds it.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>

namespace rc {

// Thread-safe. Threads that ask for one key wait for each other while its object is made; those of other keys do not.
class SharedObjects {
 public:
  // make: returns a std::shared_ptr<T>. One key stands for one type.
  template <class T, class Make> std::shared_ptr<T> get(const std::string& key, const Make& make) {
    using Object = std::remove_const_t<T>;
    return std::static_pointer_cast<T>(
        find(key, [&]() -> std::shared_ptr<void> { return std::const_pointer_cast<Object>(make()); }));
  }

 private:
  struct Slot {
    std::mutex making;
    std::weak_ptr<void> object;
  };

  std::shared_ptr<void> find(const std::string& key, const std::function<std::shared_ptr<void>()>& make);
  std::shared_ptr<Slot> slot(const std::string& key);

  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Slot>> slots_;
  std::size_t sweep_at_ = 64;  // so many slots are looked through for those that nobody uses
};

}  // namespace rc
