#include "analysis/made.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "analysis/results.h"
#include "motion/models/pca.h"
#include "study/simulate.h"
#include "tests/analysis/toy_log.h"
#include "tests/study/toy.h"

namespace promenade::analysis {
namespace {

using Eigen::VectorXd;

// The raters say: near is fast, side neither, far slow.
constexpr const char* ratings =
    "rater,motion,pair,value\na,near,slow-fast,2\na,side,slow-fast,0\na,far,slow-fast,-1\n"
    "b,near,slow-fast,2\nb,side,slow-fast,0\nb,far,slow-fast,-1\n";

class Made : public testing::Test {
 protected:
  // Six people do the toy study, which asks for a quality.
  Made() : bundle_(load()) {
    study::Store store(folder_.file("a.db"), bundle_);
    study::Cohort cohort;
    cohort.participants = 6;
    study::simulate_cohort(bundle_, study::toy::registry(), store, cohort);
    SelectionOptions options;
    options.include_simulated = true;
    results_ = compute_results({folder_.file("a.db")}, options, {}, &study::toy::registry());
  }
  study::StudyBundle load() {
    std::ofstream(folder_.file("r.csv")) << ratings;
    std::string text = study::toy::study_text();
    text.insert(text.find("seed"), "ratings = \"r.csv\"\n");
    const std::string jolly = "{ name = \"jolly\" }";
    text.replace(text.find(jolly), jolly.size(), R"({ name = "jolly", pair = "fast-slow" })");
    return study::read_study(
        folder_.file("s.toml"), text, study::toy::registry(),
        [](const std::string&, const std::string&) { return study::toy::motion_set(); });
  }
  // What the trial ended with, by a query of its own.
  VectorXd weights_of(const Trial& trial) {
    study::Database database(folder_.file("a.db"), study::Database::Mode::read_only);
    study::Statement last(database,
                          "SELECT weights FROM sample WHERE trial = ? "
                          "ORDER BY t_us DESC, rowid DESC LIMIT 1");
    last.bind(1, results_.log.trials[static_cast<std::size_t>(trial.logged)].uuid);
    EXPECT_TRUE(last.step());
    VectorXd weights(3);
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
  double d(const VectorXd& a, const VectorXd& b) const {
    const motion::MotionSpace& space = bundle_.space;
    return motion::distance(space.set, motion::blend(space, a), motion::blend(space, b)).mean_m;
  }

  TestFolder folder_;
  study::StudyBundle bundle_;
  Results results_;
};

TEST_F(Made, IsJudgedInTasksThatAskForAQuality) {
  int asked = 0;
  for (const Trial& trial : results_.data.trials) {
    for (const char* measure : {"asked_quality", "novelty_m", "mahalanobis", "diversity_m"}) {
      EXPECT_EQ(value(trial, measure).has_value(), asks(trial)) << measure;
    }
    asked += asks(trial) ? 1 : 0;
  }
  EXPECT_EQ(asked, 12);
}

TEST_F(Made, HasOfTheAskedWordWhatTheRatersSaidOfItsMotions) {
  for (const Trial& trial : results_.data.trials) {
    if (!asks(trial)) continue;
    const VectorXd w = weights_of(trial);
    EXPECT_NEAR(*value(trial, "asked_quality"), -2 * w(0) + 0 * w(1) + 1 * w(2), 1e-12);
  }
}

TEST_F(Made, IsAsNewAsItIsFarFromTheExamples) {
  const motion::Pca pca = motion::principal_components(bundle_.space);
  bool exact = false, between = false;
  for (const Trial& trial : results_.data.trials) {
    if (!asks(trial)) continue;
    const VectorXd w = weights_of(trial);
    double nearest = 1;
    for (int i = 0; i < 3; ++i) nearest = std::min(nearest, d(w, VectorXd::Unit(3, i)));
    EXPECT_NEAR(*value(trial, "novelty_m"), nearest, 1e-9);
    exact = exact || *value(trial, "novelty_m") == 0;
    between = between || nearest > 0.01;
    const VectorXd at = motion::coordinates_of(pca, w).cwiseQuotient(pca.variances.cwiseSqrt());
    EXPECT_NEAR(*value(trial, "mahalanobis"), at.norm(), 1e-9);
  }
  EXPECT_TRUE(exact && between) << "the simulated people are to make both";
}

TEST_F(Made, IsAsDiverseAsItIsFarFromWhatOthersMade) {
  for (const Trial& trial : results_.data.trials) {
    if (!asks(trial)) continue;
    double sum = 0;
    int others = 0;
    for (const Trial& other : results_.data.trials) {
      if (!asks(other) || other.interface != trial.interface || &other == &trial) continue;
      sum += d(weights_of(trial), weights_of(other));
      ++others;
    }
    ASSERT_EQ(others, 5);
    EXPECT_NEAR(*value(trial, "diversity_m"), sum / others, 1e-9);
  }
}

TEST_F(Made, IsNoMeasureWithoutTheStoredStudy) {
  Dataset data = results_.data;
  const std::size_t measures = data.measures.size();
  add_measures_of_made(results_.log, nullptr, data);
  EXPECT_EQ(data.measures.size(), measures);
}

}  // namespace
}  // namespace promenade::analysis
