#include "motion/graph/all_cores.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace promenade::motion {
namespace {

class Crew {
 public:
  Crew(int count, const std::function<void(int)>& work) : count_(count), work_(work) {}
  ~Crew() { join(); }

  void hire(int threads) {
    for (int t = 0; t < threads; ++t) threads_.emplace_back([this] { work(nullptr); });
  }

  // Until nothing is left; who has a `progress` tells it.
  void work(const std::function<bool(double)>* progress) {
    for (int piece = next_++; piece < count_ && !stopped_; piece = next_++) {
      try {
        work_(piece);
        ++done_;
        if (progress && *progress && !(*progress)(share())) stopped_ = true;
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!trouble_) trouble_ = std::current_exception();
        stopped_ = true;
      }
    }
  }

  bool finish() {
    join();
    if (trouble_) std::rethrow_exception(trouble_);
    return !stopped_;
  }

 private:
  double share() const { return static_cast<double>(done_) / count_; }

  void join() {
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
  }

  int count_;
  const std::function<void(int)>& work_;
  std::atomic<int> next_{0}, done_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;  // of trouble_
  std::exception_ptr trouble_;
  std::vector<std::thread> threads_;
};

}  // namespace

bool for_each_piece(int count, const std::function<void(int)>& work,
                    const std::function<bool(double)>& progress, int threads) {
  if (threads == 0) threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  Crew crew(count, work);
  crew.hire(std::min(threads, count) - 1);
  crew.work(&progress);
  return crew.finish();
}

}  // namespace promenade::motion
