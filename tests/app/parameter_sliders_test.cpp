#include "app/parameter_sliders.h"

#include <gtest/gtest.h>

#include "motion/models/adjectives.h"
#include "motion/models/control_maps.h"
#include "motion/models/features.h"
#include "study/study.h"
#include "tests/app/panel_bench.h"

namespace promenade::app {
namespace {

using Eigen::VectorXd;
using study::Applied;
using study::ControlInput;

class Sliders : public testing::TestWithParam<std::string> {
 protected:
  Sliders() { begin({}); }

  void begin(const study::Parameters& own) {
    parameters_ = bench::standard_parameters(type());
    for (const auto& [name, value] : own) parameters_.at(name) = value;
    model_ = bench::prepared_model(type(), bench::space(), parameters_).model;
    state_ = type().start(
        {bench::space(), parameters_, study::start_weights(bench::space()), 1, model_});
  }
  const study::InterfaceType& type() const { return *app::interfaces().find(GetParam()); }
  const SliderCatalogue& catalogue() const { return static_cast<const SliderCatalogue&>(*model_); }
  ParameterSliders& sliders() { return static_cast<ParameterSliders&>(*state_); }
  std::string name(int parameter) const {
    return catalogue().parameters[static_cast<std::size_t>(parameter)].name;
  }
  std::string cycle(int i) const {
    return bench::space().set.cycles[static_cast<std::size_t>(i)].name;
  }
  Applied apply(const std::string& kind, const std::string& target, double value = study::no_value,
                std::int64_t t_us = 0, const std::string& text = "") {
    return state_->apply(
        {.kind = kind, .target = target, .text = text, .value = value, .t_us = t_us});
  }
  VectorXd weights(std::int64_t t_us = study::settled_us) const {
    return study::weights_of(*state_, t_us);
  }
  double value(int parameter) {
    const int k = sliders().find_slider(parameter);
    return k < 0 ? NAN : sliders().sliders()[static_cast<std::size_t>(k)].value;
  }
  void go_to_example(int i) {
    for (const auto& slider : std::vector(sliders().sliders())) {
      apply("slide", name(slider.parameter), catalogue().values(slider.parameter, i));
    }
  }

  study::Parameters parameters_;
  std::shared_ptr<const study::InterfaceModel> model_;
  std::unique_ptr<study::InterfaceState> state_;
};

double difference(const VectorXd& a, const VectorXd& b) { return (a - b).cwiseAbs().maxCoeff(); }

TEST_P(Sliders, BeginWithOnePerClusterAtWhatTheAverageHas) {
  ASSERT_EQ(sliders().sliders().size(), 4U);
  const VectorXd average = catalogue().values.rowwise().mean();
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(value(k), average(k), 1e-15);
  EXPECT_EQ(weights(), study::start_weights(bench::space()));
}

TEST_P(Sliders, AtAnExamplesValuesShowThatExample) {
  for (int i = 0; i < bench::space().set.size(); ++i) {
    go_to_example(i);
    EXPECT_NEAR(weights()(i), 1, 1e-9) << cycle(i);
  }
}

TEST_P(Sliders, AtAnExamplesValuesShowItWithMoreAndOtherSlidersToo) {
  apply("add", name(5));
  apply("add", name(9));
  apply("delete", name(1));
  apply("alter", name(12), study::no_value, 0, name(2));
  ASSERT_EQ(sliders().sliders().size(), 5U);
  for (int i = 0; i < bench::space().set.size(); ++i) {
    go_to_example(i);
    EXPECT_NEAR(weights()(i), 1, 1e-9) << cycle(i);
  }
}

// The weights are those of a fit to just these rows, made here.
TEST_P(Sliders, AreFittedAnewWhenTheyChange) {
  apply("delete", name(0));
  apply("add", name(7));
  apply("slide", name(7), 0.8);
  const std::vector<int> rows = {1, 2, 3, 7};
  VectorXd at(4);
  at << value(1), value(2), value(3), 0.8;
  VectorXd expected = motion::raw_weights(motion::fit_radial_basis(catalogue().values, rows), at);
  motion::apply_rule(motion::NegativeRule::clamp, expected);
  EXPECT_LT(difference(weights(), expected), 1e-14);
}

TEST_P(Sliders, TheFirstTouchEasesFromTheStart) {
  apply("slide", name(0), 1, 5'000'000);
  const VectorXd start = study::start_weights(bench::space());
  EXPECT_LT(difference(weights(5'000'000), start), 1e-15);
  EXPECT_LT(difference(weights(4'000'000), start), 1e-15);  // never before it began
  EXPECT_EQ(weights(5'400'000), weights());
  const VectorXd half = 0.5 * (start + weights());  // smoothstep is a half at a half
  EXPECT_LT(difference(weights(5'200'000), half), 1e-15);
}

// Neither the weights nor their speed jump: of a change of at most 1 in 0.4 s smoothstep
// makes at most 1.5/0.4 a second, and at its ends 6 (t/0.4)^2 / 2.
TEST_P(Sliders, AnEaseIsSmoothAtBothEnds) {
  apply("slide", name(0), 1, 0);
  apply("add", name(6), study::no_value, 1'000'000);
  const double tiny = 3 * 0.0025 * 0.0025 + 1e-15;  // 1 ms is 1/400 of it
  EXPECT_LT(difference(weights(999'999), weights(1'001'000)), tiny);
  EXPECT_LT(difference(weights(1'399'000), weights(1'400'000)), tiny);
  for (int t = 1'000'000; t < 1'400'000; t += 10'000) {
    EXPECT_LT(difference(weights(t), weights(t + 10'000)), 1.5 / 40 + 1e-12);
  }
}

TEST_P(Sliders, AnEaseThatIsInterruptedGoesOnFromWhereItIs) {
  apply("slide", name(0), 1, 0);
  const VectorXd before = weights(150'000);
  apply("delete", name(1), study::no_value, 150'000);
  EXPECT_LT(difference(weights(150'000), before), 1e-15);
}

TEST_P(Sliders, ALaterSlideFollowsAtOnce) {
  apply("slide", name(0), 0.2, 0);
  apply("slide", name(0), 0.9, 1'000'000);
  EXPECT_EQ(weights(1'000'000), weights());
}

TEST_P(Sliders, ANewSliderStandsWhereTheShownMotionDoes) {
  go_to_example(3);
  apply("add", name(8));
  EXPECT_NEAR(value(8), catalogue().values(8, 3), 1e-9);
  EXPECT_NEAR(weights()(3), 1, 1e-9);  // and so nothing has changed
}

TEST_P(Sliders, AddingBeforeAnythingWasMovedLeavesTheStart) {
  apply("add", name(8), study::no_value, 1'000'000);
  EXPECT_EQ(weights(1'200'000), study::start_weights(bench::space()));
  EXPECT_EQ(sliders().sliders().size(), 5U);
}

TEST_P(Sliders, WithoutAnyTheStartIsShownAndTheyCanComeBack) {
  go_to_example(2);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(apply("delete", name(k)), Applied::done);
  EXPECT_EQ(weights(), study::start_weights(bench::space()));
  for (int k = 0; k < 4; ++k) EXPECT_EQ(apply("add", name(k)), Applied::done);
  go_to_example(2);
  EXPECT_NEAR(weights()(2), 1, 1e-9);
}

TEST_P(Sliders, AreTwelveAtMost) {
  for (int k = 4; k < most_sliders; ++k) ASSERT_EQ(apply("add", name(k)), Applied::done);
  EXPECT_TRUE(sliders().full());
  EXPECT_EQ(apply("add", name(most_sliders)), Applied::refused);
  EXPECT_EQ(apply("list", "add"), Applied::refused);
  EXPECT_EQ(apply("alter", name(most_sliders), study::no_value, 0, name(0)), Applied::done);
}

TEST_P(Sliders, RefuseWhatCannotBe) {
  EXPECT_EQ(apply("slide", name(0), 1.01), Applied::refused);
  EXPECT_EQ(apply("slide", name(0), NAN), Applied::refused);
  EXPECT_EQ(apply("slide", name(9), 0.5), Applied::refused);  // it has no slider
  EXPECT_EQ(apply("add", name(0)), Applied::refused);         // it has one
  EXPECT_EQ(apply("add", "nobody"), Applied::refused);
  EXPECT_EQ(apply("alter", name(9), study::no_value, 0, "nobody"), Applied::refused);
  EXPECT_EQ(apply("alter", name(1), study::no_value, 0, name(0)), Applied::refused);
  EXPECT_EQ(apply("delete", name(9)), Applied::refused);
  EXPECT_EQ(apply("weight", cycle(0), 0.5), Applied::refused);  // not draggable
  EXPECT_EQ(apply("back", "list"), Applied::refused);           // it is not open
  EXPECT_EQ(apply("show", "weights"), Applied::refused);        // they are there
}

TEST_P(Sliders, TheListAndTheWeightsAreAside) {
  EXPECT_EQ(apply("list", name(2)), Applied::aside);
  EXPECT_EQ(sliders().altered(), 2);
  EXPECT_EQ(apply("back", "list"), Applied::aside);
  EXPECT_EQ(apply("hide", "weights"), Applied::aside);
  EXPECT_EQ(apply("show", "weights"), Applied::aside);
}

// Undo comes back to a clone: the sliders, without the list over them.
TEST_P(Sliders, ACloneHasTheSlidersButNotTheList) {
  apply("slide", name(0), 0.3);
  apply("list", "add");
  const auto copy = state_->clone();
  EXPECT_EQ(static_cast<const ParameterSliders&>(*copy).list(), ParameterSliders::List::closed);
  EXPECT_EQ(study::weights_of(*copy, 100'000), weights(100'000));
}

TEST_P(Sliders, HiddenWeightsHaveNoSwitch) {
  begin({{"weights", std::string("hidden")}});
  EXPECT_FALSE(sliders().weights_visible());
  EXPECT_EQ(apply("show", "weights"), Applied::refused);
}

TEST_P(Sliders, ADraggedWeightScalesTheOthersAndTakesTheSlidersAlong) {
  begin({{"weights", std::string("draggable")}});
  go_to_example(1);
  apply("slide", name(0), 0.5);
  const VectorXd before = weights();
  ASSERT_EQ(apply("weight", cycle(4), 0.25), Applied::done);
  const double scale = 0.75 / (1 - before(4));
  for (int i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(weights()(i), i == 4 ? 0.25 : scale * before(i), 1e-14);
  }
  for (int k = 0; k < 4; ++k) {
    EXPECT_NEAR(value(k), catalogue().values.row(k).dot(weights()), 1e-14);
  }
}

TEST_P(Sliders, AWholeWeightIsTakenBackByAllOthersAlike) {
  begin({{"weights", std::string("draggable")}});
  apply("weight", cycle(4), 1);
  apply("weight", cycle(4), 0.1);
  for (int i = 0; i < 10; ++i) EXPECT_NEAR(weights()(i), 0.1, 1e-15);
}

TEST_P(Sliders, BetweenWeightsAndSlidersTheFigureEases) {
  begin({{"weights", std::string("draggable")}});
  apply("slide", name(0), 1, 0);
  const VectorXd by_sliders = weights();
  apply("weight", cycle(4), 0.9, 1'000'000);
  EXPECT_LT(difference(weights(1'000'000), by_sliders), 1e-15);
  const VectorXd by_hand = weights();
  apply("weight", cycle(4), 0.8, 2'000'000);  // the same hand: at once
  EXPECT_NEAR(weights(2'000'000)(4), 0.8, 1e-15);
  apply("weight", cycle(4), 0.9, 2'500'000);
  apply("slide", name(0), 0.5, 3'000'000);
  EXPECT_LT(difference(weights(3'000'000), by_hand), 1e-15);
  EXPECT_GT(difference(weights(3'400'000), by_hand), 1e-3);
}

TEST_P(Sliders, AWeightDraggedToAllAndBackLeavesTheOthersTheirProportions) {
  begin({{"weights", std::string("draggable")}});
  apply("slide", name(0), 1, 0);
  VectorXd before = weights();
  for (const double value : {0.8, 1.0, 0.5}) apply("weight", cycle(4), value, 1'000'000);
  before(4) = 0;
  VectorXd expected = before * (0.5 / before.sum());
  expected(4) = 0.5;
  EXPECT_LT(difference(weights(), expected), 1e-12);
}

TEST_P(Sliders, EveryRuleForNegativesSumsToOne) {
  for (const char* rule : {"clamp", "keep", "project"}) {
    begin({{"negative", std::string(rule)}});
    bool negative = false;
    study::Rng rng(1, 2, "test");
    for (int k = 0; k < 200; ++k) {
      apply("slide", name(k % 4), rng.uniform());
      ASSERT_NEAR(weights().sum(), 1, 1e-12 * (1 + weights().cwiseAbs().sum()));
      negative |= weights().minCoeff() < 0;
    }
    EXPECT_EQ(negative, std::string(rule) == "keep");
  }
}

ControlInput any_input(const SliderCatalogue& catalogue, study::Rng& rng) {
  const auto parameter = [&] { return catalogue.parameters[rng.below(20)].name; };
  const char* const kinds[] = {"slide",  "slide", "add",  "alter", "delete",
                               "weight", "list",  "back", "show",  "hide"};
  ControlInput input{.kind = kinds[rng.below(10)], .target = parameter(), .text = parameter()};
  if (input.kind == "back") input.target = "list";
  if (input.kind == "show" || input.kind == "hide") input.target = "weights";
  if (input.kind == "weight") input.target = bench::space().set.cycles[rng.below(10)].name;
  input.value = rng.below(20) == 0 ? NAN : rng.uniform();
  return input;
}

TEST_P(Sliders, TenThousandInputsOfEveryKindLeaveWeightsThatSumToOne) {
  begin({{"weights", std::string("draggable")}, {"negative", std::string("keep")}});
  study::Rng rng(3, 4, "test");
  for (int k = 0; k < 10'000; ++k) {
    ControlInput input = any_input(catalogue(), rng);
    input.t_us = 100'000 * k;
    const VectorXd before = weights(input.t_us);
    const Applied applied = state_->apply(input);
    const VectorXd after = weights(input.t_us);
    ASSERT_TRUE(after.allFinite());
    ASSERT_NEAR(after.sum(), 1, 1e-11 * (1 + after.cwiseAbs().sum())) << k << input.kind;
    ASSERT_TRUE(applied == Applied::done || after == before) << k;
  }
}

TEST_P(Sliders, WeightOfOneExampleIsThatOfAll) {
  apply("slide", name(0), 1, 0);
  for (const std::int64_t t : {-5, 0, 123'456, 400'000, 9'000'000}) {
    for (int i = 0; i < 10; ++i) EXPECT_NEAR(sliders().weight_at(t, i), weights(t)(i), 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(Interfaces, Sliders, testing::Values("adjectives", "features"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace promenade::app
