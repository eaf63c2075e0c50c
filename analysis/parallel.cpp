#include "analysis/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace promenade::analysis {
namespace {

// The threads of one call; none is left when it goes away.
class Crew {
 public:
  Crew(int count, const std::function<void(int)>& work, int threads) : count_(count), work_(work) {
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const int workers = std::min(threads > 0 ? threads : cores, count);
    workers_ = workers;
    for (int i = 0; i < workers; ++i) threads_.emplace_back([this] { run(); });
  }
  ~Crew() {
    stop_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  // True when all is done or failed; looks again after a while if not.
  bool wait() {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, std::chrono::milliseconds(100), [this] { return workers_ == 0; });
  }
  int done() const { return done_; }
  void rethrow() {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void run() {
    try {
      for (int i = next_++; i < count_ && !stop_; i = next_++) {
        work_(i);
        ++done_;
      }
    } catch (...) {
      stop_ = true;
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    --workers_;
    ended_.notify_all();
  }

  const int count_;
  const std::function<void(int)>& work_;
  std::atomic<int> next_{0}, done_{0};
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable ended_;
  int workers_ = 0;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace

void for_each_index(int count, const std::function<void(int)>& work, const Progress& progress,
                    const std::string& what, int threads) {
  Crew crew(count, work, threads);
  while (!crew.wait()) report_progress(progress, what, crew.done(), count);
  crew.rethrow();
  report_progress(progress, what, count, count);
}

}  // namespace promenade::analysis
