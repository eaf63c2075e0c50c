#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "app/shelf.h"
#include "tests/app/panel_bench.h"

namespace promenade::app {
namespace {

using bench::PanelBench;

int cycle(const std::string& name) { return motion::find_cycle(bench::space().set, name); }

TEST(Labels, AClickShowsThatStyleAtOnce) {
  PanelBench panel("labels");
  panel.click("pick", "old");
  ASSERT_EQ(panel.log().size(), 1U);
  EXPECT_EQ(panel.log()[0].kind, "pick");
  EXPECT_EQ(panel.log()[0].target, "old");
  EXPECT_EQ(panel.weights(), Eigen::VectorXd::Unit(10, cycle("old")));
}

TEST(Labels, ThePressCountsNotTheRelease) {
  PanelBench panel("labels");
  const Widget* row = panel.find("pick", "sad");
  panel.move_to(row->box.middle_x(), row->box.middle_y());
  panel.press();
  EXPECT_EQ(panel.log().size(), 1U);
}

TEST(Labels, NothingIsPickedUntilSomethingIsTouched) {
  PanelBench panel("labels");
  panel.move_to(900, 100);
  EXPECT_TRUE(panel.log().empty());
  EXPECT_EQ(panel.weights(), study::start_weights(bench::space()));
}

TEST(Labels, ArrowKeysGoThroughTheListInItsOrder) {
  PanelBench panel("labels");
  panel.key(GLFW_KEY_DOWN);
  panel.key(GLFW_KEY_DOWN);
  panel.key(GLFW_KEY_UP);
  ASSERT_EQ(panel.log().size(), 3U);
  EXPECT_EQ(panel.log()[0].target, panel.log()[2].target);
  EXPECT_LT(panel.find("pick", panel.log()[0].target)->box.y,
            panel.find("pick", panel.log()[1].target)->box.y);
}

TEST(Labels, RowsAre32PixelsAndSortedByName) {
  PanelBench panel("labels");
  const Widget* angry = panel.find("pick", "angry");
  const Widget* sad = panel.find("pick", "sad");
  EXPECT_EQ(angry->box.height, 32);
  EXPECT_LT(angry->box.y, sad->box.y);
}

TEST(Labels, ALongListScrollsToItsEnd) {
  PanelBench panel("labels", bench::long_space(55));
  const std::string last = "a_style_with_a_long_name_154";
  EXPECT_FALSE(panel.find("pick", last)->visible());
  panel.move_to(900, 300);
  for (int k = 0; k < 20; ++k) panel.wheel(-1);
  ASSERT_TRUE(panel.find("pick", last)->visible());
  panel.click("pick", last);
  EXPECT_EQ(panel.weights()(54), 1);
}

TEST(Labels, ASecondPressOffersTheRest) {
  PanelBench panel("labels");
  panel.click("pick", "old");
  panel.click("pick", "old");
  EXPECT_EQ(panel.log().back().kind, "offer");
  panel.click("mix", "old");
  panel.click("pick", "sad");
  panel.click("pick", "sad");
  panel.click("mix", "sad");
  EXPECT_EQ(panel.weights()(cycle("old")), 0.5);
  EXPECT_EQ(panel.weights()(cycle("sad")), 0.5);
}

TEST(Labels, TypingFiltersTheListFieldOrNot) {
  PanelBench panel("labels");
  panel.type("sA");
  EXPECT_EQ(panel.find("pick", "old"), nullptr);
  EXPECT_NE(panel.find("pick", "sad"), nullptr);
  panel.key(GLFW_KEY_BACKSPACE);
  panel.key(GLFW_KEY_BACKSPACE);
  panel.frame();
  EXPECT_NE(panel.find("pick", "old"), nullptr);
  panel.click("filter", "list");
  panel.type("old");
  EXPECT_EQ(panel.find("pick", "sad"), nullptr);
  EXPECT_NE(panel.find("pick", "old"), nullptr);
}

TEST(Labels, AFilterThatMatchesNothingCanBeTakenBack) {
  PanelBench panel("labels");
  panel.type("qqq");
  EXPECT_EQ(panel.find("pick", "sad"), nullptr);
  panel.key(GLFW_KEY_DOWN);
  panel.click("show_all", "list");
  panel.frame();
  EXPECT_NE(panel.find("pick", "sad"), nullptr);
  EXPECT_EQ(panel.weights(), study::start_weights(bench::space()));
}

TEST(Labels, ArrowKeysStayWithTheFilteredRows) {
  PanelBench panel("labels");
  panel.type("sad");
  panel.key(GLFW_KEY_DOWN);
  EXPECT_EQ(panel.log().back().target, "sad");
}

void tab_to(PanelBench& panel, const std::string& kind, const std::string& target) {
  for (int k = 0; k < 100 && !panel.focus().on(kind, target); ++k) panel.key(GLFW_KEY_TAB);
  ASSERT_TRUE(panel.focus().on(kind, target));
}

TEST(Labels, TheFilterTakesSpacesAndKanaThatAreTypedElsewhere) {
  PanelBench panel("labels");
  tab_to(panel, "pick", "angry");
  panel.type("a b");
  EXPECT_EQ(panel.log().back().text, "a b");
  EXPECT_TRUE(panel.focus().on("filter", "list"));
  for (const int letter : {0x304B, 0x306A}) {
    panel.push({.kind = UiEvent::Kind::character, .code = letter});
  }
  panel.frame();
  EXPECT_EQ(panel.log().back().text, "a bかな");
  for (const auto& input : panel.log()) EXPECT_EQ(input.kind, "filter");
}

TEST(Labels, TheFirstTypedLettersAreNotLostToTheField) {
  PanelBench panel("labels", bench::space(), {}, {.language = "ja"});
  for (const int letter : {0x697D, 0x3057, 0x3044}) {
    panel.push({.kind = UiEvent::Kind::character, .code = letter});
  }
  panel.frame();
  EXPECT_EQ(panel.log().back().text, "楽しい");
}

TEST(Labels, EscapeInTheFieldShowsAllAgain) {
  PanelBench panel("labels");
  panel.type("sad");
  panel.key(GLFW_KEY_ESCAPE);
  panel.frame();
  EXPECT_EQ(panel.log().back().kind, "show_all");
  EXPECT_NE(panel.find("pick", "old"), nullptr);
}

TEST(Labels, TheKeyboardGoesAlongWithTheRow) {
  PanelBench panel("labels");
  tab_to(panel, "pick", "angry");
  for (int k = 0; k < 3; ++k) panel.key(GLFW_KEY_DOWN);
  const std::string shown = panel.log().back().target;
  EXPECT_NE(shown, "angry");
  EXPECT_TRUE(panel.focus().on("pick", shown));
  EXPECT_TRUE(panel.focus().ring());
  panel.key(GLFW_KEY_ENTER);
  EXPECT_EQ(panel.log().back().kind, "offer");
  EXPECT_EQ(panel.log().back().target, shown);
}

TEST(Labels, ALongNameOfABookmarkEndsAtItsLimitOnce) {
  PanelBench panel("labels");
  panel.click("bookmark", "");
  panel.click("goto", "1");
  panel.click("edit", "1");
  panel.frame();
  panel.type(std::string(longest_bookmark_name + 5, 'x'));
  const std::size_t reports = panel.log().size();
  for (int k = 0; k < 10; ++k) panel.frame();
  EXPECT_EQ(panel.log().size(), reports);
  EXPECT_EQ(panel.log().back().text, std::string(longest_bookmark_name, 'x'));
  panel.key(GLFW_KEY_BACKSPACE);
  EXPECT_EQ(panel.log().back().text, std::string(longest_bookmark_name - 1, 'x'));
}

TEST(Labels, VariantsStandUnderTheirStyle) {
  PanelBench panel("labels", bench::long_space(20));
  const Widget* first = panel.find("pick", "a_style_with_a_long_name_100");
  EXPECT_EQ(first->box.y, panel.box().y + 8 + 36 + 4 + 32);  // field, gap, one heading
}

float way_from_angry_to_sad(const std::string& groups) {
  PanelBench panel("labels", bench::space(), {{"groups", groups}});
  return panel.find("pick", "sad")->box.y - panel.find("pick", "angry")->box.y;
}

TEST(Labels, EachLetterHasAHeadingWhenAskedTo) {
  EXPECT_GT(way_from_angry_to_sad("alphabet"), way_from_angry_to_sad("none") + 31);
}

TEST(Labels, BookmarksAreThoseOfTheMap) {
  PanelBench panel("labels");
  panel.click("pick", "old");
  panel.click("bookmark", "");
  panel.click("pick", "sad");
  panel.click("goto", "1");
  EXPECT_EQ(panel.weights(), Eigen::VectorXd::Unit(10, cycle("old")));
}

TEST(Labels, SlidersOfTheMixtureKeepTheirKeys) {
  PanelBench panel("labels");
  for (const char* name : {"sad", "old"}) {
    panel.click("pick", name);
    panel.click("pick", name);
    panel.click("mix", name);
  }
  panel.click("share", "old");
  panel.key(GLFW_KEY_END);
  EXPECT_EQ(panel.log().back().kind, "share");
  EXPECT_EQ(panel.log().back().value, 1);
}

}  // namespace
}  // namespace promenade::app
