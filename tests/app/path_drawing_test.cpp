// A path as it is drawn, and the ground from above on which it is.
#include "app/path_drawing.h"

#include <gtest/gtest.h>

#include "app/ground_plan.h"

namespace promenade::app {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;

TEST(PathDrawing, IsOpenUntilItIsEnded) {
  PathDrawing drawing;
  drawing.add_corner({0, 0});
  EXPECT_FALSE(drawing.end()) << "one corner is no path";
  drawing.add_corner({0, 2});
  EXPECT_TRUE(drawing.open());
  EXPECT_FALSE(drawing.wanted());
  EXPECT_EQ(drawing.revision(), 0);
  EXPECT_TRUE(drawing.end());
  EXPECT_FALSE(drawing.open());
  EXPECT_EQ(drawing.revision(), 1);
  EXPECT_NEAR(drawing.wanted()->length, 2, 1e-12);
}

TEST(PathDrawing, LeavesOutACornerInTheSamePlace) {
  PathDrawing drawing;
  drawing.add_corner({0, 0});
  drawing.add_corner({0.001, 0});
  EXPECT_EQ(drawing.corners().size(), 1U);
}

TEST(PathDrawing, KeepsAPlaceOfAStrokeEveryTwentyCentimetres) {
  PathDrawing drawing;
  drawing.begin_stroke({0, 0});
  for (int k = 1; k < 100; ++k) drawing.draw_to({0, 0.02 * k});
  drawing.end_stroke({0, 2});
  EXPECT_NEAR(static_cast<double>(drawing.corners().size()), 11, 1);
  EXPECT_EQ(drawing.corners().back().at, Vector2d(0, 2)) << "it ends where the hand ended";
  EXPECT_NEAR(drawing.wanted()->length, 2, 1e-9);
}

TEST(PathDrawing, GoesOnFromItsEndWithAnotherStroke) {
  PathDrawing drawing;
  drawing.begin_stroke({0, 0});
  drawing.end_stroke({0, 1});
  drawing.begin_stroke({0.05, 1});
  drawing.end_stroke({2, 1});
  EXPECT_EQ(drawing.corners().size(), 3U) << "the second begins where the first ended";
  EXPECT_EQ(drawing.revision(), 2);
  EXPECT_GT(drawing.wanted()->length, 3);
}

TEST(PathDrawing, WantsEachPartInTheStyleThatWasChosenThen) {
  PathDrawing drawing;
  drawing.add_corner({0, 0});
  drawing.add_corner({0, 1});
  drawing.choose("happy");
  drawing.add_corner({0, 2});
  drawing.add_corner({0, 3});
  drawing.choose("sad");
  drawing.add_corner({0, 4});
  drawing.end();
  const std::vector<motion::PathPart> parts = drawing.wanted()->parts;
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].label, "happy");
  EXPECT_NEAR(parts[0].from_m, 1, 1e-9);
  EXPECT_NEAR(parts[0].to_m, 3, 1e-9);
  EXPECT_EQ(parts[1].label, "sad");
  EXPECT_NEAR(parts[1].from_m, 3, 1e-9);
  EXPECT_NEAR(parts[1].to_m, 4, 1e-9);
}

// The curve is longer than its chords, and the parts with it.
TEST(PathDrawing, MeasuresItsPartsAlongTheCurve) {
  PathDrawing drawing;
  for (int k = 0; k <= 4; ++k) {
    drawing.choose(k > 2 ? "sad" : "");
    drawing.add_corner({std::cos(0.5 * M_PI * k), std::sin(0.5 * M_PI * k)});
  }
  drawing.end();
  const WantedPath path = *drawing.wanted();
  EXPECT_GT(path.length, 4 * std::sqrt(2.0));
  ASSERT_EQ(path.parts.size(), 1U);
  EXPECT_NEAR(path.parts[0].from_m, path.length / 2, 1e-6) << "a ring is the same on both sides";
  EXPECT_NEAR(path.parts[0].to_m, path.length, 1e-6);
}

TEST(PathDrawing, TakesBackTheLastCornerOrTheLastStroke) {
  PathDrawing drawing;
  drawing.add_corner({0, 0});
  drawing.add_corner({0, 1});
  drawing.end();
  drawing.begin_stroke({0.3, 1});
  drawing.end_stroke({1, 1});
  ASSERT_EQ(drawing.corners().size(), 4U);
  drawing.take_back();
  EXPECT_EQ(drawing.corners().size(), 2U);
  EXPECT_NEAR(drawing.wanted()->length, 1, 1e-12);
  drawing.take_back();
  EXPECT_FALSE(drawing.wanted());
  drawing.take_back();
  drawing.take_back();
  EXPECT_TRUE(drawing.corners().empty());
}

TEST(PathDrawing, AnOpenCornerTakenBackChangesNothingThatIsWanted) {
  PathDrawing drawing;
  for (const double z : {0.0, 1.0}) drawing.add_corner({0, z});
  drawing.end();
  drawing.add_corner({0, 2});
  const int revision = drawing.revision();
  drawing.take_back();
  EXPECT_EQ(drawing.revision(), revision);
  EXPECT_FALSE(drawing.open());
}

TEST(PathDrawing, BeginsWithTheTableOfAFile) {
  const study::PathTable table =
      study::parse_path("x,z,label\n0,0,\n0,1,happy\n0,2,\n0,3,\n", "p.csv");
  const PathDrawing drawing(table);
  const WantedPath path = *drawing.wanted();
  EXPECT_NEAR(path.length, 3, 1e-9);
  ASSERT_EQ(path.parts.size(), 1U);
  EXPECT_NEAR(path.parts[0].from_m, 1, 1e-9);
  EXPECT_NEAR(path.parts[0].to_m, 2, 1e-9);
  EXPECT_EQ(drawing.chosen(), "");
}

TEST(GroundPlan, ShowsAheadUpAndLeftToTheLeft) {
  const GroundPlan plan{{100, 50, 400, 400}, {}};
  EXPECT_EQ(plan.pixel({0, 0}), Vector2f(300, 250));
  EXPECT_EQ(plan.pixel({1, 2}), Vector2f(260, 170));
  EXPECT_LT((plan.place({260, 170}) - Vector2d(1, 2)).norm(), 1e-6);
}

TEST(GroundPlan, KeepsThePlaceUnderThePointerWhereItZooms) {
  GroundPlan plan{{0, 0, 400, 400}, {}};
  const Vector2f pointer(50, 300);
  const Vector2d at = plan.place(pointer);
  plan.sight = zoomed(plan.sight, 2, at);
  EXPECT_LT(plan.sight.across, 10);
  EXPECT_LT((plan.pixel(at) - pointer).norm(), 1e-3);
  EXPECT_EQ(zoomed(plan.sight, 100, at).across, least_across_m);
  EXPECT_EQ(zoomed(plan.sight, -100, at).across, most_across_m);
}

}  // namespace
}  // namespace promenade::app
