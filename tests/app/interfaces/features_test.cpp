#include "motion/models/features.h"

#include <gtest/gtest.h>

#include "app/parameter_sliders_view.h"
#include "motion/builtin.h"
#include "motion/models/adjectives.h"
#include "tests/app/panel_bench.h"

namespace promenade::app {
namespace {

using bench::PanelBench;

const SliderCatalogue& catalogue(PanelBench& panel) {
  return static_cast<const ParameterSliders&>(panel.state()).catalogue();
}

TEST(Features, OfferTheFourClustersAndThe51Features) {
  PanelBench panel("features");
  EXPECT_EQ(catalogue(panel).primary, 4);
  EXPECT_EQ(catalogue(panel).parameters.size(), 4U + motion::feature_count);
}

// A slider at an example's value says what motion_features says of it.
TEST(Features, ValuesAreThoseOfTheMotionInItsUnit) {
  PanelBench panel("features");
  const Eigen::MatrixXd features = motion::motion_features(bench::space().set);
  for (int k = 0; k < motion::feature_count; ++k) {
    const int row = catalogue(panel).primary + k;
    const SliderParameter& parameter = catalogue(panel).parameters[static_cast<std::size_t>(row)];
    const double scale = parameter.unit == "cm" ? 100 : 1;
    for (int i = 0; i < bench::space().set.size(); ++i) {
      EXPECT_NEAR(in_unit(parameter, catalogue(panel).values(row, i)), scale * features(k, i),
                  1e-12 * (1 + std::abs(scale * features(k, i))));
    }
  }
}

// A slider called "step length" makes longer steps on its way to the right, and so on.
TEST(Features, ASliderDoesWhatItsNameSays) {
  for (const char* set : {"A", "B"}) {
    const motion::MotionSpace space = motion::make_motion_space(*motion::builtin_set(set));
    const Eigen::MatrixXd features = motion::motion_features(space.set);
    PanelBench panel("features", space);
    for (int c = 0; c < 4; ++c) {
      const std::string& name = catalogue(panel).parameters[static_cast<std::size_t>(c)].name;
      const bool own = name.rfind("cluster:", 0) == 0;
      const std::string feature = own                             ? name.substr(8)
                                  : name == "step length"         ? "v_step-length_front-back"
                                  : name.rfind("bending", 0) == 0 ? "mu_torso_front-back"
                                  : name.rfind("lateral", 0) == 0 ? "sigma_torso_left-right"
                                                                  : "sigma_left-forearm_front-back";
      const Eigen::VectorXd wanted = features.row(motion::find_feature(feature));
      EXPECT_GT(motion::correlation(catalogue(panel).values.row(c), wanted), 0.5) << set << name;
    }
  }
}

SliderParameter from_to(const char* unit, double lowest, double highest) {
  SliderParameter parameter;
  parameter.unit = unit;
  parameter.lowest = lowest;
  parameter.highest = highest;
  return parameter;
}

TEST(Features, ValuesAreWrittenWithTheirUnit) {
  EXPECT_EQ(value_text(from_to("deg", 0, 24), 0.5).view(), "12°");
  EXPECT_EQ(value_text(from_to("deg", 0, 9), 0.5).view(), "4.5°");
  EXPECT_EQ(value_text(from_to("m", 0.6, 0.68), 0.5).view(), "0.64 m");
  EXPECT_EQ(value_text(from_to("s", 1.02, 2), 0).view(), "1.02 s");
  EXPECT_EQ(value_text(from_to("cm", -5, 5), 0).view(), "-5.0 cm");
  EXPECT_EQ(value_text(from_to("deg", -0.4, 20), 0).view(), "0°");  // no "-0°"
}

TEST(Features, EachHasAPictogramOfItsPartAndDirection) {
  for (const std::string_view name : motion::feature_names()) {
    const Pictogram pictogram = feature_pictogram(name);
    EXPECT_NE(pictogram.parts, 0U) << name;
    const bool across = name.find("left-right") != std::string_view::npos;
    EXPECT_EQ(pictogram.view == Pictogram::View::back, across) << name;
  }
  EXPECT_EQ(feature_pictogram("sigma_left-forearm_front-back").parts, Pictogram::left_forearm);
  EXPECT_EQ(feature_pictogram("mu_head_left-right").view, Pictogram::View::back);
  EXPECT_EQ(feature_pictogram("v_motion-duration").parts, Pictogram::clock);
}

TEST(Features, SlidersAre72PixelsApart) {
  PanelBench panel("features");
  const auto y = [&](std::size_t k) {
    return panel.find("slide", catalogue(panel).parameters[k].name)->box.y;
  };
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(y(k + 1) - y(k), 72);
}

TEST(Features, AnAddedFeatureIsDragged) {
  PanelBench panel("features");
  panel.click("list", "add");
  panel.frame();
  panel.click("add", "sigma_torso_left-right");
  panel.frame();
  panel.drag("sigma_torso_left-right", 1);
  EXPECT_EQ(panel.log().back().target, "sigma_torso_left-right");
  EXPECT_EQ(panel.log().back().value, 1);
}

TEST(Features, FiftyFiveExamplesScrollBesideTheSliders) {
  PanelBench panel("features", bench::long_space(55), {{"weights", std::string("draggable")}});
  const std::string last = "a_style_with_a_long_name_154";
  EXPECT_FALSE(panel.find("weight", last)->visible());
  panel.move_to(1200, 300);
  for (int k = 0; k < 40; ++k) panel.wheel(-1);
  EXPECT_TRUE(panel.find("weight", last)->visible());
}

TEST(Features, AMotionAloneHasNoRange) {
  motion::MotionSet one = bench::space().set;
  one.cycles.resize(1);
  const motion::MotionSpace space = motion::make_motion_space(one);
  const study::InterfaceType& type = *interfaces().find("features");
  const auto prepared = bench::prepared_model(type, space, bench::standard_parameters(type));
  EXPECT_EQ(prepared.model, nullptr);
  EXPECT_FALSE(prepared.problem.empty());
}

}  // namespace
}  // namespace promenade::app
