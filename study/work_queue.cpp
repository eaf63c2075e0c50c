#include "study/work_queue.h"

#include <utility>

namespace promenade::study {

WorkQueue::WorkQueue() : thread_([this](const std::stop_token& ended) { run(ended); }) {}

WorkQueue::~WorkQueue() { thread_.request_stop(); }  // and is waited for

void WorkQueue::ask(Work work) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(work));
  asked_.notify_one();
}

bool WorkQueue::busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || !waiting_.empty() || !done_.empty();
}

void WorkQueue::deliver() {
  std::deque<Result> results;
  {
    const std::lock_guard lock(mutex_);
    results.swap(done_);
  }
  for (const Result& result : results) result();
}

void WorkQueue::run(const std::stop_token& ended) {
  std::unique_lock lock(mutex_);
  while (asked_.wait(lock, ended, [this] { return !waiting_.empty(); })) {
    if (ended.stop_requested()) return;
    const Work work = std::move(waiting_.front());
    waiting_.pop_front();
    working_ = true;
    lock.unlock();
    Result result = work(ended);
    lock.lock();
    working_ = false;
    if (result) done_.push_back(std::move(result));
  }
}

}  // namespace promenade::study
