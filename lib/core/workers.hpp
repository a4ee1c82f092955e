// Threads that share out numbered tasks and sleep in between.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace slidezone {

class Workers {
 public:
  /// `threads` >= 1 in all: the caller of `each` is one of them. Fewer where the system gives no more.
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Threads in all.
  std::size_t count() const { return threads_.size() + 1; }

  /// Calls task(0) ... task(count - 1), in any order and side by side; returns when all are done. Tasks must not throw.
  void each(std::size_t count, const std::function<void(std::size_t)>& task);

 private:
  void serve();
  void take_tasks(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable work_;
  std::condition_variable done_;
  const std::function<void(std::size_t)>* task_ = nullptr;
  std::size_t next_ = 0;
  std::size_t count_ = 0;
  std::size_t unfinished_ = 0;
  bool is_over_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace slidezone
