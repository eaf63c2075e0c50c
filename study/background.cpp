#include "study/background.h"

#include <utility>

namespace promenade::study {

Background::Background() : thread_([this](const std::stop_token& ended) { run(ended); }) {}

Background::~Background() { thread_.request_stop(); }  // and is waited for

void Background::ask(Work work) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(work));
  asked_.notify_one();
}

bool Background::busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || !waiting_.empty() || !done_.empty();
}

void Background::deliver() {
  std::deque<Result> results;
  {
    const std::lock_guard lock(mutex_);
    results.swap(done_);
  }
  for (const Result& result : results) result();
}

void Background::run(const std::stop_token& ended) {
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
