#include "analysis/published/published.h"

#include <gtest/gtest.h>

#include "analysis/results.h"

namespace promenade::analysis {
namespace {

constexpr int d_final = 0, time_s = 1, clicks = 2;

constexpr const char* oshita =
    "[study]\npublished = \"oshita-2018\"\n"
    "[[interface]]\nname = \"words\"\ntype = \"adjectives\"\n"
    "[[interface]]\nname = \"features\"\n[[interface]]\nname = \"weights\"\n";
constexpr const char* normoyle =
    "[study]\npublished = \"normoyle-untimed\"\n"
    "[[interface]]\nname = \"map\"\n[[interface]]\nname = \"labels\"\n";

void add(Results& results, int person, int interface, int task, int target,
         std::vector<std::optional<double>> values) {
  Trial trial;
  trial.person = person;
  trial.interface = interface;
  trial.task = task;
  trial.target = target;
  trial.values = std::move(values);
  results.data.trials.push_back(trial);
}

Results empty(const std::string& config, std::vector<std::string> interfaces, int people) {
  Results results;
  results.log.config_text = config;
  results.data.interfaces = std::move(interfaces);
  results.data.measures = {{"d_final", "final D", "m", "cm", 100, 1},
                           {"time_s", "time", "s", "s", 1, 1},
                           {"clicks", "mouse clicks", "", "", 1, 1}};
  results.data.people.resize(static_cast<std::size_t>(people));
  return results;
}

// Five targets; the guess with features is always the worst, times are equal but for one person.
Results oshita_run(int people) {
  Results results = empty(oshita, {"words", "features", "weights"}, people);
  results.data.tasks = {{"guess", {"1", "2", "3", "4", "5"}, {}, {}, true},
                        {"match", {"1", "2", "3", "4", "5"}, 300.0, {}, false}};
  for (int person = 0; person < people; ++person) {
    for (int interface = 0; interface < 3; ++interface) {
      for (int target = 0; target < 5; ++target) {
        const double worse = interface == 1 ? 0.02 + 0.001 * person : 0;
        add(results, person, interface, 0, target, {0.03 + worse, 10, 5});
        const bool slow = person == 0 && interface == 2;
        add(results, person, interface, 1, target, {0.01, slow ? 50.0 : 40.0, 5});
      }
    }
  }
  results.comparisons = compare_all(results.data);
  return results;
}

std::vector<PublishedRow> rows_of(const Published& published, std::string_view kind) {
  std::vector<PublishedRow> rows;
  for (const PublishedRow& row : published.rows) {
    if (row.kind == kind) rows.push_back(row);
  }
  return rows;
}

TEST(Published, IsEmptyOfAStudyThatRepeatsNone) {
  Results results = oshita_run(3);
  results.log.config_text = "[study]\nname = \"x\"\n";
  const Published published = published_of(results, nullptr);
  EXPECT_EQ(published.study, nullptr);
  EXPECT_TRUE(published.rows.empty());
}

TEST(Published, HasARowForEachPrintedTest) {
  const Results results = oshita_run(13);
  const auto tests = rows_of(published_of(results, nullptr), "test");
  ASSERT_EQ(tests.size(), 36U);
  EXPECT_EQ(tests[0].what, "D of the guess: adjectives − features");
  EXPECT_EQ(tests[0].printed, .382);
  EXPECT_EQ(tests[0].n, 13);
  EXPECT_EQ(tests[0].direction, "words");
  EXPECT_FALSE(*tests[0].agrees) << ".382 in print, significant here";
  EXPECT_TRUE(*tests[1].agrees);
  EXPECT_NEAR(*tests[0].p_exact, 2.0 / 8192, 1e-12);
  EXPECT_EQ(tests[5].target, "all");
  EXPECT_EQ(tests[5].n, 65);
  EXPECT_NEAR(*tests[5].p_exact, 2.0 / 8192, 1e-12) << "of one value per participant";
}

// Not the exact p, and not that with continuity correction.
TEST(Published, TestsAsThePaperDid) {
  const Results results = oshita_run(13);
  const PublishedRow row = rows_of(published_of(results, nullptr), "test")[0];
  const double z = 45.5 / std::sqrt(13 * 14 * 27 / 24.0);
  EXPECT_NEAR(*row.run, std::erfc(z / std::sqrt(2)), 1e-12);
}

TEST(Published, SaysWhereNothingDiffers) {
  const Results results = oshita_run(13);
  const auto tests = rows_of(published_of(results, nullptr), "test");
  const PublishedRow& equal = tests[18];  // time, adjectives − features, target 1
  EXPECT_EQ(equal.what, "time: adjectives − features");
  EXPECT_FALSE(equal.run);
  EXPECT_FALSE(equal.agrees);
  EXPECT_NE(equal.note.find("All differences are zero"), std::string::npos);
  EXPECT_NE(equal.note.find("13 differences cannot have"), std::string::npos);
  EXPECT_EQ(tests[24].direction, "words") << "one person was slower with weights";
}

TEST(Published, LeavesOpenWhatARunDoesNotHave) {
  Results results = oshita_run(3);
  results.log.config_text =
      "[study]\npublished = \"oshita-2018\"\n[[interface]]\nname = \"weights\"\n";
  for (const PublishedRow& row : rows_of(published_of(results, nullptr), "test")) {
    EXPECT_EQ(row.n, 0);
    EXPECT_FALSE(row.run || row.agrees);
  }
}

TEST(Published, CountsPeopleOnlyWithTheStudyAtHand) {
  const Published published = published_of(oshita_run(13), nullptr);
  for (const PublishedRow& row : rows_of(published, "design")) {
    EXPECT_TRUE(row.printed);
    EXPECT_FALSE(row.run);
  }
}

// With the map `people` of them click less, each by another amount.
Results normoyle_run(int people, int fewer) {
  Results results = empty(normoyle, {"map", "labels"}, people);
  results.data.tasks = {{"find", {"happy"}, {}, {}, false}, {"match", {"1"}, {}, {}, false}};
  for (int person = 0; person < people; ++person) {
    const double less = person < fewer ? 1.0 + person : -1.0 - person;
    for (int task = 0; task < 2; ++task) {
      const std::optional<double> d = task == 1 ? std::optional(0.02) : std::nullopt;
      add(results, person, 0, task, 0, {d, 9, 50.0 - less});
      add(results, person, 1, task, 0, {d, 9, 50});
    }
  }
  results.comparisons = compare_all(results.data);
  return results;
}

std::vector<PublishedRow> clicks_in(const Published& published) {
  auto rows = rows_of(published, "claim");
  std::erase_if(rows, [](const auto& row) { return row.what != "fewer clicks with the map"; });
  return rows;
}

TEST(Published, HoldsAStatementAgainstEachTask) {
  const auto rows = clicks_in(published_of(normoyle_run(9, 9), nullptr));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].target, "task find");
  EXPECT_EQ(rows[1].target, "task match");
  EXPECT_TRUE(*rows[0].agrees);
  EXPECT_EQ(rows[0].direction, "map");
  EXPECT_FALSE(*clicks_in(published_of(normoyle_run(9, 0), nullptr))[0].agrees)
      << "significant the other way round";
  EXPECT_FALSE(*clicks_in(published_of(normoyle_run(9, 5), nullptr))[0].agrees);
}

TEST(Published, SaysWhatNobodyMeasured) {
  const auto claims = rows_of(published_of(normoyle_run(9, 9), nullptr), "claim");
  for (const PublishedRow& row : claims) {
    if (row.what.find("creative") == std::string::npos) continue;
    EXPECT_FALSE(row.agrees);
    EXPECT_EQ(row.note, "This run has no values of it.");
  }
}

TEST(Published, AsksForTheSameDirectionOfThePreference) {
  Results results = normoyle_run(17, 9);
  const auto preferred = [&](std::size_t map) {
    std::vector<std::string> names(map, "map");
    names.resize(17, "labels");
    results.preference = preference_of({"map", "labels"}, names);
    return rows_of(published_of(results, nullptr), "preference").at(0);
  };
  EXPECT_TRUE(*preferred(14).agrees);
  EXPECT_EQ(preferred(14).run_words, preferred(14).printed_words);
  EXPECT_FALSE(*preferred(3).agrees);
  EXPECT_FALSE(*preferred(10).agrees);
}

}  // namespace
}  // namespace promenade::analysis
