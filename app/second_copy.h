// The second copy of the database, made beside the frames: a large one takes seconds.
#pragma once

#include <functional>
#include <future>
#include <optional>
#include <string>

namespace promenade::app {

class SecondCopy {
 public:
  // Makes the copy; the problem in one sentence, or nothing (study::second_copy_problem).
  using Work = std::function<std::optional<std::string>()>;

  // In a thread of its own, or at once where there can be none. `work` outlives this. Only once.
  void start(Work work);
  bool started() const { return started_; }
  // The problem, once the work is done and there was one; nothing is waited for.
  std::optional<std::string> problem();
  // Waits for the work, if there is any.
  void finish();

 private:
  std::future<std::optional<std::string>> running_;  // its end waits for the work
  std::optional<std::string> problem_;
  bool started_ = false;
};

}  // namespace promenade::app
