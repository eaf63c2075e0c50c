// What was asked of sessions, and what became of it as far as their logs tell: asked, done,
// refused, or no answer. Knows no window.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/control.h"
#include "study/texts.h"
#include "study/watch.h"

namespace promenade::app {

// What can be asked for.
struct Order {
  const char* name;  // of its texts and its button
  const char* what;  // study::Request::what
  bool block = false;
  bool needs_words = false;    // a reason, or what is noted
  bool is_about_page = false;  // it means what is on screen now, and nothing that comes later
};

struct Asked {
  enum class State { asked, done, refused, silent };
  study::Request request;
  const Order* order = nullptr;
  std::string participant;  // code
  std::int64_t asked_us = 0;
  State state = State::asked;
  std::string why;  // refused: as study::Refused has it, or "ended"
};

// "P07, Skip: refused, this cannot be done now".
std::string asked_words(const study::Texts& texts, const Asked& asked);

class AskedList {
 public:
  explicit AskedList(std::string database) : database_(std::move(database)) {}

  // `order` outlives the list; `session` is as the one who asks has seen it. Throws OutsideError.
  void ask(const Order& order, const study::WatchedSession& session, const std::string& words,
           std::int64_t now_us);
  // `now_us` on the clock of ask().
  void follow(const study::Watched& now, std::int64_t now_us);
  const std::vector<Asked>& all() const { return all_; }  // the latest last
  bool waits() const;                                     // for an answer

 private:
  std::string database_;
  std::vector<Asked> all_;
};

}  // namespace promenade::app
