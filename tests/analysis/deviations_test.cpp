#include "analysis/deviations.h"

#include <gtest/gtest.h>

#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

class Deviations : public ::testing::Test {
 protected:
  // Each person with an order of their own.
  std::vector<Deviation> found(DeviationKind kind) {
    const Log read = read_log(log.database());
    std::vector<Deviation> all;
    for (const Deviation& one : deviations_of(read, select(read, {}))) {
      if (one.kind == kind) all.push_back(one);
    }
    return all;
  }
  void order(const std::string& session, int sequence) {
    log.database().exec("UPDATE session SET sequence = " + std::to_string(sequence) +
                        " WHERE uuid = '" + session + "'");
  }
  void act(const std::string& kind, const std::string& trial, int t_us, const std::string& reason) {
    log.database().exec(
        "INSERT INTO event(session, trial, seq, t_us, uncertainty_us, actor, kind, "
        "target, detail) VALUES ('1', " +
        trial + ", " + std::to_string(++seq) + ", " + std::to_string(t_us) +
        ", 0, 'experimenter', '" + kind + "', 'trial', '{\"reason\":\"" + reason + "\"}')");
  }
  TestFolder folder;
  ToyLog log{folder.file("a.db")};
  int seq = 0;
};

TEST_F(Deviations, AreNoneWhereAllWentAsPlanned) {
  fill(log, 3, 0.01);
  for (int i = 1; i <= 3; ++i) order(std::to_string(i), i - 1);
  const Log read = read_log(log.database());
  EXPECT_TRUE(deviations_of(read, select(read, {})).empty());
}

TEST_F(Deviations, AreTrialsThatOthersHave) {
  fill(log, 3, 0.01);
  log.database().exec("DELETE FROM trial WHERE uuid = '2/1'");
  const auto missing = found(DeviationKind::missing_trials);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].person, "P2");
  EXPECT_EQ(missing[0].count, 1);
}

TEST_F(Deviations, AreSkippedTrialsWithTheReasonOfTheExperimenter) {
  log.session({}).trial({}).trial({"labels", "sad", 3, {}, "skipped"});
  act("skip", "'1/2'", 2'000'000, "was ill");
  const auto skipped = found(DeviationKind::skipped);
  ASSERT_EQ(skipped.size(), 1u);
  EXPECT_EQ(skipped[0].what, "match, labels, sad");
  EXPECT_EQ(skipped[0].reason, "was ill");
}

TEST_F(Deviations, KnowTheReasonOfATrialThatWasSkippedBeforeItBegan) {
  log.session({}).trial({}).trial({"labels", "sad", 0, {}, "skipped"});
  act("skip", "NULL", 0, "no time");
  EXPECT_EQ(found(DeviationKind::skipped).at(0).reason, "no time");
}

TEST_F(Deviations, AreTrialsThatWereDoneAgain) {
  log.session({}).trial({}).trial({});
  log.database().exec("UPDATE trial SET superseded = 1 WHERE uuid = '1/1'");
  act("repeat", "NULL", 0, "the mouse fell");
  EXPECT_EQ(found(DeviationKind::repeated_trials).at(0).count, 1);
  EXPECT_EQ(found(DeviationKind::repeat).at(0).reason, "the mouse fell");
}

TEST_F(Deviations, AreOrdersThatTwoHaveOrNobody) {
  fill(log, 3, 0.01);
  order("1", 0);
  order("2", 3);
  order("3", 3);
  EXPECT_EQ(found(DeviationKind::order_repeated).size(), 2u);
  const auto unused = found(DeviationKind::order_unused);
  ASSERT_EQ(unused.size(), 2u);
  EXPECT_EQ(unused[0].what + unused[1].what, "12");
}

TEST_F(Deviations, AreInterruptions) {
  log.session({}).trial({});
  log.database().exec("UPDATE session SET resumed = 2");
  EXPECT_EQ(found(DeviationKind::resumed).at(0).count, 2);
}

}  // namespace
}  // namespace promenade::analysis
