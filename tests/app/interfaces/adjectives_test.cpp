#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "app/parameter_sliders.h"
#include "study/adjective_model.h"
#include "tests/app/panel_bench.h"

namespace promenade::app {
namespace {

using bench::PanelBench;

const SliderCatalogue& catalogue(PanelBench& panel) {
  return static_cast<const ParameterSliders&>(panel.state()).catalogue();
}

const study::AdjectiveModel& ratings() {
  static const study::AdjectiveModel model = *study::builtin_adjective_model("A");
  return model;
}

std::vector<std::string> shown(PanelBench& panel) {
  std::vector<std::string> names;
  for (const auto& slider : static_cast<const ParameterSliders&>(panel.state()).sliders()) {
    names.push_back(catalogue(panel).parameters[static_cast<std::size_t>(slider.parameter)].name);
  }
  return names;
}

TEST(Adjectives, FourSlidersStand72PixelsApartWithKnobsOf28) {
  PanelBench panel("adjectives");
  const std::vector<std::string> names = shown(panel);
  EXPECT_EQ(names, ratings().names);
  for (std::size_t k = 0; k + 1 < names.size(); ++k) {
    EXPECT_EQ(panel.find("slide", names[k + 1])->box.y - panel.find("slide", names[k])->box.y, 72);
    EXPECT_EQ(panel.find("slide", names[k])->box.height, 28);
  }
}

TEST(Adjectives, TheMostAlikePairGivesAClusterItsWords) {
  PanelBench panel("adjectives");
  const motion::Quantification& q = ratings().quantification;
  for (std::size_t c = 0; c < ratings().names.size(); ++c) {
    const SliderParameter& primary = catalogue(panel).parameters[c];
    const std::string pair = primary.low.fallback + "-" + primary.high.fallback;
    const auto& kept = ratings().kept_pairs;
    const auto at = std::find(kept.begin(), kept.end(), pair) - kept.begin();
    ASSERT_LT(at, static_cast<std::ptrdiff_t>(kept.size())) << pair;
    EXPECT_EQ(q.cluster[static_cast<std::size_t>(at)], static_cast<int>(c));
  }
}

TEST(Adjectives, TheListHasTheMainSlidersThenThePairsThatPeopleAgreeOn) {
  PanelBench panel("adjectives");
  const auto& parameters = catalogue(panel).parameters;
  const std::size_t primary = ratings().names.size();
  ASSERT_EQ(parameters.size(), primary + 41);
  for (std::size_t k = 0; k < ratings().kept_pairs.size(); ++k) {
    EXPECT_EQ(parameters[primary + k].name, ratings().kept_pairs[k]);
  }
}

TEST(Adjectives, APairStandsWhereItsRatingsAre) {
  PanelBench panel("adjectives");
  const int row = find_parameter(catalogue(panel), "slow-fast");
  const Eigen::VectorXd expected =
      (ratings().quantification.mean.row(0).transpose().array() + 2) / 4;
  EXPECT_LT((catalogue(panel).values.row(row).transpose() - expected).norm(), 1e-15);
}

TEST(Adjectives, ADragIsFollowed) {
  PanelBench panel("adjectives");
  const std::string name = shown(panel)[0];
  panel.drag(name, 1);
  EXPECT_EQ(panel.log().back().kind, "slide");
  EXPECT_EQ(panel.log().back().target, name);
  EXPECT_EQ(panel.log().back().value, 1);
  EXPECT_GT((panel.weights() - study::start_weights(bench::space())).norm(), 1e-3);
}

TEST(Adjectives, AddOpensTheListAndARowAddsASlider) {
  PanelBench panel("adjectives");
  panel.click("list", "add");
  panel.frame();
  EXPECT_EQ(panel.find("slide", shown(panel)[0]), nullptr);
  ASSERT_NE(panel.find("add", "dull-quick"), nullptr);
  EXPECT_EQ(panel.find("add", "dull-quick")->box.height, 32);
  EXPECT_EQ(panel.find("add", shown(panel)[0]), nullptr);  // it is there already
  panel.click("add", "dull-quick");
  panel.frame();
  EXPECT_EQ(shown(panel).back(), "dull-quick");
  ASSERT_NE(panel.find("slide", "dull-quick"), nullptr);
}

TEST(Adjectives, TheLastRowOfTheListIsReachedByScrolling) {
  PanelBench panel("adjectives");
  panel.click("list", "add");
  panel.frame();
  const std::string last = catalogue(panel).parameters.back().name;
  EXPECT_FALSE(panel.find("add", last)->visible());
  panel.move_to(1000, 400);
  for (int k = 0; k < 30; ++k) panel.wheel(-1);
  ASSERT_TRUE(panel.find("add", last)->visible());
  panel.click("add", last);
  EXPECT_EQ(shown(panel).back(), last);
}

TEST(Adjectives, ANameOpensTheListToAlterItsSlider) {
  PanelBench panel("adjectives");
  const std::string first = shown(panel)[0];
  panel.click("list", first);
  panel.frame();
  panel.click("alter", "mild-violent");
  EXPECT_EQ(panel.log().back().text, first);
  EXPECT_EQ(shown(panel)[0], "mild-violent");
  EXPECT_EQ(shown(panel).size(), 4U);
}

TEST(Adjectives, BackAndTheSlidersOwnRowLeaveTheListAsItWas) {
  PanelBench panel("adjectives");
  const std::vector<std::string> before = shown(panel);
  panel.click("list", before[1]);
  panel.frame();
  panel.click("alter", before[1]);
  panel.frame();
  panel.click("list", "add");
  panel.frame();
  panel.click("back", "list");
  panel.frame();
  EXPECT_EQ(shown(panel), before);
  EXPECT_NE(panel.find("slide", before[0]), nullptr);
}

TEST(Adjectives, TheKeyboardOpensTheListAndChoosesFromIt) {
  PanelBench panel("adjectives");
  for (int k = 0; k < 40 && (panel.log().empty() || panel.log().back().kind != "list"); ++k) {
    panel.key(GLFW_KEY_TAB);
    if (k == 0) panel.key(GLFW_KEY_ENTER);
  }
  ASSERT_EQ(panel.log().back().kind, "list");  // the name of the first slider
  panel.frame();
  panel.key(GLFW_KEY_TAB);  // back
  panel.key(GLFW_KEY_TAB);
  panel.key(GLFW_KEY_TAB);
  panel.key(GLFW_KEY_SPACE);
  EXPECT_EQ(panel.log().back().kind, "alter");
}

TEST(Adjectives, ArrowKeysMoveASlider) {
  PanelBench panel("adjectives");
  const std::string name = shown(panel)[0];
  panel.key(GLFW_KEY_TAB);  // its name
  panel.key(GLFW_KEY_TAB);
  panel.key(GLFW_KEY_END);
  ASSERT_FALSE(panel.log().empty());
  EXPECT_EQ(panel.log().back().target, name);
  EXPECT_EQ(panel.log().back().value, 1);
}

TEST(Adjectives, CloseTakesASliderAwayAndWithoutAnyThePanelSaysSo) {
  PanelBench panel("adjectives");
  for (const std::string& name : shown(panel)) {
    panel.click("delete", name);
    panel.frame();
  }
  EXPECT_TRUE(shown(panel).empty());
  EXPECT_NE(panel.find("list", "add"), nullptr);
  EXPECT_EQ(panel.weights(), study::start_weights(bench::space()));
}

TEST(Adjectives, TwelveSlidersScrollAndTheNewestComesIntoSight) {
  PanelBench panel("adjectives");
  const auto& parameters = catalogue(panel).parameters;
  for (std::size_t k = 4; k < most_sliders; ++k) {
    panel.state().apply({.kind = "add", .target = parameters[k].name});
  }
  for (int k = 0; k < 3; ++k) panel.frame();
  EXPECT_TRUE(panel.find("slide", parameters[most_sliders - 1].name)->visible());
  EXPECT_FALSE(panel.find("slide", parameters[0].name)->visible());
  EXPECT_EQ(panel.find("list", "add"), nullptr);
}

TEST(Adjectives, TheWeightsCanBeHiddenAndShown) {
  PanelBench panel("adjectives");
  const float narrow = panel.find("slide", shown(panel)[0])->box.width;
  panel.click("hide", "weights");
  panel.frame();
  EXPECT_GT(panel.find("slide", shown(panel)[0])->box.width, narrow + 100);
  panel.click("show", "weights");
  panel.frame();
  EXPECT_EQ(panel.find("slide", shown(panel)[0])->box.width, narrow);
}

TEST(Adjectives, HiddenWeightsHaveNoSwitch) {
  PanelBench panel("adjectives", bench::space(), {{"weights", std::string("hidden")}});
  EXPECT_EQ(panel.find("show", "weights"), nullptr);
  EXPECT_EQ(panel.find("hide", "weights"), nullptr);
}

TEST(Adjectives, AWeightIsDraggedWhereTheStudyAllowsIt) {
  PanelBench panel("adjectives", bench::space(), {{"weights", std::string("draggable")}});
  panel.drag("old", 0.75, 5, "weight");
  for (int k = 0; k < 30; ++k) panel.frame();  // half a second: it has eased over
  const int old = motion::find_cycle(bench::space().set, "old");
  const double pixel = 1 / panel.find("weight", "old")->box.width;  // the mouse is on whole ones
  EXPECT_NEAR(panel.weights()(old), 0.75, pixel);
  EXPECT_NEAR(panel.weights().sum(), 1, 1e-14);
}

TEST(Adjectives, WeightsThatAreOnlyShownAreNoControls) {
  PanelBench panel("adjectives");
  EXPECT_EQ(panel.find("weight", "old"), nullptr);
}

TEST(Adjectives, HoldingTheMouseStillReportsNothing) {
  PanelBench panel("adjectives", bench::space(), {{"weights", std::string("draggable")}});
  const Box bar = panel.find("weight", "old")->box;
  panel.move_to(bar.x + 0.8 * bar.width, bar.middle_y());
  panel.press();
  for (int k = 0; k < 30; ++k) panel.frame();
  EXPECT_EQ(panel.log().size(), 1U);
}

TEST(Adjectives, NobodyHasRatedAForeignSet) {
  const study::InterfaceType& type = *interfaces().find("adjectives");
  const study::PreparedModel prepared =
      bench::prepared_model(type, bench::long_space(12), bench::standard_parameters(type));
  EXPECT_EQ(prepared.model, nullptr);
  EXPECT_NE(prepared.problem.find("nobody has rated"), std::string::npos);
}

// What is prepared of another model than that of the simulated raters.
std::shared_ptr<const SliderCatalogue> catalogue_of(const study::AdjectiveModel& model) {
  const study::InterfaceType& type = *interfaces().find("adjectives");
  const auto shared = std::make_shared<const study::AdjectiveModel>(model);
  const study::PreparedModel prepared = type.prepare({bench::space(), [&shared] { return shared; }},
                                                     bench::standard_parameters(type));
  EXPECT_EQ(prepared.problem, "");
  return std::static_pointer_cast<const SliderCatalogue>(prepared.model);
}

TEST(Adjectives, HaveTheNamesAndWordsOfTheirModel) {
  std::vector<study::PrimaryWords> words = words_of(ratings());
  words[0] = {{{"en", "haste"}, {"ja", "急ぎ足"}}, {{"en", "late"}}, {{"en", "soon"}}};
  const auto catalogue = catalogue_of(named(ratings(), words));
  const SliderParameter& first = catalogue->parameters[0];
  EXPECT_EQ(first.name, "haste") << "in the log";
  EXPECT_EQ(first.title.own.at("ja"), "急ぎ足");
  EXPECT_EQ(first.low.own.at("en"), "late");
  EXPECT_EQ(first.high.fallback, "soon");
  const SliderParameter& second = catalogue->parameters[1];
  EXPECT_EQ(second.title.key, "cluster." + ratings().names[1]) << "the program's own Japanese";
  EXPECT_EQ(second.title.own.count("ja"), 0U);
  EXPECT_EQ(catalogue->values.row(0), ratings().quantification.primary.row(0));
}

}  // namespace
}  // namespace promenade::app
