// Work of a page that takes longer than a frame, in a thread of its own. Only the newest is wanted:
// what was begun before is told to stop, and what it finds is dropped. (Where each result is
// wanted, in its order: study/work_queue.h.)
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

namespace promenade::app {

template <typename Result>
class NewestWork {
 public:
  using Work = std::function<Result(const std::stop_token& ended)>;

  // `work` must throw nothing; it looks at `ended` now and then.
  void start(Work work) {
    auto found = std::make_shared<std::promise<Result>>();
    waiting_ = found->get_future();
    if (thread_.joinable()) {
      thread_.request_stop();
      earlier_.push_back(std::move(thread_));
    }
    thread_ = std::jthread([work = std::move(work), found](const std::stop_token& ended) {
      found->set_value(work(ended));
    });
  }

  // What was found, once.
  std::optional<Result> news() {
    if (!waiting_.valid() ||
        waiting_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      return std::nullopt;
    }
    earlier_.clear();
    return waiting_.get();
  }
  bool working() const { return waiting_.valid(); }

 private:
  std::future<Result> waiting_;
  std::vector<std::jthread> earlier_;  // told to stop
  std::jthread thread_;
};

}  // namespace promenade::app
