#include "analysis/quality.h"

#include <gtest/gtest.h>

#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

class QualityTest : public ::testing::Test {
 protected:
  Quality quality() {
    const Log read = read_log(log.database());
    const Selection selection = select(read, {});
    return quality_of(read, selection, make_dataset(read, selection));
  }
  void event(const std::string& trial, int uncertainty_us, const std::string& kind = "press") {
    log.database().exec(
        "INSERT INTO event(session, trial, seq, t_us, uncertainty_us, actor, kind) "
        "VALUES ('1', '" +
        trial + "', " + std::to_string(++seq) + ", 0, " + std::to_string(uncertainty_us) +
        ", 'participant', '" + kind + "')");
  }
  TestFolder folder;
  ToyLog log{folder.file("a.db")};
  int seq = 0;
};

// 10 s with labels and 20 s with weights: half a minute.
TEST_F(QualityTest, CountsLateFramesByInterfaceAndMinute) {
  log.session({}).trial({"labels", "happy", 10}).trial({"weights", "happy", 20});
  log.database().exec("UPDATE trial SET late_frames = 6 WHERE interface = 'weights'");
  const Quality counted = quality();
  ASSERT_EQ(counted.counts.size(), 3u);
  EXPECT_EQ(counted.counts[0].late_frames, 6);
  EXPECT_DOUBLE_EQ(counted.counts[0].minutes, 0.5);
  EXPECT_DOUBLE_EQ(*counted.counts[0].late_per_minute, 12);
  EXPECT_DOUBLE_EQ(*counted.counts[1].late_per_minute, 18) << "weights stands first in the study";
  EXPECT_DOUBLE_EQ(*counted.counts[2].late_per_minute, 0);
}

TEST_F(QualityTest, KnowsTheMedianAndTheLargestUncertaintyOfTrials) {
  log.session({}).trial({}).trial({}).trial({});
  event("1/1", 1000);
  event("1/1", 3000);
  event("1/2", 60'000);
  event("1/3", 500);
  const QualityCount all = quality().counts[0];
  EXPECT_DOUBLE_EQ(*all.median_uncertainty_ms, 3);
  EXPECT_DOUBLE_EQ(*all.largest_uncertainty_ms, 60);
  EXPECT_EQ(all.coarse_time, 1);
  EXPECT_EQ(all.flagged, 1);
}

TEST_F(QualityTest, CountsATrialWithTwoReasonsOnceAsFlagged) {
  log.session({}).trial({}).trial({});
  event("1/1", 0, "interrupted");
  log.database().exec("UPDATE trial SET paused_us = 5 WHERE uuid = '1/1'");
  const QualityCount all = quality().counts[0];
  EXPECT_EQ(all.interrupted, 1);
  EXPECT_EQ(all.paused, 1);
  EXPECT_EQ(all.flagged, 1);
  EXPECT_EQ(all.trials, 2);
}

TEST_F(QualityTest, CountsWhatHasNoOutcomeOfItsOwn) {
  log.session({}).trial({});
  for (const char* outcome : {"skipped", "aborted", ""}) {
    log.trial({"labels", "happy", 1, {}, outcome});
  }
  const Quality counted = quality();
  for (const QualityCount& one : counted.counts) {
    EXPECT_EQ(one.skipped, 1);
    EXPECT_EQ(one.aborted, 1);
    EXPECT_EQ(one.cut_off, 1);
    EXPECT_EQ(one.trials, 1);
  }
}

TEST_F(QualityTest, CountsResumedSessionsOfPeopleWhoCount) {
  log.session({"P1"}).trial({}).session({"P2"}).trial({}).session({"P3", "stopped"}).trial({});
  log.database().exec("UPDATE session SET resumed = 2 WHERE uuid <> '1'");
  EXPECT_EQ(quality().resumed_sessions, 1);
  EXPECT_EQ(quality().resumptions, 2);
}

}  // namespace
}  // namespace promenade::analysis
