#include "analysis/preference.h"

#include <gtest/gtest.h>

#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

const std::vector<std::string> study_interfaces = {"weights", "labels"};  // of ToyLog::config

std::vector<std::string> votes(int map, int labels, int weights = 0) {
  std::vector<std::string> names(static_cast<std::size_t>(map), "map");
  names.insert(names.end(), static_cast<std::size_t>(labels), "labels");
  names.insert(names.end(), static_cast<std::size_t>(weights), "weights");
  return names;
}

// [N] 6: 14 of 17 preferred the map; printed p = .0127 and [.566, .962].
TEST(Preference, OfFourteenInSeventeenIsAsPrinted) {
  const Preference preference = preference_of({"map", "labels"}, votes(14, 3));
  EXPECT_EQ(preference.counts, (std::vector<int>{14, 3}));
  EXPECT_NEAR(preference.pairs[0].p, 0.0127, 5e-5);
  EXPECT_NEAR(preference.intervals[0].lower, 0.566, 5e-4);
  EXPECT_NEAR(preference.intervals[0].upper, 0.962, 5e-4);
  EXPECT_FALSE(preference.test);
}

// Pairs by the binomial distribution: 8 of 9, 8 of 8, 1 of 1; Holm times 3, 2, 1.
TEST(Preference, OfThreeHasAnExactTestAndPairs) {
  const Preference preference = preference_of({"map", "labels", "weights"}, votes(8, 1, 0));
  ASSERT_TRUE(preference.test && preference.test->p_exact);
  ASSERT_EQ(preference.pairs.size(), 3u);
  EXPECT_NEAR(preference.pairs[0].p, 2 * 10.0 / 512, 1e-15);
  EXPECT_NEAR(preference.pairs[1].p, 2.0 / 256, 1e-15);
  EXPECT_NEAR(preference.pairs[1].p_holm, 6.0 / 256, 1e-15);
  EXPECT_EQ(preference.pairs[2].p, 1);
}

TEST(Preference, OfNobodyOrOfOneInterfaceIsNone) {
  EXPECT_EQ(preference_of({"map", "labels"}, {}).n, 0);
  EXPECT_EQ(preference_of({"map"}, votes(3, 0)).n, 0);
}

void answer(ToyLog& log, const std::string& session, const std::string& name, int t_us,
            bool touched = true) {
  study::Statement row(
      log.database(),
      "INSERT INTO answer(session, instrument, version, item, value, text, "
      "declined, touched, t_us) VALUES (?,'preference','1','preferred',1,?,0,?,?)");
  row.bind(1, session).bind(2, name).bind(3, touched).bind(4, t_us).run();
}

TEST(Preference, IsTheLastAnswerOfThoseWhoCount) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    fill(log, 3, 0.001);
    log.session({"P9", "stopped"}).trial({});
    answer(log, "1", "labels", 5);
    answer(log, "1", "weights", 9);
    answer(log, "2", "labels", 5);
    answer(log, "3", "labels", 5, false);
    answer(log, "4", "labels", 5);
  }
  const Log log = read_log({folder.file("a.db")});
  const auto names = preferred(read_questionnaires(log, select(log, {})).pages, study_interfaces);
  EXPECT_EQ(names, (std::vector<std::string>{"weights", "labels"}));
}

TEST(Preference, IsTheInterfaceOfThatNumberWhereTheAnswerHasNoWords) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    fill(log, 1, 0.001);
    answer(log, "1", "", 5);
  }
  const Log log = read_log({folder.file("a.db")});
  EXPECT_EQ(preferred(read_questionnaires(log, select(log, {})).pages, study_interfaces),
            std::vector<std::string>{"weights"})
      << "the first of the study";
}

}  // namespace
}  // namespace promenade::analysis
