#include "app/second_copy.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

namespace promenade::app {
namespace {

TEST(SecondCopy, KeepsNobodyWaitingUntilItIsReady) {
  std::promise<void> go;
  SecondCopy copy;
  EXPECT_FALSE(copy.started());
  copy.start([&]() -> std::optional<std::string> {
    go.get_future().wait();
    return "the stick is full";
  });
  EXPECT_TRUE(copy.started());
  EXPECT_EQ(copy.problem(), std::nullopt);  // and it has returned: the work still waits
  go.set_value();
  copy.finish();
  EXPECT_EQ(copy.problem(), "the stick is full");
  EXPECT_EQ(copy.problem(), "the stick is full");
}

TEST(SecondCopy, SaysNothingWhenAllIsWell) {
  SecondCopy copy;
  copy.start([] { return std::optional<std::string>(); });
  copy.finish();
  EXPECT_EQ(copy.problem(), std::nullopt);
}

TEST(SecondCopy, TurnsWhatIsThrownIntoTheProblem) {
  SecondCopy copy;
  copy.start([]() -> std::optional<std::string> { throw std::runtime_error("no memory"); });
  copy.finish();
  EXPECT_EQ(copy.problem(), "no second copy of the session: no memory");
  SecondCopy odd;
  odd.start([]() -> std::optional<std::string> { throw 5; });
  odd.finish();
  EXPECT_EQ(odd.problem(), "no second copy of the session");
}

TEST(SecondCopy, IsWaitedForAtTheEnd) {
  bool done = false;
  {
    SecondCopy copy;
    copy.start([&done] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      done = true;
      return std::optional<std::string>();
    });
  }
  EXPECT_TRUE(done);
}

TEST(SecondCopy, ThatWasNeverAskedForHasNoProblem) {
  SecondCopy copy;
  copy.finish();
  EXPECT_EQ(copy.problem(), std::nullopt);
}

}  // namespace
}  // namespace promenade::app
