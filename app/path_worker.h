// Searches the walk along a path in a thread of its own, so that a window goes on: what was found
// so far can be seen at any time, and another path may be asked for before the last one is done.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "app/path_drawing.h"
#include "study/stimulus.h"

namespace promenade::app {

// The best walk along a path so far.
struct WalkedPath {
  std::shared_ptr<const study::Stimulus> motion;  // its take lies in the world of the path
  std::optional<motion::PathWalk> result;  // the search is over: to its end, or it was stopped
};

class PathWorker {
 public:
  // `options`: all but the parts, which each path brings.
  PathWorker(std::shared_ptr<const motion::MotionGraph> graph, motion::PathWalkOptions options);
  // Waits until the search hears of it, well below a second.
  ~PathWorker();
  PathWorker(const PathWorker&) = delete;
  PathWorker& operator=(const PathWorker&) = delete;

  void start(WantedPath path);  // what was asked for before is given up
  void stop();                  // the best so far is the answer
  void forget();                // nothing is asked for any more
  bool working() const { return working_; }
  double share() const { return share_; }  // of the work that is done, 0 to 1
  // What is better than all that was told before; null: nothing is.
  std::shared_ptr<const WalkedPath> news();
  std::string trouble() const;  // why there is no walk; empty: nothing is wrong

 private:
  struct Job {
    int number = 0;
    WantedPath path;
  };
  std::optional<Job> next(const std::stop_token& ended);
  void run(const std::stop_token& ended);
  void work(const Job& job, const std::stop_token& ended);
  motion::PathWalk search(const Job& job, const std::stop_token& ended);
  void publish(const Job& job, WalkedPath found);
  void finish(const Job& job, const std::string& trouble);
  void ask(std::optional<WantedPath> path);
  bool told() const;  // all that was published

  std::shared_ptr<const motion::MotionGraph> graph_;
  motion::PathWalkOptions options_;
  std::vector<motion::EdgeWay> ways_;  // of the thread; made for the first path
  mutable std::mutex mutex_;           // over what follows
  std::condition_variable_any asked_;
  std::optional<Job> waiting_;
  std::shared_ptr<const WalkedPath> news_;
  std::string trouble_;
  // What the search asks often, without the mutex.
  std::atomic<int> newest_ = 0;  // the number of the last job
  std::atomic<bool> stopped_ = false, working_ = false;
  std::atomic<double> share_ = 0;
  std::jthread thread_;  // last: it uses all the others
};

}  // namespace promenade::app
