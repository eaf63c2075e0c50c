#include "analysis/made.h"

#include "motion/models/pca.h"
#include "tests/analysis/made_study.h"

namespace promenade::analysis {
namespace {

using Eigen::VectorXd;
using Made = MadeTest;

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
