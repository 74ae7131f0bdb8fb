#include "workers.h"

#include <system_error>

#include "failure.h"

namespace rc_fft {

Workers::Workers(std::int64_t threads) {
  if (threads <= 1) return;
  helpers_.reserve(static_cast<std::size_t>(threads) - 1);
  try {
    for (std::int64_t thread = 1; thread < threads; ++thread) helpers_.emplace_back([this, thread] { help(thread); });
  } catch (const std::system_error&) {
    stop();
    fail(RC_ERR_MEMORY, "the system refused to start a thread; lower the option threads");
  } catch (...) {
    stop();
    throw;
  }
}

Workers::~Workers() { stop(); }

void Workers::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void Workers::share(Call call, const void* task, std::int64_t items) {
  {
    const std::lock_guard lock(mutex_);
    call_ = call;
    task_ = task;
    items_ = items;
    next_ = 0;
    open_ = true;
    ++round_;
  }
  wake_.notify_all();
  work(0);
  std::unique_lock lock(mutex_);
  open_ = false;  // a helper that wakes only now has nothing left to do and is not waited for
  idle_.wait(lock, [this] { return busy_ == 0; });
}

void Workers::work(std::int64_t thread) {
  for (std::int64_t item; (item = next_.fetch_add(1, std::memory_order_relaxed)) < items_;) call_(task_, item, thread);
}

void Workers::help(std::int64_t thread) {
  std::uint64_t seen = 0;
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [&] { return stopping_ || (open_ && round_ != seen); });
    if (stopping_) return;
    seen = round_;
    ++busy_;
    lock.unlock();
    work(thread);
    lock.lock();
    if (--busy_ == 0) idle_.notify_one();
  }
}

}  // namespace rc_fft
