// Commands beside the desk: what they print arrives, and they can be stopped.
#include "app/desk/job.h"

#include <gtest/gtest.h>
#include <poll.h>

#include "motion/problem.h"

namespace promenade::app {
namespace {

// Looks until `done` says so; false: it never did.
template <typename Done>
bool look_until(Job& job, const Done& done) {
  for (int k = 0; k < 2000; ++k) {
    job.look();
    if (done()) return true;
    ::poll(nullptr, 0, 5);
  }
  return false;
}

std::vector<std::string> script(const std::string& text) { return {"-c", text}; }

TEST(DeskJob, TellsWhatItPrintedAndHowItEnded) {
  Job job("/bin/sh", script("echo out; echo trouble >&2; exit 2"));
  ASSERT_TRUE(look_until(job, [&] { return !job.running(); }));
  EXPECT_EQ(job.exit_code(), 2);
  EXPECT_EQ(job.output(), "out\n");
  EXPECT_EQ(job.messages(), "trouble\n");
}

TEST(DeskJob, KeepsProgressApartFromMessages) {
  Job job("/bin/sh", script("echo '  people drawn 3 of 40 ' >&2; echo 'one of 2' >&2"));
  ASSERT_TRUE(look_until(job, [&] { return !job.running(); }));
  EXPECT_EQ(job.progress().doing, "people drawn");
  EXPECT_EQ(job.progress().done, 3);
  EXPECT_EQ(job.progress().count, 40);
  EXPECT_EQ(job.messages(), "one of 2\n");
}

TEST(DeskJob, AsksCommandsForTheirProgress) {
  Job job("/bin/sh", script("echo $PROMENADE_PROGRESS"));
  ASSERT_TRUE(look_until(job, [&] { return !job.running(); }));
  EXPECT_EQ(job.output(), "lines\n");
}

TEST(DeskJob, IsStoppedAsByCtrlC) {
  Job job("/bin/sh", script("trap 'exit 7' INT; echo ready; while :; do sleep 0.01; done"));
  ASSERT_TRUE(look_until(job, [&] { return !job.output().empty(); }));
  job.stop();
  ASSERT_TRUE(look_until(job, [&] { return !job.running(); }));
  EXPECT_TRUE(job.stopped());
  EXPECT_EQ(job.exit_code(), 7);
}

TEST(DeskJob, TellsWhichSignalKilledIt) {
  Job job("/bin/sh", script("kill -KILL $$"));
  ASSERT_TRUE(look_until(job, [&] { return !job.running(); }));
  EXPECT_EQ(job.exit_code(), 128 + 9);
}

TEST(DeskJob, RefusesAProgramThatIsNotThere) {
  EXPECT_THROW(Job("/nowhere/promenade", {}), OutsideError);
}

}  // namespace
}  // namespace promenade::app
