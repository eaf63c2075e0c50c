#include "study/work_queue.h"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace promenade::study {
namespace {

TEST(WorkQueue, DeliversInOrderInTheThreadThatAsks) {
  WorkQueue queue;
  std::vector<int> done;
  const std::thread::id here = std::this_thread::get_id();
  for (int k = 0; k < 5; ++k) {
    queue.ask([&done, k, here](const std::stop_token&) -> WorkQueue::Result {
      const bool beside = std::this_thread::get_id() != here;
      return [&done, k, beside, here] {
        if (beside && std::this_thread::get_id() == here) done.push_back(k);
      };
    });
  }
  while (queue.busy()) {
    queue.deliver();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(done, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(WorkQueue, LeavesWhatWaitsWhenItEnds) {
  int done = 0;
  {
    WorkQueue queue;
    queue.ask([](const std::stop_token& ended) -> WorkQueue::Result {
      while (!ended.stop_requested()) std::this_thread::yield();
      return {};
    });
    queue.ask([&done](const std::stop_token&) -> WorkQueue::Result {
      ++done;
      return {};
    });
  }
  EXPECT_EQ(done, 0);
}

}  // namespace
}  // namespace promenade::study
