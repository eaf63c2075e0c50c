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

// The raters say: near is fast, side neither, far slow. Fewer of them could agree by chance.
inline std::string toy_ratings() {
  std::string rows = "rater,motion,pair,value\n";
  for (int rater = 0; rater < 8; ++rater) {
    const std::string who = "r" + std::to_string(rater);
    rows += who + ",near,slow-fast,2\n" + who + ",side,slow-fast,0\n" + who + ",far,slow-fast,-1\n";
  }
  return rows;
}

class MadeTest : public testing::Test {
 protected:
  // Six people do the toy study, which asks for a quality.
  MadeTest() : bundle_(load()) {
    study::Store store(folder_.file("a.db"), bundle_);
    study::Cohort cohort;
    cohort.participants = 6;
    study::simulate_cohort(bundle_, study::toy::registry(), store, cohort);
    blend_with_mix();
    SelectionOptions options;
    options.include_simulated = true;
    results_ = compute_results({folder_.file("a.db")}, options, {}, &study::toy::registry());
  }
  study::StudyBundle load() {
    std::ofstream(folder_.file("r.csv")) << toy_ratings();
    std::string text = study::toy::study_text();
    text.insert(text.find("seed"), "ratings = \"r.csv\"\n");
    const std::string jolly = "{ name = \"jolly\" }";
    text.replace(text.find(jolly), jolly.size(), R"({ name = "jolly", pair = "fast-slow" })");
    return study::read_study(
        folder_.file("s.toml"), text, study::toy::registry(),
        [](const std::string&, const std::string&) { return study::toy::motion_set(); });
  }
  // Simulated people take the extreme of what is asked; with one interface they end in between.
  void blend_with_mix() {
    study::Database database(folder_.file("a.db"), study::Database::Mode::read_write);
    study::Statement trials(database, "SELECT uuid FROM trial WHERE interface = 'mix'");
    std::vector<std::string> uuids;
    while (trials.step()) uuids.push_back(trials.text(0));
    for (std::size_t i = 0; i < uuids.size(); ++i) {
      const double share = 0.03 * static_cast<double>(i);
      const Eigen::Vector3d weights(share, 0.3, 0.7 - share);
      study::Statement update(database, "UPDATE sample SET weights = ? WHERE trial = ?");
      update.bind_blob(1, {reinterpret_cast<const char*>(weights.data()), 3 * sizeof(double)});
      update.bind(2, uuids[i]).run();
    }
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
