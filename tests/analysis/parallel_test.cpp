#include "analysis/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

namespace promenade::analysis {
namespace {

TEST(Parallel, DoesEachOnceHoweverShortTheWork) {
  for (int round = 0; round < 500; ++round) {  // a thread may end before the next has begun
    std::vector<int> times(static_cast<std::size_t>(round % 7), 0);
    for_each_index(static_cast<int>(times.size()), [&](int i) { ++times[std::size_t(i)]; });
    for (const int count : times) EXPECT_EQ(count, 1);
  }
}

TEST(Parallel, PassesAFailureOn) {
  std::atomic<int> begun = 0;
  const auto work = [&](int i) {
    ++begun;
    if (i == 3) throw std::runtime_error("three");
  };
  EXPECT_THROW(for_each_index(1'000'000, work), std::runtime_error);
  EXPECT_LT(begun, 1'000'000);
}

TEST(Parallel, StopsWhenProgressSaysSo) {
  const auto stop = [](const std::string&, int, int) { return false; };
  EXPECT_THROW(for_each_index(
                   10, [](int) {}, stop, "done:"),
               OutsideError);
}

}  // namespace
}  // namespace promenade::analysis
