// Looks at a database in a thread of its own, since the first look at a long session, or one that
// waits for a lock, takes longer than a frame.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "study/watch.h"

namespace promenade::app {

class WatchLooker {
 public:
  // `registry` outlives it.
  WatchLooker(std::string database, const study::InterfaceRegistry& registry);
  ~WatchLooker();  // a look that has begun comes to its end
  WatchLooker(const WatchLooker&) = delete;
  WatchLooker& operator=(const WatchLooker&) = delete;

  // Soon, unless a look has been asked for already.
  void look();
  // What was seen since this was asked last; null: nothing.
  std::shared_ptr<const study::Watched> news();
  bool busy() const;  // it looks, or there is news

 private:
  void run(const std::stop_token& ended);

  study::Watch watch_;        // of the thread
  mutable std::mutex mutex_;  // over what follows
  std::condition_variable_any asked_;
  bool wanted_ = false, looks_ = false;
  std::shared_ptr<const study::Watched> news_;
  std::jthread thread_;  // last: it uses all the others
};

}  // namespace promenade::app
