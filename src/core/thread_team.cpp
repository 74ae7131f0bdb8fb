#include "core/thread_team.h"

#include <system_error>

#include "core/error.h"

namespace rc {

namespace {

// How often a thread looks for a change before it sleeps. The next task often comes within microseconds, sooner than a thread
// could wake. The number is small, because on a busy machine a watching thread takes a processor from another program.
constexpr int watches = 4000;

inline void pause_briefly() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  __asm__ volatile("yield");
#endif
}

template <class Condition> bool watch(const Condition& changed) {
  for (int i = 0; i < watches; ++i) {
    if (changed()) return true;
    pause_briefly();
  }
  return false;
}

}  // namespace

ThreadTeam::ThreadTeam(std::int64_t count) : rc_team{} {
  struct_size = sizeof(rc_team);
  share = [](const rc_team* team, std::int64_t items, Task task, void* argument) {
    const_cast<ThreadTeam*>(static_cast<const ThreadTeam*>(team))->run(items, task, argument);
  };
  threads = 1;
  if (count <= 1) return;
  helpers_.reserve(static_cast<std::size_t>(count) - 1);
  try {
    for (std::int64_t thread = 1; thread < count; ++thread) helpers_.emplace_back([this, thread] { help(thread); });
  } catch (const std::system_error&) {
    stop();
    fail(RC_ERR_MEMORY, "the system refused to start thread ", helpers_.size() + 2, " of ", count, "; lower the option threads");
  } catch (...) {
    stop();
    throw;
  }
  threads = count;
}

ThreadTeam::~ThreadTeam() { stop(); }

void ThreadTeam::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    ++round_;
  }
  round_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void ThreadTeam::run(std::int64_t items, Task task, void* argument) {
  if (items < 2 || helpers_.empty()) {
    for (std::int64_t item = 0; item < items; ++item) task(argument, item, 0);
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    task_ = task;
    argument_ = argument;
    items_ = items;
    next_ = 0;
    open_ = true;
    ++round_;
  }
  round_.notify_all();
  work(0);
  {
    const std::lock_guard lock(mutex_);
    open_ = false;  // a helper that comes later has nothing left to do and is not waited for
  }
  if (watch([&] { return busy_ == 0; })) return;
  for (std::int32_t busy = busy_; busy != 0; busy = busy_) busy_.wait(busy);
}

void ThreadTeam::work(std::int64_t thread) {
  for (std::int64_t item; (item = next_.fetch_add(1, std::memory_order_relaxed)) < items_;) task_(argument_, item, thread);
}

void ThreadTeam::help(std::int64_t thread) {
  std::uint32_t seen = 0;
  for (;;) {
    if (!watch([&] { return round_ != seen; })) round_.wait(seen);
    std::unique_lock lock(mutex_);
    if (stopping_) return;
    seen = round_;
    if (!open_) continue;
    ++busy_;
    lock.unlock();
    work(thread);
    if (--busy_ == 0) busy_.notify_one();
  }
}

}  // namespace rc
