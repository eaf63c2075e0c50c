#include "analysis/sensitivity.h"

#include <gtest/gtest.h>

#include "analysis/item.h"
#include "motion/files.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

class SensitivityTest : public ::testing::Test {
 protected:
  Sensitivity sensitivity(const std::string& excluded = "") {
    SelectionOptions options;
    if (!excluded.empty()) {
      options.exclude_file = folder.file("x.csv");
      write_file(options.exclude_file, excluded);
    }
    read = read_log(log.database());
    const Selection selection = select(read, options);
    data = make_dataset(read, selection);
    return sensitivity_of(read, options, selection, data);
  }
  // What a report would say of these people and trials alone.
  std::vector<Comparison> alone(const std::string& excluded) {
    write_file(folder.file("y.csv"), excluded);
    const Selection selection = select(read, {false, false, folder.file("y.csv")});
    std::vector<Comparison> found;
    for (Comparison& one : compare_all(make_dataset(read, selection))) {
      const std::string name = item(data.measures, one.measure).name;
      const bool primary = name == "d_final" || name == "d_best" || name == "time_s";
      if (primary && one.pooling == Pooling::participants) found.push_back(one);
    }
    return found;
  }
  TestFolder folder;
  ToyLog log{folder.file("a.db")};
  Log read;
  Dataset data;
};

void expect_same(const SensitivityVariant& variant, const std::vector<Comparison>& expected) {
  ASSERT_EQ(variant.results.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(variant.results[i].n, expected[i].test.n);
    EXPECT_EQ(variant.results[i].p_holm, expected[i].p_holm);
    EXPECT_EQ(variant.results[i].hl, expected[i].hl);
  }
}

TEST_F(SensitivityTest, HasNothingToVaryWhereNothingIsFlaggedOrExcluded) {
  fill(log, 7, 0.001);
  const Sensitivity made = sensitivity();
  EXPECT_EQ(made.variants.size(), 1u);
  EXPECT_TRUE(made.sentences.empty());
  EXPECT_EQ(made.compared, 3) << "d_best, d_final, time_s";
}

TEST_F(SensitivityTest, ComputesWithTheExcludedAgain) {
  fill(log, 8, 0.001);
  const Sensitivity made = sensitivity("P7,late\nP2,slept\n");
  ASSERT_EQ(made.variants.size(), 2u);
  EXPECT_EQ(made.variants[0].people, 6);
  EXPECT_EQ(made.variants[1].people, 8);
  expect_same(made.variants[0], alone("P7,\nP2,\n"));
  expect_same(made.variants[1], alone("code,reason\n"));
  EXPECT_EQ(made.sentences, std::vector<std::string>{"Without P2 and P7: same conclusions."});
}

// With six people p = 2/64; with five it is 2/32, which is not below .05.
TEST_F(SensitivityTest, SaysWhichConclusionsChange) {
  fill(log, 6, 0.001);
  const Sensitivity made = sensitivity("P3,\n");
  EXPECT_EQ(made.sentences.at(0).find("Without P3: 3 of 3 conclusions change: "), 0u);
  EXPECT_NE(made.sentences.at(0).find("; and 1 more."), std::string::npos);
  for (const SensitivityResult& one : made.variants[1].results) {
    EXPECT_EQ(one.same_conclusion, false);
  }
}

TEST_F(SensitivityTest, ComputesWithoutFlaggedTrials) {
  fill(log, 7, 0.001);
  const std::string flagged = "UPDATE trial SET paused_us = 1 WHERE session = '4'";
  log.database().exec(flagged);
  const Sensitivity made = sensitivity();
  ASSERT_EQ(made.variants.size(), 2u);
  expect_same(made.variants[1], alone("P4,\n"));
  EXPECT_EQ(made.sentences.at(0), "Without 2 flagged trials of 1 person: same conclusions.");
}

TEST_F(SensitivityTest, SaysWhenNothingIsLeft) {
  fill(log, 2, 0.001);
  log.database().exec("UPDATE trial SET paused_us = 1");
  EXPECT_EQ(sensitivity().sentences.at(0),
            "Without 4 flagged trials of 2 people: nothing is left to compare.");
}

TEST_F(SensitivityTest, ComputesEachVersionOfTheStudyWithTwoPeople) {
  fill(log, 9, 0.001);
  log.database().exec(
      "INSERT INTO study SELECT 'new', name, '2', config_text, 'def', program_version, "
      "'2026-11-23T10:00:00Z', motion_set FROM study");
  log.database().exec("INSERT INTO amendment VALUES ('new', 'study-abc', 'typo', '', 1)");
  log.database().exec("UPDATE session SET study = 'new' WHERE uuid IN ('8', '9')");
  const Sensitivity made = sensitivity();
  ASSERT_EQ(made.variants.size(), 3u);
  EXPECT_EQ(made.variants[1].name, "version 1 alone");
  expect_same(made.variants[1], alone("P8,\nP9,\n"));
  EXPECT_EQ(made.variants[2].people, 2);
}

TEST(NamesUpToFour, CountTheOthers) {
  EXPECT_EQ(names_up_to_four({"P1"}), "P1");
  EXPECT_EQ(names_up_to_four({"P1", "P2", "P3", "P4"}), "P1, P2, P3 and P4");
  EXPECT_EQ(names_up_to_four({"P1", "P2", "P3", "P4", "P5"}), "P1, P2, P3, P4 and 1 other");
}

}  // namespace
}  // namespace promenade::analysis
