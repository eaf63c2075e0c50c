// A toy study that asks six simulated people for a quality, and its results.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "analysis/results.h"
#include "study/simulate.h"
#include "tests/analysis/toy_log.h"
#include "tests/study/toy.h"

namespace promenade::analysis {

// The raters say: near is fast, side neither, far slow.
inline constexpr const char* toy_ratings =
    "rater,motion,pair,value\na,near,slow-fast,2\na,side,slow-fast,0\na,far,slow-fast,-1\n"
    "b,near,slow-fast,2\nb,side,slow-fast,0\nb,far,slow-fast,-1\n";

class MadeTest : public testing::Test {
 protected:
  // Six people do the toy study, which asks for a quality.
  MadeTest() : bundle_(load()) {
    study::Store store(folder_.file("a.db"), bundle_);
    study::Cohort cohort;
    cohort.participants = 6;
    study::simulate_cohort(bundle_, study::toy::registry(), store, cohort);
    SelectionOptions options;
    options.include_simulated = true;
    results_ = compute_results({folder_.file("a.db")}, options, {}, &study::toy::registry());
  }
  study::StudyBundle load() {
    std::ofstream(folder_.file("r.csv")) << toy_ratings;
    std::string text = study::toy::study_text();
    text.insert(text.find("seed"), "ratings = \"r.csv\"\n");
    const std::string jolly = "{ name = \"jolly\" }";
    text.replace(text.find(jolly), jolly.size(), R"({ name = "jolly", pair = "fast-slow" })");
    return study::read_study(
        folder_.file("s.toml"), text, study::toy::registry(),
        [](const std::string&, const std::string&) { return study::toy::motion_set(); });
  }
  // What the trial ended with, by a query of its own.
  Eigen::VectorXd weights_of(const Trial& trial) {
    study::Database database(folder_.file("a.db"), study::Database::Mode::read_only);
    study::Statement last(database,
                          "SELECT weights FROM sample WHERE trial = ? "
                          "ORDER BY t_us DESC, rowid DESC LIMIT 1");
    last.bind(1, results_.log.trials[static_cast<std::size_t>(trial.logged)].uuid);
    EXPECT_TRUE(last.step());
    Eigen::VectorXd weights(3);
    std::memcpy(weights.data(), last.blob(0).data(), 3 * sizeof(double));
    return weights;
  }
  std::optional<double> value(const Trial& trial, const char* measure) const {
    const int index = results_.data.measure(measure);
    EXPECT_GE(index, 0) << measure;
    return trial.values[static_cast<std::size_t>(index)];
  }
  bool asks(const Trial& trial) const {
    return results_.data.tasks[static_cast<std::size_t>(trial.task)].name == "seek";
  }
  double d(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    const motion::MotionSpace& space = bundle_.space;
    return motion::distance(space.set, motion::blend(space, a), motion::blend(space, b)).mean_m;
  }

  TestFolder folder_;
  study::StudyBundle bundle_;
  Results results_;
};

}  // namespace promenade::analysis
