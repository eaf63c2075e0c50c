// What every interface owes the program, also those of the future: nothing here
// names one.
#include "app/registry.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <set>

#include "study/load_study.h"
#include "study/rng.h"
#include "tests/app/odd_inputs.h"
#include "tests/app/panel_bench.h"
#include "tests/motion/allocations.h"

namespace promenade::app {
namespace {

using study::ControlInput;
using study::InterfaceState;
using study::InterfaceType;
using study::Rng;

class EveryInterface : public testing::TestWithParam<std::string> {
 protected:
  const InterfaceType& type() const { return *interfaces().find(GetParam()); }
  std::unique_ptr<InterfaceState> start() const {
    return type().start({bench::space(), parameters_, study::start_weights(bench::space()), 7,
                         bench::prepared_model(type(), bench::space(), parameters_).model});
  }

 private:
  study::Parameters parameters_ = bench::standard_parameters(*interfaces().find(GetParam()));
};

TEST_P(EveryInterface, WeightsAreFiniteAndSumToOneWhateverIsDone) {
  const std::unique_ptr<InterfaceState> state = start();
  Rng rng(1, 2, "test");
  for (int k = 0; k < 20'000; ++k) {
    state->apply(bench::any_input(type(), *state, rng));
    const Eigen::VectorXd weights = study::weights_of(*state, 1000 * k);
    ASSERT_TRUE(weights.allFinite()) << k;
    ASSERT_EQ(weights.size(), bench::space().set.size());
    // Ten numbers near 1 summed: a few units in the last place of each.
    ASSERT_NEAR(weights.sum(), 1, 1e-12 * (1 + weights.cwiseAbs().sum())) << k;
  }
}

TEST_P(EveryInterface, WhatIsRefusedChangesNothing) {
  const std::unique_ptr<InterfaceState> state = start();
  Rng rng(3, 4, "test");
  for (int k = 0; k < 1000; ++k) {
    const Eigen::VectorXd before = study::weights_of(*state, 0);
    const study::Applied applied = state->apply(bench::likely_input(type(), *state, rng));
    const bool done = applied == study::Applied::done;
    ASSERT_TRUE(done || study::weights_of(*state, 0) == before) << k;
  }
}

TEST_P(EveryInterface, ItsOwnProposalsAreAccepted) {
  const std::unique_ptr<InterfaceState> state = start();
  Rng rng(5, 6, "test");
  for (int k = 0; k < 300; ++k) {
    const std::vector<ControlInput> ideas = type().simulate(*state, rng);
    ASSERT_FALSE(ideas.empty());
    for (const ControlInput& idea : ideas) {
      ASSERT_NE(state->clone()->apply(idea), study::Applied::refused) << idea.target;
    }
    state->apply(ideas.front());
  }
}

// Ten thousand things done at random times: whoever does them again meets the same
// weights, to the bit, at every time and between them.
TEST_P(EveryInterface, TheSameInputsLeadToTheSameWeights) {
  const std::unique_ptr<InterfaceState> one = start();
  const std::unique_ptr<InterfaceState> two = start();
  Rng rng(13, 14, "test");
  std::int64_t t_us = 0;
  for (int k = 0; k < 10'000; ++k) {
    ControlInput input = bench::any_input(type(), *one, rng);
    input.t_us = t_us += static_cast<std::int64_t>(rng.below(300'000));
    // Frames in between ask the one for its weights and not the other.
    if (k % 3 == 0) study::weights_of(*one, t_us - 1);
    ASSERT_EQ(one->apply(input), two->apply(input)) << k;
    const std::int64_t later = t_us + static_cast<std::int64_t>(rng.below(200'000));
    ASSERT_EQ(study::weights_of(*one, later), study::weights_of(*two, later)) << k;
  }
}

TEST_P(EveryInterface, SettingsAreInputsThatItTakes) {
  const std::unique_ptr<InterfaceState> state = start();
  for (const ControlInput& setting : state->settings()) {
    EXPECT_NE(state->clone()->apply(setting), study::Applied::refused) << setting.target;
  }
}

TEST_P(EveryInterface, AFrameInWhichNothingIsDoneAllocatesNothing) {
#if PROMENADE_COUNTS_ALLOCATIONS
  bench::PanelBench panel(GetParam());
  Rng rng(15, 16, "test");
  for (const ControlInput& idea : type().simulate(panel.state(), rng)) panel.state().apply(idea);
  for (int k = 0; k < 120; ++k) panel.frame();  // buffers grow, what glides arrives
  const long before = motion::allocations();
  panel.frame();
  EXPECT_EQ(motion::allocations(), before);
#else
  GTEST_SKIP() << "the sanitizer brings its own malloc";
#endif
}

TEST_P(EveryInterface, TheKeyboardReachesEveryProposal) {
  bench::PanelBench panel(GetParam());
  Rng rng(17, 18, "test");
  for (const ControlInput& idea : type().simulate(panel.state(), rng)) {
    // Dots on a plane are reached by moving over the plane.
    if (!panel.find(idea.kind, idea.target)->stop) continue;
    bool reached = false;
    for (int k = 0; k < 400 && !reached; ++k) {
      panel.key(GLFW_KEY_TAB);
      reached = panel.focus().on(idea.kind, idea.target);
    }
    EXPECT_TRUE(reached) << idea.kind << " " << idea.target;
    EXPECT_TRUE(panel.find(idea.kind, idea.target)->visible()) << idea.target;
  }
}

TEST_P(EveryInterface, AClonesChangesAreItsOwn) {
  const std::unique_ptr<InterfaceState> state = start();
  Rng rng(7, 8, "test");
  const Eigen::VectorXd before = study::weights_of(*state, 0);
  for (const ControlInput& idea : type().simulate(*state, rng)) state->clone()->apply(idea);
  EXPECT_EQ(study::weights_of(*state, 0), before);
}

TEST_P(EveryInterface, DrawingReportsAPlaceForEveryProposal) {
  bench::PanelBench panel(GetParam());
  Rng rng(9, 10, "test");
  for (int k = 0; k < 100; ++k) {
    for (const ControlInput& idea : type().simulate(panel.state(), rng)) {
      const Widget* widget = panel.find(idea.kind, idea.target);
      ASSERT_NE(widget, nullptr) << idea.kind << " " << idea.target;
      EXPECT_GE(widget->box.height, 28);
    }
  }
}

TEST_P(EveryInterface, DrawsInsideItsPanel) {
  bench::PanelBench panel(GetParam());
  const Box box = panel.box();
  Rng rng(11, 12, "test");
  for (const ControlInput& idea : type().simulate(panel.state(), rng)) {
    const Box at = panel.find(idea.kind, idea.target)->box;
    EXPECT_TRUE(at.x >= box.x && at.right() <= box.right()) << idea.target;
  }
}

TEST_P(EveryInterface, LookingAtItChangesNothing) {
  bench::PanelBench panel(GetParam());
  for (int k = 0; k < 40; ++k) panel.move_to(850 + 10 * k, 70 + 14 * k);
  EXPECT_TRUE(panel.log().empty());
}

TEST_P(EveryInterface, ItsTextsAreThereInEveryLanguage) {
  for (const std::string& language : study::known_languages()) {
    const std::vector<std::string> keys = study::load_texts(language).keys();
    const std::set<std::string> known(keys.begin(), keys.end());
    for (const std::string& key : type().texts) EXPECT_TRUE(known.count(key)) << language << key;
    // The instructions say what it is and how it is used.
    for (const char* part : {".title", ".hint", ".practice"}) {
      EXPECT_TRUE(known.count("interface." + GetParam() + part)) << language << part;
    }
  }
}

TEST(BlindTask, RefusesPanelsThatShowTheFigure) {
  const std::string text =
      "[study]\nname = 'b'\n[[interface]]\nname = 'gallery'\n[[interface]]\nname = 'labels'\n"
      "[[task]]\nname = 'guess'\nkind = 'match'\nblind = true\ntargets = [{example = 'proud'}]\n";
  try {
    study::read_study("b.toml", text, interfaces(), study::load_motion_set);
    FAIL() << "the gallery shows what is hidden";
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), 1U);
    EXPECT_EQ(error.problems()[0].line, 10);
    EXPECT_NE(error.problems()[0].message.find("gallery"), std::string::npos);
  }
}

TEST(Parameters, OutOfRangeAreProblemsWithTheirPlace) {
  const std::string text =
      "[study]\nname = 'b'\n[[interface]]\nname = 'map'\nnearest = 0\nglide_s = -1\n"
      "components = 2.5\n[[task]]\nname = 'copy'\nkind = 'match'\n"
      "targets = [{example = 'proud'}]\n";
  try {
    study::read_study("b.toml", text, interfaces(), study::load_motion_set);
    FAIL() << "none of these can be used";
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), 3U);
    for (const Problem& problem : error.problems()) EXPECT_GE(problem.line, 5);
  }
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const InterfaceType& type : interfaces().all()) names.push_back(type.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryInterface, testing::ValuesIn(all_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace promenade::app
