// What the threads behind the page "Takes to walks" meet.
#include "app/desk/takes/takes_work.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <new>

#include "motion/problem.h"
#include "tests/study/walk_captures.h"

namespace promenade::app {
namespace {

class TakesThreads : public testing::Test {
 protected:
  // The first verdict when nothing is left to do.
  study::Verdict verdict_with(TakesTools tools) {
    captures_.add("walk_happy_001.bvh", study::text_of(study::walk_of(0, 5)));
    TakesWork work(std::move(tools));
    work.add({captures_.folder()});
    for (int k = 0; k < 4000; ++k) {
      work.advance(0);
      if (work.to_read() == 0 && !work.busy() && !work.shop().uncut()) break;
      ::poll(nullptr, 0, 5);
    }
    return work.shop().verdict(0);
  }
  study::WalkCaptures captures_;
};

TEST_F(TakesThreads, TellATakeThatTheyCannotHold) {
  TakesTools tools;
  tools.read = [](const auto&, const auto&) -> study::ReadCapture { throw std::bad_alloc(); };
  const study::Verdict verdict = verdict_with(tools);
  EXPECT_EQ(verdict.state, study::TakeState::unreadable);
  EXPECT_EQ(verdict.reason, std::bad_alloc().what());
}

TEST_F(TakesThreads, TellATakeThatTheyCannotCut) {
  TakesTools tools;
  tools.cut = [](const auto&, const auto&, const auto&) -> motion::LoopReview {
    throw OutsideError("the disk is gone");
  };
  const study::Verdict verdict = verdict_with(tools);
  EXPECT_EQ(verdict.state, study::TakeState::unreadable);
  EXPECT_EQ(verdict.reason, "the disk is gone");
}

TEST_F(TakesThreads, ReadATakeThatIsFine) {
  EXPECT_EQ(verdict_with({}).state, study::TakeState::used);
}

}  // namespace
}  // namespace promenade::app
