#include "core/thread_team.h"

#include <chrono>
#include <system_error>

#include "platform/threads.h"

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

// Until the condition holds. A condition variable of glibc before 2.41 can lose a wake-up: `again` is called, and the condition
// looked at, every now and then. A helper that is not woken only misses a round.
template <class Again, class Condition>
void wait_surely(std::condition_variable& variable, std::unique_lock<std::mutex>& lock, const Again& again,
                 const Condition& condition) {
  constexpr std::chrono::milliseconds now_and_then{20};
  do again();
  while (!variable.wait_until(lock, std::chrono::system_clock::now() + now_and_then, condition));
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
  const rc_platform::SignalsBlocked helpers_take_no_signals;
  try {
    for (; threads < count; ++threads) helpers_.emplace_back([this, thread = threads] { help(thread); });
  } catch (const std::system_error&) {
    // The system refuses more threads: those that there are do the work.
  } catch (...) {
    stop();
    throw;
  }
}

ThreadTeam::~ThreadTeam() { stop(); }

void ThreadTeam::stop() {
  {
    std::unique_lock lock(mutex_);
    stopping_ = true;
    ++round_;
    wait_surely(
        idle_, lock, [this] { wake_.notify_all(); }, [this] { return left_ == helpers_.size(); });
  }
  for (std::thread& helper : helpers_) helper.join();
}

void ThreadTeam::run(std::int64_t items, Task task, void* argument) {
  if (items < 2 || helpers_.empty()) {
    for (std::int64_t item = 0; item < items; ++item) task(argument, item, 0);
    return;
  }
  bool wake = false;
  {
    const std::lock_guard lock(mutex_);
    task_ = task;
    argument_ = argument;
    items_ = items;
    next_ = 0;
    open_ = true;
    ++round_;
    wake = asleep_ > 0;
  }
  if (wake) wake_.notify_all();
  struct Round {  // ends with this function, also if a function of the host's ends the thread inside the task
    ThreadTeam& team;
    ~Round() { team.end_round(); }
  } round{*this};
  work(0);
}

void ThreadTeam::end_round() {
  {
    const std::lock_guard lock(mutex_);
    open_ = false;  // a helper that comes later has nothing left to do and is not waited for
  }
  if (watch([&] { return busy_ == 0; })) return;
  std::unique_lock lock(mutex_);
  wait_surely(
      idle_, lock, [] {}, [this] { return busy_ == 0; });
}

void ThreadTeam::work(std::int64_t thread) {
  for (std::int64_t item; (item = next_.fetch_add(1, std::memory_order_relaxed)) < items_;) task_(argument_, item, thread);
}

void ThreadTeam::help(std::int64_t thread) {
  struct Counted {  // down to what it was, also if a function of the host's ends the thread inside the task
    ThreadTeam& team;
    ~Counted() {
      const std::lock_guard lock(team.mutex_);
      if (--team.busy_ == 0) team.idle_.notify_one();
    }
  };
  struct Left {
    ThreadTeam& team;
    ~Left() {
      const std::lock_guard lock(team.mutex_);
      ++team.left_;
      team.idle_.notify_one();
    }
  } left{*this};
  std::uint64_t seen = 0;
  for (;;) {
    watch([&] { return round_ != seen; });
    std::unique_lock lock(mutex_);
    ++asleep_;
    wake_.wait(lock, [&] { return stopping_ || round_ != seen; });
    --asleep_;
    if (stopping_) return;
    seen = round_;
    if (!open_) continue;
    ++busy_;
    lock.unlock();
    const Counted counted{*this};
    work(thread);
  }
}

}  // namespace rc
