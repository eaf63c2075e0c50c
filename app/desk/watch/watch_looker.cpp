#include "app/desk/watch/watch_looker.h"

#include <sys/resource.h>

#include <utility>

#include "study/identity.h"

namespace promenade::app {

WatchLooker::WatchLooker(std::string database, const study::InterfaceRegistry& registry)
    : watch_(std::move(database), registry),
      thread_([this](const std::stop_token& ended) { run(ended); }) {}

WatchLooker::~WatchLooker() { thread_.request_stop(); }  // and is waited for

void WatchLooker::look() {
  const std::lock_guard lock(mutex_);
  if (looks_) return;
  wanted_ = true;
  asked_.notify_one();
}

std::shared_ptr<const study::Watched> WatchLooker::news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, nullptr);
}

bool WatchLooker::busy() const {
  const std::lock_guard lock(mutex_);
  return wanted_ || looks_ || news_ != nullptr;
}

void WatchLooker::run(const std::stop_token& ended) {
  // Whoever plays on this machine comes first. On Linux 0 is this thread alone.
  ::setpriority(PRIO_PROCESS, 0, 10);
  std::unique_lock lock(mutex_);
  while (asked_.wait(lock, ended, [this] { return wanted_; })) {
    if (ended.stop_requested()) return;
    wanted_ = false;
    looks_ = true;
    lock.unlock();
    auto seen = std::make_shared<const study::Watched>(watch_.look(study::utc_now()));
    lock.lock();
    looks_ = false;
    news_ = std::move(seen);
  }
}

}  // namespace promenade::app
