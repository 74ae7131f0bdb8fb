// A few threads that share the items of a task and sleep in between. No arithmetic depends on which thread takes which item, so
// results do not depend on the number of threads.
#pragma once

#include <roughcontact/plugin.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace rc {

class ThreadTeam : public rc_team {
 public:
  // The calling thread is one of them: with 1 no thread is made. Fewer than `count` if the system refuses to start them.
  explicit ThreadTeam(std::int64_t count);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

 private:
  using Task = void (*)(void* argument, std::int64_t item, std::int64_t thread);

  void run(std::int64_t items, Task task, void* argument);
  void work(std::int64_t thread);
  void end_round();
  void help(std::int64_t thread);
  void stop();

  std::vector<std::thread> helpers_;
  std::mutex mutex_;
  std::condition_variable wake_, idle_;
  // Written under mutex_; read without it by threads that watch for a change.
  std::atomic<std::uint64_t> round_{0};
  std::atomic<std::int64_t> busy_{0};  // helpers inside work()
  // Guarded by mutex_; task_, argument_ and items_ stay as they are while busy_ > 0.
  std::int64_t asleep_ = 0;
  std::size_t left_ = 0;  // helpers that have left for good
  bool open_ = false;     // helpers may still join this round
  bool stopping_ = false;
  Task task_ = nullptr;
  void* argument_ = nullptr;
  std::int64_t items_ = 0;
  std::atomic<std::int64_t> next_{0};
};

}  // namespace rc
