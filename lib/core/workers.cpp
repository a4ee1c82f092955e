#include "core/workers.hpp"

#include <system_error>

namespace slidezone {

Workers::Workers(int threads) {
  threads_.reserve(static_cast<std::size_t>(threads));
  try {
    for (int k = 1; k < threads; ++k) threads_.emplace_back([this] { serve(); });
  } catch (const std::system_error&) {  // those that there are share the tasks
  }
}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  work_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::each(std::size_t count, const std::function<void(std::size_t)>& task) {
  std::unique_lock lock(mutex_);
  task_ = &task;
  next_ = 0;
  count_ = unfinished_ = count;
  work_.notify_all();
  take_tasks(lock);
  done_.wait(lock, [this] { return unfinished_ == 0; });
}

void Workers::take_tasks(std::unique_lock<std::mutex>& lock) {
  while (next_ < count_) {
    const std::size_t number = next_++;
    lock.unlock();
    (*task_)(number);
    lock.lock();
    if (--unfinished_ == 0) done_.notify_one();
  }
}

void Workers::serve() {
  std::unique_lock lock(mutex_);
  while (!is_over_) {
    take_tasks(lock);
    work_.wait(lock, [this] { return is_over_ || next_ < count_; });
  }
}

}  // namespace slidezone
