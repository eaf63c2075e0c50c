// Work beside the thread that draws: one thing after another in a thread of its own. What is to be
// done with the result is done where deliver() is called, so that nothing else needs a lock.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace promenade::study {

class WorkQueue {
 public:
  using Result = std::function<void()>;
  // Done in the thread; gives what deliver() does with it. Throws nothing. A long one looks at the
  // token now and then.
  using Work = std::function<Result(const std::stop_token& ended)>;

  WorkQueue();
  ~WorkQueue();  // waits for the work in hand
  WorkQueue(const WorkQueue&) = delete;
  WorkQueue& operator=(const WorkQueue&) = delete;

  void ask(Work work);
  bool busy() const;  // something waits, is being done, or waits to be delivered
  void deliver();     // does what is to be done with all results that are there

 private:
  void run(const std::stop_token& ended);

  mutable std::mutex mutex_;  // over what follows
  std::condition_variable_any asked_;
  std::deque<Work> waiting_;
  std::deque<Result> done_;
  bool working_ = false;
  std::jthread thread_;  // last: it uses all the others
};

}  // namespace promenade::study
