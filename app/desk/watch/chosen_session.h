// Which of the sessions that are watched the buttons are for.
#pragma once

#include <string>

#include "study/watch.h"

namespace promenade::app {

class ChosenSession {
 public:
  // The only one is chosen by itself, but never in place of one that has just ended: a button that
  // somebody is about to press would mean another person.
  void follow(const study::Watched& now);
  // Null: none is chosen, or it has ended.
  const study::WatchedSession* in(const study::Watched& now) const;
  std::string& uuid() { return uuid_; }  // empty: none

 private:
  std::string uuid_;
  bool by_itself_ = true;
};

// One that runs or can be gone on with.
bool any_is_open(const study::Watched& now);

}  // namespace promenade::app
