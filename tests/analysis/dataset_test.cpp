#include "analysis/dataset.h"

#include <gtest/gtest.h>

#include "motion/files.h"
#include "tests/analysis/toy_log.h"
#include "tests/source_dir.h"

namespace promenade::analysis {
namespace {

Dataset dataset_of(const std::string& file) {
  const Log log = read_log({file});
  return make_dataset(log, select(log, {}));
}

TEST(Dataset, HasInterfacesInTheOrderOfTheStudy) {
  const TestFolder folder;
  ToyLog(folder.file("a.db")).session({}).trial({"labels"}).trial({"weights"}).trial({"another"});
  EXPECT_EQ(dataset_of(folder.file("a.db")).interfaces,
            (std::vector<std::string>{"weights", "labels", "another"}));
}

TEST(Dataset, HasTheMeasuresThatTheManualLists) {
  const std::string manual = read_file(source_dir() / "docs/analysts.md");
  for (const Measure& measure : make_dataset({}, {}).measures) {
    const std::string unit = measure.unit.empty() ? " | " : " | " + measure.unit + " | ";
    EXPECT_NE(manual.find("| `" + measure.name + "`" + unit), std::string::npos) << measure.name;
  }
}

TEST(Dataset, RestrictsTimeToTheLimit) {
  const TestFolder folder;
  ToyLog(folder.file("a.db"))
      .session({})
      .trial({.seconds = 60.2, .outcome = "timeout", .limit_s = 60})
      .trial({.seconds = 400, .limit_s = {}});
  const Dataset data = dataset_of(folder.file("a.db"));
  const auto time = static_cast<std::size_t>(data.measure("time_s"));
  EXPECT_EQ(data.trials[0].values[time], 60);
  EXPECT_EQ(data.trials[1].values[time], 400);
}

TEST(Dataset, LeavesPausesOutOfTheTime) {
  const TestFolder folder;
  ToyLog log(folder.file("a.db"));
  log.session({}).trial({.seconds = 500, .limit_s = 60});
  log.database().exec("UPDATE trial SET paused_us = 455000000");
  const Dataset data = dataset_of(folder.file("a.db"));
  EXPECT_EQ(data.trials[0].values[static_cast<std::size_t>(data.measure("time_s"))], 45);
}

TEST(Dataset, CountsTimeoutsAndGivingUpAsFailures) {
  const TestFolder folder;
  ToyLog(folder.file("a.db"))
      .session({})
      .trial({.outcome = "success", .threshold_m = 0.06})
      .trial({.outcome = "timeout", .threshold_m = 0.06})
      .trial({.d_final = 0.07, .outcome = "done", .threshold_m = 0.06})
      .trial({.d_final = 0.05, .outcome = "done", .threshold_m = 0.06})
      .trial({.d_final = 0.07, .outcome = "done"});
  std::vector<bool> failed;
  for (const Trial& trial : dataset_of(folder.file("a.db")).trials) failed.push_back(trial.failed);
  EXPECT_EQ(failed, (std::vector<bool>{false, true, true, false, false}));
}

TEST(Dataset, LeavesOutTrialsWithoutAnOutcomeOfTheirOwn) {
  const TestFolder folder;
  ToyLog(folder.file("a.db"))
      .session({})
      .trial({})
      .trial({.outcome = "skipped"})
      .trial({.outcome = "aborted"})
      .trial({.outcome = ""});
  const Dataset data = dataset_of(folder.file("a.db"));
  EXPECT_EQ(data.trials.size(), 1u);
  EXPECT_EQ(data.left_out_trials, 3);
}

TEST(Dataset, TakesTheLastAnswerAndKeepsItApartFromColumns) {
  const TestFolder folder;
  ToyLog(folder.file("a.db")).session({}).trial({}).answer("clicks", 2).answer("clicks", 6);
  const Dataset data = dataset_of(folder.file("a.db"));
  ASSERT_GE(data.measure("answer.clicks"), 0);
  EXPECT_EQ(data.trials[0].values[static_cast<std::size_t>(data.measure("answer.clicks"))], 6);
  EXPECT_EQ(data.trials[0].values[static_cast<std::size_t>(data.measure("clicks"))], 7);
}

TEST(Dataset, AveragesTheTrialsOfAPerson) {
  const TestFolder folder;
  ToyLog(folder.file("a.db"))
      .session({"P1"})
      .trial({"labels", "happy", 10})
      .trial({"labels", "old", 30})
      .session({"P2"})
      .trial({"weights", "old", 50});
  const Dataset data = dataset_of(folder.file("a.db"));
  const int time = data.measure("time_s");
  using Values = std::vector<std::optional<double>>;
  EXPECT_EQ(mean_per_person(data, time, 1, 0), (Values{20, std::nullopt}));
  EXPECT_EQ(mean_per_person(data, time, 1, 0, 1), (Values{30, std::nullopt}));
  EXPECT_EQ(mean_per_person(data, time, 0, 0), (Values{std::nullopt, 50}));
}

TEST(Dataset, KnowsTheLimitThatAllTrialsOfATaskShare) {
  const TestFolder folder;
  ToyLog(folder.file("a.db"))
      .session({})
      .trial({.limit_s = 60, .threshold_m = 0.05})
      .trial({.limit_s = 45, .threshold_m = 0.05});
  const Dataset data = dataset_of(folder.file("a.db"));
  EXPECT_FALSE(data.tasks[0].limit_s);
  EXPECT_EQ(data.tasks[0].threshold_m, 0.05);
}

TEST(Dataset, HasNoAmountsOfChoices) {
  const TestFolder folder;
  ToyLog log(folder.file("a.db"));
  log.session({}).trial({}).answer("effort", 4).answer("mental-physical", 2);
  log.database().exec("UPDATE answer SET text = 'physical' WHERE item = 'mental-physical'");
  const Dataset data = dataset_of(folder.file("a.db"));
  EXPECT_GE(data.measure("effort"), 0);
  EXPECT_EQ(data.measure("mental-physical"), -1);
}

TEST(Dataset, TellsItemsOfTwoInstrumentsApart) {
  const TestFolder folder;
  ToyLog log(folder.file("a.db"));
  log.session({}).trial({}).answer("satisfaction", 4).answer("other", 1);
  log.database().exec(
      "UPDATE answer SET instrument = 'mine', item = 'satisfaction' WHERE item = 'other'");
  const Dataset data = dataset_of(folder.file("a.db"));
  const auto value = [&](const char* name) {
    return data.trials[0].values.at(static_cast<std::size_t>(data.measure(name)));
  };
  EXPECT_EQ(value("satisfaction"), 4);
  EXPECT_EQ(value("mine.satisfaction"), 1);
}

}  // namespace
}  // namespace promenade::analysis
