#include "motion/models/map.h"

#include <gtest/gtest.h>

#include "motion/models/nearest.h"
#include "motion/quantile.h"
#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

Pca examples(Index count = 20) { return principal_components(Random(11).normals(300, count)); }

double no_normals() {
  ADD_FAILURE() << "this heuristic draws nothing";
  return 0;
}

VectorXd weights_after(const Minimap& map, const MapState& state, std::int64_t t_us) {
  VectorXd weights;
  weights_at(map, state, t_us, weights);
  return weights;
}

constexpr MapHeuristic heuristics[] = {MapHeuristic::zero, MapHeuristic::closest,
                                       MapHeuristic::weights, MapHeuristic::random};

TEST(AMinimap, HasThirtyEightComponentsForFiftyFiveWalks) {
  EXPECT_EQ(make_minimap(examples(55)).components(), 38);
  EXPECT_EQ(make_minimap(examples(10)).components(), 7);
  EXPECT_EQ(make_minimap(examples(21)).components(), 14);  // exactly 0.7 * 20
}

TEST(AMinimap, WorksFromTwoExamplesOn) {
  for (const MapHeuristic heuristic : heuristics) {
    const Minimap map = make_minimap(examples(2), {.heuristic = heuristic});
    const MapState state =
        move(map, start_map(map), {map.examples.col(1), true, 0}, [] { return 0.5; });
    const VectorXd weights = weights_after(map, state, 1'000'000);
    EXPECT_LE((weights - VectorXd::Unit(2, 1)).norm(), 1e-12);
  }
}

TEST(AMinimap, StartsAtTheAverage) {
  const Minimap map = make_minimap(examples());
  EXPECT_LE((weights_after(map, start_map(map), 0) - VectorXd::Constant(20, 0.05)).norm(), 1e-15);
}

TEST(AMinimap, HasAnEllipseOfValidPoints) {
  const Minimap map = make_minimap(examples(), {.metric = MapMetric::mahalanobis});
  const Vector2d radii = valid_radii(map);
  for (double angle = 0; angle < 6; angle += 0.1) {
    const Vector2d edge = radii.cwiseProduct(Vector2d(std::cos(angle), std::sin(angle)));
    EXPECT_EQ(pull_back(map, 0.999 * edge), Vector2d(0.999 * edge));
    const Vector2d back = pull_back(map, 1.2 * edge);
    EXPECT_NEAR(back.cwiseQuotient(radii).norm(), 1, 1e-12);
  }
}

TEST(EveryHeuristic, KeepsTheSumAndTheCursor) {
  const Pca pca = examples();
  Random random(12);
  for (const MapHeuristic heuristic :
       {MapHeuristic::zero, MapHeuristic::closest, MapHeuristic::random}) {
    const Minimap map = make_minimap(pca, {.heuristic = heuristic});
    for (int i = 0; i < 50; ++i) {
      const Vector2d point = 0.2 * map.unit.cwiseProduct(Vector2d(random.normals(2, 1)));
      const MapState state =
          move(map, start_map(map), {point, true, 0}, [&] { return random.normal(); });
      const VectorXd weights = weights_after(map, state, 30'000);
      EXPECT_NEAR(weights.sum(), 1, 1e-12);
      EXPECT_LE((coordinates_of(pca, weights).head(2) - point).norm(), 1e-11);
    }
  }
}

TEST(ZeroHeuristic, LeavesTheOtherComponentsAtZero) {
  const Pca pca = examples();
  const Minimap map = make_minimap(pca, {.heuristic = MapHeuristic::zero});
  const MapState state = move(map, start_map(map), {Vector2d(1, -2), true, 0}, no_normals);
  const VectorXd alpha = coordinates_of(pca, weights_after(map, state, 0));
  EXPECT_LE(alpha.tail(alpha.size() - 2).norm(), 1e-11);
}

TEST(ClosestHeuristic, EndsAtTheComponentsOfTheClosestExample) {
  const Pca pca = examples();
  const Minimap map = make_minimap(pca, {.heuristic = MapHeuristic::closest});
  const MapState state = move(map, start_map(map), {map.examples.col(7), true, 0}, no_normals);
  const VectorXd alpha = coordinates_of(pca, weights_after(map, state, 60'000'000));
  EXPECT_LE((alpha.head(14) - pca.coordinates.col(7).head(14)).norm(), 1e-10);
}

TEST(ClosestHeuristic, WithAllComponentsReachesTheExampleItself) {
  const Minimap map = make_minimap(examples(), {.components = 19});
  const MapState state = move(map, start_map(map), {map.examples.col(3), true, 0}, no_normals);
  EXPECT_LE((weights_after(map, state, 60'000'000) - VectorXd::Unit(20, 3)).norm(), 1e-10);
}

TEST(ClosestHeuristic, GlidesExponentiallyWithItsTimeConstant) {
  const Minimap map = make_minimap(examples(), {.glide_s = 0.2});
  const MapState state =
      move(map, start_map(map), {map.examples.col(5), true, 1'000'000}, no_normals);
  const VectorXd rest = rest_at(map, state, 1'200'000);
  EXPECT_LE((rest - (1 - std::exp(-1)) * map.rest.col(5)).norm(), 1e-12);
}

TEST(ClosestHeuristic, DoesNotDependOnRepeatedEventsWithinOneCell) {
  const Minimap map = make_minimap(examples());
  const Vector2d point = map.examples.col(5);
  const MapState once = move(map, start_map(map), {point, true, 0}, no_normals);
  MapState often = once;
  for (std::int64_t t = 7'001; t < 300'000; t += 7'001) {
    often = move(map, often, {point, false, t}, no_normals);
  }
  EXPECT_LE((rest_at(map, often, 400'000) - rest_at(map, once, 400'000)).norm(), 1e-12);
}

TEST(WeightsHeuristic, BlendsTheNearestExamplesWhereverTheCursorIs) {
  const Minimap map = make_minimap(examples(), {.heuristic = MapHeuristic::weights, .nearest = 4});
  const Vector2d point(100, 3);
  const MapState state = move(map, start_map(map), {point, true, 0}, no_normals);
  EXPECT_EQ(state.point, point);
  const VectorXd weights = weights_after(map, state, 0);
  EXPECT_EQ(weights, nearest_weights(map.examples, point, 4));
  EXPECT_EQ((weights.array() > 0).count(), 4);
}

TEST(RandomHeuristic, DrawsWithTheVariancesOfTheExamples) {
  const Pca pca = examples();
  const Minimap map = make_minimap(pca, {.heuristic = MapHeuristic::random});
  Random random(13);
  VectorXd squares = VectorXd::Zero(map.rest.rows());
  constexpr int draws = 4000;
  for (int i = 0; i < draws; ++i) {
    squares += move(map, start_map(map), {Vector2d::Zero(), true, 0}, [&] {
                 return random.normal();
               }).rest.cwiseAbs2();
  }
  const VectorXd ratio = squares.cwiseQuotient(draws * pca.variances.segment(2, map.rest.rows()));
  // Standard error of a variance: sqrt(2 / draws) = 0.022; few draws are pulled back.
  EXPECT_NEAR(ratio.mean(), 1, 0.05);
  EXPECT_LE((ratio.array() - 1).abs().maxCoeff(), 0.12);
}

TEST(RandomHeuristic, KeepsItsDrawWhileTheMouseDrags) {
  const Minimap map = make_minimap(examples(), {.heuristic = MapHeuristic::random});
  Random random(14);
  const MapState picked =
      move(map, start_map(map), {Vector2d(1, 1), true, 0}, [&] { return random.normal(); });
  EXPECT_EQ(move(map, picked, {Vector2d(2, 1), false, 5}, no_normals).rest, picked.rest);
}

TEST(AMahalanobisMap, IsInStandardDeviations) {
  const Pca pca = examples();
  const Minimap map =
      make_minimap(pca, {.heuristic = MapHeuristic::zero, .metric = MapMetric::mahalanobis});
  for (int a = 0; a < 2; ++a) EXPECT_NEAR(map.examples.row(a).squaredNorm(), 19, 1e-9);
  const MapState state = move(map, start_map(map), {Vector2d(0.5, 0), true, 0}, no_normals);
  EXPECT_NEAR(coordinates_of(pca, weights_after(map, state, 0))(0), 0.5 * map.deviations(0), 1e-10);
}

TEST(EveryExample, IsValidOnTheMap) {
  const Minimap map = make_minimap(examples(55));
  for (int i = 0; i < 55; ++i) {
    EXPECT_LE((pull_back(map, map.examples.col(i)) - map.examples.col(i)).norm(), 1e-12);
    EXPECT_LE(map.rest.col(i).cwiseQuotient(map.deviations.tail(36)).norm(),
              map.rest_limit + 1e-12);
  }
}

TEST(APointOutside, IsPulledBackToTheBorderOnItsWay) {
  const Minimap map = make_minimap(examples());
  const Vector2d far(500, -300);
  const Vector2d back = pull_back(map, far);
  EXPECT_NEAR(back.cwiseQuotient(map.deviations.head(2)).norm(), map.point_limit, 1e-9);
  const Vector2d home = map.examples.col(nearest_column(map.examples, far));
  const Vector2d a = back - home, b = far - home;
  EXPECT_NEAR(a.x() * b.y() - a.y() * b.x(), 0, 1e-9 * b.squaredNorm());
}

TEST(LeaveOneOutLimit, IsThatOfCovariancesComputedAnew) {
  const MatrixXd x = examples(30).coordinates.middleRows(2, 6);
  std::vector<double> distances;
  for (Index i = 0; i < 30; ++i) {
    MatrixXd others(6, 29);
    others << x.leftCols(i), x.rightCols(29 - i);
    const VectorXd mean = others.rowwise().mean();
    const MatrixXd spread = others.colwise() - mean;
    const MatrixXd covariance = spread * spread.transpose() / 28;
    const VectorXd d = x.col(i) - mean;
    distances.push_back(std::sqrt(d.dot(covariance.ldlt().solve(d))));
  }
  EXPECT_NEAR(leave_one_out_limit(x, 0.95), quantile(distances, 0.95), 1e-9);
}

}  // namespace
}  // namespace promenade::motion
