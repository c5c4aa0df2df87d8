#include "sim/session/parallel.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace cuesta {
namespace {

constexpr std::chrono::milliseconds kBetweenQuestions{100};

/// Hands numbers to the threads and keeps the exception of the lowest one.
class Crew {
 public:
  Crew(size_t count, const std::function<void(size_t, const std::atomic<bool>&)>& task)
      : count_(count), task_(task) {}

  void work() {
    while (!stop_) {
      const size_t number = next_++;
      if (number >= count_) break;
      try {
        task_(number, stop_);
        ++finished_;
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_ || number < failed_) {
          failure_ = std::current_exception();
          failed_ = number;
        }
        stop_ = true;
      }
    }
    const std::lock_guard lock(mutex_);
    ++ended_;
    changed_.notify_all();
  }

  /// Returns once so many threads have left `work`.
  void watch(size_t threads, const std::function<bool()>& go_on) {
    std::unique_lock lock(mutex_);
    const auto all_ended = [&] { return ended_ == threads; };
    while (!changed_.wait_for(lock, kBetweenQuestions, all_ended)) {
      lock.unlock();
      if (go_on && !go_on()) stop_ = true;
      lock.lock();
    }
  }

  void stop() { stop_ = true; }

  bool result() const {
    if (failure_) std::rethrow_exception(failure_);
    return finished_ == count_;
  }

 private:
  const size_t count_;
  const std::function<void(size_t, const std::atomic<bool>&)>& task_;
  std::atomic<size_t> next_ = 0, finished_ = 0;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  size_t ended_ = 0, failed_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

bool parallel_for(size_t count, int threads,
                  const std::function<void(size_t number, const std::atomic<bool>& stop)>& task,
                  const std::function<bool()>& go_on) {
  Crew crew(count, task);
  const size_t wanted = std::min(count, static_cast<size_t>(std::max(threads, 1)));
  if (wanted <= 1 && !go_on) {  // nobody to watch: no thread is needed
    crew.work();
    return crew.result();
  }
  std::vector<std::jthread> running;
  try {
    for (size_t k = 0; k < wanted; ++k) running.emplace_back([&crew] { crew.work(); });
    crew.watch(wanted, go_on);
  } catch (...) {
    crew.stop();
    throw;
  }
  running.clear();  // joins
  return crew.result();
}

}  // namespace cuesta
