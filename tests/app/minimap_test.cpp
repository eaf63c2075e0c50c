#include "app/minimap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/registry.h"
#include "tests/app/panel_bench.h"

namespace promenade::app {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;
using study::Applied;
using study::ControlInput;
using study::weights_of;

constexpr std::int64_t second = 1'000'000;

MinimapState state_with(const study::Parameters& changed, std::uint64_t seed = 1) {
  study::Parameters parameters = bench::standard_parameters(*interfaces().find("map"));
  for (const auto& [name, value] : changed) parameters.at(name) = value;
  const auto prepared = prepare_minimap({bench::space(), nullptr}, parameters);
  return MinimapState(
      {bench::space(), parameters, study::start_weights(bench::space()), seed, prepared.model});
}
MinimapState state_with(const std::string& heuristic, std::uint64_t seed = 1) {
  return state_with({{"heuristic", heuristic}}, seed);
}

ControlInput point(const Vector2d& at, std::int64_t t_us = 0, double dragged = 0) {
  return {
      .kind = "point", .target = "map", .value = dragged, .x = at.x(), .y = at.y(), .t_us = t_us};
}

TEST(MinimapState, ADotIsExactlyThatExample) {
  for (const char* heuristic : {"zero", "closest", "weights", "random"}) {
    MinimapState state = state_with(heuristic);
    EXPECT_EQ(state.apply({.kind = "go", .target = "sad"}), Applied::done);
    const int sad = motion::find_cycle(bench::space().set, "sad");
    EXPECT_EQ(weights_of(state, 0), VectorXd::Unit(10, sad));
    EXPECT_EQ(state.point(), Vector2d(state.map().examples.col(sad)));
  }
}

// The coordinates of the blend are the point: the map shows what it says.
TEST(MinimapState, ThePointIsThatOfTheWeightsItShows) {
  MinimapState state = state_with("closest");
  const Vector2d wanted = 0.3 * state.model().radii;
  EXPECT_EQ(state.apply(point(wanted)), Applied::done);
  const Vector2d shown = state.map().examples * weights_of(state, second / 10);
  EXPECT_TRUE(shown.isApprox(wanted, 1e-9));
}

TEST(MinimapState, GlidesOnFromWhatWasShown) {
  MinimapState state = state_with("closest");
  state.apply({.kind = "go", .target = "sad"});
  const Vector2d near = state.point() + Vector2d(1e-9, 0);
  state.apply(point(near, second));
  // All components that the map uses are still those of the example.
  const Eigen::MatrixXd& rest = state.map().rest;
  const int sad = motion::find_cycle(bench::space().set, "sad");
  EXPECT_TRUE((rest * weights_of(state, second)).isApprox(rest.col(sad), 1e-9));
}

TEST(MinimapState, OutsideThePointIsDrawnBackAndTheMapSaysSo) {
  MinimapState state = state_with("closest");
  const double far = state.model().half;
  EXPECT_EQ(state.apply(point({far, far})), Applied::done);
  EXPECT_TRUE(state.pulled_back());
  EXPECT_NEAR(state.point().cwiseQuotient(state.model().radii).norm(), 1, 1e-9);
  state.apply(point({0, 0}));
  EXPECT_FALSE(state.pulled_back());
}

TEST(MinimapState, ABlendOfNeighboursIsNeverDrawnBack) {
  MinimapState state = state_with("weights");
  const double far = state.model().half;
  state.apply(point({far, far}));
  EXPECT_FALSE(state.pulled_back());
  EXPECT_GE(weights_of(state, 0).minCoeff(), 0);
}

TEST(MinimapState, RandomDrawsAtEveryPressAndNotWhileDragged) {
  MinimapState state = state_with("random");
  const Vector2d at = 0.2 * state.model().radii;
  state.apply(point(at));
  const VectorXd first = weights_of(state, 0);
  state.apply(point(at, 0, 1));
  EXPECT_EQ(weights_of(state, 0), first);
  state.apply(point(at));
  EXPECT_NE(weights_of(state, 0), first);
}

TEST(MinimapState, RandomFollowsFromTheSeed) {
  const auto shown = [](std::uint64_t seed) {
    MinimapState state = state_with("random", seed);
    state.apply(point({0, 0}));
    return weights_of(state, 0);
  };
  EXPECT_EQ(shown(5), shown(5));
  EXPECT_NE(shown(5), shown(6));
}

TEST(MinimapState, BookmarksKeepTheirPlaceOnTheMap) {
  MinimapState state = state_with("closest");
  const Vector2d at = 0.4 * state.model().radii;
  state.apply(point(at));
  const VectorXd shown = weights_of(state, second);
  state.apply({.kind = "bookmark", .target = "", .t_us = second});
  state.apply({.kind = "go", .target = "sad", .t_us = 2 * second});
  state.apply({.kind = "goto", .target = "1", .t_us = 3 * second});
  EXPECT_EQ(weights_of(state, 3 * second), shown);
  EXPECT_EQ(state.point(), at);
}

TEST(MinimapState, OfAMixtureTheDotIsBetweenItsParts) {
  MinimapState state = state_with("closest");
  state.apply({.kind = "mix", .target = "sad"});
  state.apply({.kind = "mix", .target = "old"});
  const VectorXd weights = weights_of(state, 0);
  EXPECT_EQ(weights.maxCoeff(), 0.5);
  EXPECT_TRUE(state.point().isApprox(state.map().examples * weights, 1e-12));
}

TEST(MinimapState, TheSwitchIsOnlyThereWhenTheStudySaysSo) {
  MinimapState state = state_with("closest");
  EXPECT_EQ(state.apply({.kind = "heuristic", .target = "zero"}), Applied::refused);
  MinimapState other = state_with({{"switch", true}});
  other.apply(point(0.5 * other.model().radii));
  const VectorXd before = weights_of(other, second);
  EXPECT_EQ(other.apply({.kind = "heuristic", .target = "zero"}), Applied::done);
  EXPECT_FALSE(weights_of(other, second).isApprox(before, 1e-6));
  EXPECT_EQ(other.apply({.kind = "heuristic", .target = "guess"}), Applied::refused);
}

TEST(MinimapState, ZoomAndPanStayOnTheMapAndChangeNoMotion) {
  MinimapState state = state_with("closest");
  const double half = state.model().half;
  EXPECT_EQ(state.apply({.kind = "zoom", .target = "map", .value = 4, .x = 9 * half, .y = 0}),
            Applied::aside);
  EXPECT_DOUBLE_EQ(state.sight().centre.x(), 0.75 * half);
  EXPECT_EQ(state.apply({.kind = "pan", .target = "map", .x = 0, .y = -9 * half}), Applied::aside);
  EXPECT_DOUBLE_EQ(state.sight().centre.y(), -0.75 * half);
  EXPECT_EQ(state.apply({.kind = "whole", .target = "map"}), Applied::aside);
  EXPECT_EQ(state.sight().zoom, 1);
}

TEST(MinimapState, RefusesWhatIsNotOnTheMap) {
  MinimapState state = state_with("closest");
  const double half = state.model().half;
  EXPECT_EQ(state.apply(point({1.1 * half, 0})), Applied::refused);
  EXPECT_EQ(state.apply(point({NAN, 0})), Applied::refused);
  EXPECT_EQ(state.apply({.kind = "zoom", .target = "map", .value = 0.5, .x = 0, .y = 0}),
            Applied::refused);
  EXPECT_EQ(state.apply({.kind = "pan", .target = "map"}), Applied::refused);
  EXPECT_EQ(state.apply({.kind = "go", .target = "nobody"}), Applied::refused);
}

TEST(MinimapModel, NeedsCyclesThatDiffer) {
  motion::MotionSet set = bench::space().set;
  set.cycles.resize(1);
  const auto prepared = prepare_minimap({motion::make_motion_space(set), nullptr}, {});
  EXPECT_EQ(prepared.model, nullptr);
  EXPECT_FALSE(prepared.problem.empty());
}

}  // namespace
}  // namespace promenade::app
