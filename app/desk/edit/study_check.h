// `check`, live: reads the text of a study as it is now in a thread of its own, so that the window
// goes on. A text that changes is waited for until it has been the same for a moment; of several
// the newest wins.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "study/load_study.h"
#include "study/toml_path.h"

namespace promenade::app {

// A problem, and the value of the study file that it is about.
struct PlacedProblem {
  Problem problem;
  // Empty: the file as a whole, or another file (an instrument, ratings).
  study::TomlPath path;
  int line = 0;  // in the study file, from 1; 0: at no line of it
};

// What a text comes to.
struct StudyCheck {
  std::string text;
  std::vector<PlacedProblem> problems;  // errors and warnings, by their places
  // The walks of its motion set, whatever else is wrong: a bundle in which only space, bank and
  // set_sha256 can be relied on. Null: the set cannot be read.
  std::shared_ptr<const study::StudyBundle> motions;
  std::shared_ptr<const study::StudyBundle> bundle;  // null: there are errors
  bool has_errors() const { return bundle == nullptr; }
};

// The same here and now.
StudyCheck check_study(const std::string& file, const std::string& text,
                       const study::InterfaceRegistry& registry, const study::SetLoader& load_set);

class StudyChecker {
 public:
  // `file`: names the study, and its folder is where paths begin. `registry` outlives it.
  StudyChecker(std::string file, const study::InterfaceRegistry& registry);
  // Waits for the check that runs: about a second at most.
  ~StudyChecker();
  StudyChecker(const StudyChecker&) = delete;
  StudyChecker& operator=(const StudyChecker&) = delete;

  // Every frame, with the text as it is: starts a check when it has been the same for 300 ms.
  void see(const std::string& text, std::int64_t now_us);
  // What was found last; null: nothing yet. The same until there is another.
  std::shared_ptr<const StudyCheck> found() const;
  // Something is being checked, or will be.
  bool working() const;
  // Until nothing is asked for; for tests.
  void wait() const;

 private:
  void run(const std::stop_token& ended);

  std::string file_;
  const study::InterfaceRegistry& registry_;
  std::string seen_;  // of see(): the last text, and since when it is the same
  std::int64_t same_since_us_ = 0;
  bool pending_ = true, first_ = true;
  mutable std::mutex mutex_;  // over what follows
  mutable std::condition_variable_any changed_;
  std::optional<std::string> asked_;
  std::shared_ptr<const StudyCheck> found_;
  bool busy_ = false;
  std::jthread thread_;  // last: it uses the others
};

}  // namespace promenade::app
