// Things that an operator needs only while a step is solved: contacts with the same system lend them to each other, so that there
// are as many as threads at work.
#pragma once

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace rc_common {

template <class T> class Pool {
 public:
  // The latest that suits, else the latest, else a new one.
  template <class Suits> T take(const Suits& suits) {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return T();
    auto found = std::find_if(idle_.rbegin(), idle_.rend(), suits);
    if (found == idle_.rend()) found = idle_.rbegin();
    T result = std::move(*found);
    idle_.erase(std::next(found).base());
    return result;
  }
  T take() {
    return take([](const T&) { return true; });
  }
  // Throws std::bad_alloc without memory for the list; the thing is then dropped.
  void give(T&& thing) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(thing));
  }

 private:
  std::mutex mutex_;
  std::vector<T> idle_;
};

}  // namespace rc_common
