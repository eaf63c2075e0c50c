#include "app/shelf.h"

#include <gtest/gtest.h>

#include "tests/app/panel_bench.h"

namespace promenade::app {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;
using study::Applied;
using study::ControlInput;

const motion::MotionSet& set() { return bench::space().set; }
VectorXd example(const std::string& name) {
  return VectorXd::Unit(set().size(), motion::find_cycle(set(), name));
}
Shelf empty_shelf() {
  return {set(), nullptr, VectorXd::Constant(set().size(), 1.0 / set().size())};
}
VectorXd weights_of(const Shelf& shelf) {
  VectorXd weights(set().size());
  EXPECT_TRUE(shelf.weights(weights));
  return weights;
}
Applied apply(Shelf& shelf, const ControlInput& input) {
  return shelf.apply(input, {example("old"), {1, 2}});
}

TEST(Shelf, GoesBackToWhatWasKept) {
  Shelf shelf = empty_shelf();
  EXPECT_EQ(apply(shelf, {.kind = "bookmark", .target = ""}), Applied::done);
  shelf.leave();
  EXPECT_EQ(apply(shelf, {.kind = "goto", .target = "1"}), Applied::done);
  EXPECT_EQ(weights_of(shelf), example("old"));
  EXPECT_EQ(shelf.point(), Vector2d(1, 2));
  EXPECT_EQ(shelf.current(), Item{.bookmark = 1});
}

TEST(Shelf, KeepsNumbersAndFillsGaps) {
  Shelf shelf = empty_shelf();
  for (int k = 0; k < 3; ++k) apply(shelf, {.kind = "bookmark", .target = ""});
  EXPECT_EQ(apply(shelf, {.kind = "remove", .target = "2"}), Applied::done);
  EXPECT_EQ(shelf.find_bookmark(2), nullptr);
  EXPECT_NE(shelf.find_bookmark(3), nullptr);
  apply(shelf, {.kind = "bookmark", .target = "sad"});
  ASSERT_NE(shelf.find_bookmark(2), nullptr);
  EXPECT_EQ(shelf.find_bookmark(2)->spot.weights, example("sad"));
  EXPECT_EQ(shelf.bookmarks()[1].number, 2);
}

TEST(Shelf, HasRoomForNineBookmarks) {
  Shelf shelf = empty_shelf();
  for (int k = 0; k < most_bookmarks; ++k) {
    EXPECT_EQ(apply(shelf, {.kind = "bookmark", .target = ""}), Applied::done);
  }
  EXPECT_EQ(apply(shelf, {.kind = "bookmark", .target = ""}), Applied::refused);
}

TEST(Shelf, BlendsInProportionToTheShares) {
  Shelf shelf = empty_shelf();
  apply(shelf, {.kind = "bookmark", .target = ""});
  apply(shelf, {.kind = "mix", .target = "sad"});
  EXPECT_EQ(weights_of(shelf), example("sad"));
  apply(shelf, {.kind = "mix", .target = "#1"});
  apply(shelf, {.kind = "share", .target = "sad", .value = 0.75});
  apply(shelf, {.kind = "share", .target = "#1", .value = 0.25});
  EXPECT_TRUE(weights_of(shelf).isApprox(0.75 * example("sad") + 0.25 * example("old"), 1e-15));
}

TEST(Shelf, OfSharesThatAreAllZeroShowsTheStart) {
  Shelf shelf = empty_shelf();
  for (const char* name : {"sad", "old"}) {
    apply(shelf, {.kind = "mix", .target = name});
    apply(shelf, {.kind = "share", .target = name, .value = 0});
  }
  EXPECT_EQ(weights_of(shelf), VectorXd::Constant(set().size(), 0.1));
}

TEST(Shelf, KeepsTheMixtureWhenSomethingElseIsShown) {
  Shelf shelf = empty_shelf();
  apply(shelf, {.kind = "mix", .target = "sad"});
  apply(shelf, {.kind = "mix", .target = "old"});
  shelf.go({.example = 0});
  EXPECT_EQ(shelf.shown(), Shelf::Shown::item);
  EXPECT_EQ(shelf.mixture().size(), 2U);
  apply(shelf, {.kind = "share", .target = "old", .value = 0.5});
  EXPECT_TRUE(weights_of(shelf).isApprox(0.5 * example("sad") + 0.5 * example("old"), 1e-15));
}

TEST(Shelf, WhatIsRemovedLeavesTheMixtureAndStaysShownToTheEnd) {
  Shelf shelf = empty_shelf();
  apply(shelf, {.kind = "bookmark", .target = ""});
  apply(shelf, {.kind = "mix", .target = "#1"});
  EXPECT_EQ(apply(shelf, {.kind = "remove", .target = "1"}), Applied::done);
  EXPECT_TRUE(shelf.mixture().empty());
  EXPECT_EQ(weights_of(shelf), example("old"));
  EXPECT_TRUE(shelf.current().empty());
}

TEST(Shelf, NamesHaveFortyCharactersNotBytes) {
  Shelf shelf = empty_shelf();
  apply(shelf, {.kind = "bookmark", .target = ""});
  std::string name;
  for (int k = 0; k < 41; ++k) name += "歩";
  EXPECT_EQ(apply(shelf, {.kind = "rename", .target = "1", .text = name}), Applied::done);
  EXPECT_EQ(shelf.bookmarks()[0].name, name.substr(0, 120));
}

TEST(Shelf, RefusesWhatCannotBe) {
  Shelf shelf = empty_shelf();
  apply(shelf, {.kind = "mix", .target = "sad"});
  for (const ControlInput& input :
       std::vector<ControlInput>{{.kind = "goto", .target = "1"},
                                 {.kind = "remove", .target = "0"},
                                 {.kind = "rename", .target = "9", .text = "x"},
                                 {.kind = "mix", .target = "sad"},
                                 {.kind = "mix", .target = "#1"},
                                 {.kind = "unmix", .target = "old"},
                                 {.kind = "share", .target = "sad", .value = 1.01},
                                 {.kind = "share", .target = "sad", .value = NAN},
                                 {.kind = "bookmark", .target = "nobody"},
                                 {.kind = "offer", .target = "nobody"},
                                 {.kind = "sing", .target = "sad"}}) {
    EXPECT_EQ(apply(shelf, input), Applied::refused) << input.kind << " " << input.target;
  }
}

TEST(Shelf, AnOfferChangesNoMotion) {
  Shelf shelf = empty_shelf();
  apply(shelf, {.kind = "bookmark", .target = ""});
  EXPECT_EQ(apply(shelf, {.kind = "offer", .target = "#1"}), Applied::aside);
  EXPECT_EQ(shelf.offered(), Item{.bookmark = 1});
  EXPECT_EQ(apply(shelf, {.kind = "edit", .target = "1"}), Applied::aside);
  EXPECT_EQ(shelf.edited(), 1);
  shelf.go({.example = 2});
  EXPECT_TRUE(shelf.offered().empty());
  EXPECT_EQ(shelf.edited(), 0);
}

TEST(Shelf, ItsMixtureCanBeSetAgainFromItsSettings) {
  Shelf shelf = empty_shelf();
  apply(shelf, {.kind = "mix", .target = "sad"});
  apply(shelf, {.kind = "mix", .target = "old"});
  apply(shelf, {.kind = "share", .target = "old", .value = 0.2});
  std::vector<ControlInput> settings;
  shelf.add_settings(settings);
  Shelf other = empty_shelf();
  for (const ControlInput& input : settings) EXPECT_EQ(apply(other, input), Applied::done);
  EXPECT_EQ(weights_of(other), weights_of(shelf));
}

}  // namespace
}  // namespace promenade::app
