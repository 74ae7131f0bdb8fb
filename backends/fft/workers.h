// A few threads that share out the lines of a transform and sleep in between. Which thread takes which item does not
// change any arithmetic, so results do not depend on the number of threads.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace rc_fft {

class Workers {
 public:
  // The calling thread is one of them: with 1 no thread is made.
  explicit Workers(std::int64_t threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  std::int64_t threads() const { return static_cast<std::int64_t>(helpers_.size()) + 1; }

  // task(item, thread) for 0 <= item < items, on this thread alone if not `parallel`. task must not throw.
  template <class Task> void for_each(std::int64_t items, bool parallel, const Task& task) {
    if (!parallel || items < 2 || helpers_.empty()) {
      for (std::int64_t item = 0; item < items; ++item) task(item, 0);
      return;
    }
    share([](const void* t, std::int64_t item, std::int64_t thread) { (*static_cast<const Task*>(t))(item, thread); }, &task,
          items);
  }

 private:
  using Call = void (*)(const void* task, std::int64_t item, std::int64_t thread);

  void share(Call call, const void* task, std::int64_t items);
  void work(std::int64_t thread);
  void help(std::int64_t thread);
  void stop();

  std::vector<std::thread> helpers_;
  std::mutex mutex_;
  std::condition_variable wake_, idle_;
  // Guarded by mutex_; call_, task_ and items_ stay as they are while busy_ > 0.
  std::uint64_t round_ = 0;
  std::int64_t busy_ = 0;  // helpers inside work()
  bool open_ = false;      // helpers may still join this round
  bool stopping_ = false;
  Call call_ = nullptr;
  const void* task_ = nullptr;
  std::int64_t items_ = 0;
  std::atomic<std::int64_t> next_{0};
};

}  // namespace rc_fft
