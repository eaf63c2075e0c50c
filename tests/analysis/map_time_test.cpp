#include "analysis/map_time.h"

#include <gtest/gtest.h>

#include "analysis/results.h"
#include "study/simulate.h"
#include "tests/analysis/toy_log.h"
#include "tests/study/toy.h"

namespace promenade::analysis {
namespace {

TEST(MapTime, LastsUntilTheNextThingIsShownOrTheTrialEnds) {
  MapTime time;
  add_time({{0, 7}, {2'000'000, -1}, {3'000'000, 7}, {3'000'000, 9}}, 8'000'000, time);
  add_time({}, 8'000'000, time);
  EXPECT_EQ(time.trials, 1) << "one shows nothing";
  EXPECT_DOUBLE_EQ(time.seconds[7], 2);
  EXPECT_DOUBLE_EQ(time.seconds[9], 5);
  EXPECT_DOUBLE_EQ(time.outside_s, 1);
  EXPECT_DOUBLE_EQ(time.total_s(), 8);
}

TEST(MapTime, HasTheCellsOfTheCoverageMap) {
  study::CoverageMap map;
  map.examples = Eigen::MatrixX2d::Zero(1, 2);
  map.cell << 1, 1;
  const auto cell_at = [&](double column, double row) {
    map.least << -column - 0.5, -row - 0.5;
    return map.cell_of(Eigen::VectorXd::Ones(1));
  };
  EXPECT_EQ(cell_at(map_cells - 1, 3), (map_cells - 1) * map_cells + 3);
  EXPECT_EQ(cell_at(2, map_cells - 1), 2 * map_cells + map_cells - 1);
  EXPECT_EQ(cell_at(map_cells, 3), -1);
  EXPECT_EQ(cell_at(3, map_cells), -1);
}

TEST(MapTime, IsNeverNegative) {
  MapTime time;
  add_time({{5'000'000, 7}, {4'000'000, 8}}, 3'000'000, time);
  EXPECT_EQ(time.total_s(), 0);
}

// Three people do what the toy study asks of them.
void simulate(const std::string& file) {
  const study::StudyBundle bundle = study::toy::bundle();
  study::Store store(file, bundle);
  study::Cohort cohort;
  cohort.participants = 3;
  study::simulate_cohort(bundle, study::toy::registry(), store, cohort);
}

Results results_of(const std::string& file) {
  SelectionOptions options;
  options.include_simulated = true;
  return compute_results({file}, options, {}, &study::toy::registry());
}

double worked_s(const Results& results) {
  double sum = 0;
  for (const Trial& trial : results.data.trials) {
    const LoggedTrial& logged = results.log.trials[static_cast<std::size_t>(trial.logged)];
    sum += 1e-6 * static_cast<double>(*logged.ended_us - logged.started_us);
  }
  return sum;
}

double mapped_s(const MapTimes& times) {
  double sum = 0;
  for (const MapTime& time : times.times) sum += time.total_s();
  return sum;
}

TEST(MapTimes, AddUpToTheTimeThatPeopleWorked) {
  const TestFolder folder;
  simulate(folder.file("a.db"));
  const Results results = results_of(folder.file("a.db"));
  EXPECT_EQ(results.map_times.missing, "");
  EXPECT_EQ(results.map_times.names, (std::vector<std::string>{"near", "side", "far"}));
  EXPECT_EQ(results.map_times.tree.merges.size(), 2U);
  EXPECT_GT(worked_s(results), 1);
  EXPECT_NEAR(mapped_s(results.map_times), worked_s(results), 1e-6);
}

// `pick` shows nothing but examples and what it starts from, the average.
TEST(MapTimes, LieInTheCellsThatCoverageCounts) {
  const TestFolder folder;
  simulate(folder.file("a.db"));
  const MapTimes times = results_of(folder.file("a.db")).map_times;
  std::array<bool, map_cells * map_cells> known{};
  const auto know = [&](const Eigen::VectorXd& weights) {
    known[static_cast<std::size_t>(times.map.cell_of(weights))] = true;
  };
  for (int i = 0; i < 3; ++i) know(Eigen::VectorXd::Unit(3, i));
  know(Eigen::VectorXd::Constant(3, 1.0 / 3));
  ASSERT_FALSE(times.times.empty());
  for (const MapTime& time : times.times) {
    if (time.interface != 0) continue;
    EXPECT_EQ(time.outside_s, 0);
    for (std::size_t i = 0; i < known.size(); ++i) EXPECT_TRUE(known[i] || time.seconds[i] == 0);
  }
}

TEST(MapTimes, LeaveOutWhatStoodStillAndOtherSets) {
  const TestFolder folder;
  simulate(folder.file("a.db"));
  {
    study::Database database(folder.file("a.db"), study::Database::Mode::read_write);
    database.exec("UPDATE trial SET paused_us = 5 WHERE position % 2 = 0");
    database.exec("UPDATE motion_set SET sha256 = 'another'");
  }
  const Results results = results_of(folder.file("a.db"));
  const MapTimes& times = results.map_times;
  EXPECT_GT(times.paused, 0);
  EXPECT_EQ(times.paused + times.other_set, static_cast<int>(results.data.trials.size()));
  EXPECT_TRUE(times.times.empty());
}

TEST(MapTimes, SayThatAStoredStudyCannotBeRead) {
  const TestFolder folder;
  fill(*std::make_unique<ToyLog>(folder.file("a.db")), 2, 0.001);
  const MapTimes times =
      compute_results({folder.file("a.db")}, {}, {}, &study::toy::registry()).map_times;
  EXPECT_NE(times.missing.find("cannot read the stored study"), std::string::npos);
  EXPECT_TRUE(times.times.empty());
}

}  // namespace
}  // namespace promenade::analysis
