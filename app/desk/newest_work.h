// Work of a page that takes longer than a frame, in a thread of its own. Only the newest is wanted:
// what was begun before is told to stop, and what it finds is dropped. (Where each result is
// wanted, in its order: study/work_queue.h.)
#pragma once

#include <atomic>
#include <exception>
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

  // `work` looks at `ended` now and then. What throws has found nothing.
  void start(Work work) {
    auto found = std::make_shared<std::promise<Result>>();
    waiting_ = found->get_future();
    auto over = std::make_shared<std::atomic<bool>>(false);
    if (now_.thread.joinable()) {
      now_.thread.request_stop();
      earlier_.push_back(std::move(now_));
    }
    now_ = {over, std::jthread([work = std::move(work), found, over](const std::stop_token& ended) {
              try {
                found->set_value(work(ended));
              } catch (...) {
                found->set_exception(std::current_exception());
              }
              *over = true;
            })};
  }

  // What was found, once.
  std::optional<Result> news() {
    if (!waiting_.valid() ||
        waiting_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      return std::nullopt;
    }
    std::erase_if(earlier_, [](const Worker& one) { return one.over->load(); });
    try {
      return waiting_.get();
    } catch (...) {
      return std::nullopt;
    }
  }
  // Nothing is wanted any more of what was begun.
  void forget() {
    now_.thread.request_stop();
    waiting_ = {};
  }
  bool working() const { return waiting_.valid(); }

 private:
  std::future<Result> waiting_;
  struct Worker {
    std::shared_ptr<std::atomic<bool>> over;
    std::jthread thread;
  };
  std::vector<Worker> earlier_;  // told to stop
  Worker now_;
};

}  // namespace promenade::app
