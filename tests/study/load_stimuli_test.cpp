// [[stimulus]] of a study file, and how it comes through packs and databases.
#include <gtest/gtest.h>

#include "folder.h"
#include "study/outline.h"
#include "study/pack.h"
#include "study/stimulus.h"
#include "study/store.h"
#include "study/stored_study.h"
#include "toy_stimuli.h"

namespace promenade::study {
namespace {

using toy::head_text;
using toy::rate_text;
using toy::stimulus_bundle;
using toy::stimulus_text;

std::string problems_of(const std::string& text, const std::string& graph = "") {
  return message_of([&] {
    graph.empty() ? stimulus_bundle(head_text + text) : stimulus_bundle(head_text + text, graph);
  });
}

std::string with(const std::string& old, const std::string& other) {
  std::string text = stimulus_text + rate_text;
  EXPECT_NE(text.find(old), std::string::npos) << old;
  return text.replace(text.find(old), old.size(), other);
}

TEST(Stimuli, StandBesideTheWalksOfTheSetAndShowTheirParts) {
  const StudyBundle bundle = stimulus_bundle();
  ASSERT_EQ(bundle.study.stimuli.size(), 1U);
  const Stimulus& stimulus = *bundle.study.stimuli[0];
  const Target& target = bundle.study.tasks[0].targets[1];
  EXPECT_EQ(target.name, "near_then_far");
  EXPECT_EQ(target.stimulus.get(), &stimulus);
  EXPECT_FALSE(target.weights);
  ASSERT_EQ(stimulus.labels.size(), 2U);
  EXPECT_EQ(stimulus.labels[0].label, "near");
  EXPECT_EQ(stimulus.labels[1].label, "far");
  // Within a quarter, as walks are found.
  EXPECT_NEAR(stimulus.labels[0].to * 0.1, 3, 0.75);
  EXPECT_NEAR(stimulus.seconds(), 5, 1.25);
}

TEST(Stimuli, AreTheSameEachTime) {
  EXPECT_EQ(stimulus_bundle().study.stimuli[0]->edges, stimulus_bundle().study.stimuli[0]->edges);
  EXPECT_EQ(stimulus_bundle().sha256, stimulus_bundle().sha256);
}

TEST(Stimuli, ArePartOfTheHashAsTheyWereFound) {
  StudyBundle bundle = stimulus_bundle();
  auto other = std::make_shared<Stimulus>(*bundle.study.stimuli[0]);
  other->edges.pop_back();
  bundle.study.stimuli[0] = other;
  EXPECT_NE(study_hash(bundle, toy::registry()), bundle.sha256);
}

struct BadStimulus {
  std::string name, old, other, message;
};

class BadStimuli : public testing::TestWithParam<BadStimulus> {};

TEST_P(BadStimuli, AreRefusedAtTheirPlace) {
  const std::string problems = problems_of(with(GetParam().old, GetParam().other));
  EXPECT_NE(problems.find(GetParam().message), std::string::npos) << problems;
}

INSTANTIATE_TEST_SUITE_P(
    Study, BadStimuli,
    testing::Values(
        BadStimulus{"Label", "label = 'far'", "label = 'fra'",
                    "toy.toml:8:53: error: the motion graph \"walks.graph\" has no label "
                    "\"fra\"; did you mean \"far\"?"},
        BadStimulus{"NoGraph", "graph = 'walks.graph'\n", "", "\"graph\" is missing"},
        BadStimulus{"OtherGraph", "walks.graph", "gone.graph",
                    "cannot use the motion graph \"gone.graph\""},
        BadStimulus{"NameOfAWalk", "name = 'near_then_far'", "name = 'far'",
                    "the motion set has a walk \"far\""},
        BadStimulus{"NoParts",
                    "parts = [{ label = 'near', seconds = 3 }, { label = 'far', "
                    "seconds = 2 }]\n",
                    "", "a stimulus needs \"parts\""},
        BadStimulus{"EmptyParts",
                    "[{ label = 'near', seconds = 3 }, { label = 'far', seconds = 2 }]", "[]",
                    "\"parts\" must not be empty"},
        BadStimulus{"NoSeconds", ", seconds = 2", "", "\"seconds\" is missing"},
        BadStimulus{"Unreachable", "'near', seconds = 3 }, { label = 'far'",
                    "'far', seconds = 3 }, { label = 'near'", "toy.toml:8"},
        BadStimulus{"UnknownTarget", "stimulus = 'near_then_far' }", "stimulus = 'near_than_far' }",
                    "there is no [[stimulus]] with the name \"near_than_far\"; did you mean "
                    "\"near_then_far\"?"},
        BadStimulus{"OtherKind", "kind = 'rate'\ninstrument = 'impression'", "kind = 'match'",
                    "a stimulus is no mixture of the walks of the set"},
        BadStimulus{"UnknownKey", "seconds = 2 }]", "seconds = 2 }]\nseeds = 3",
                    "did you mean \"seed\"?"}),
    [](const auto& test) { return test.param.name; });

TEST(Stimuli, HaveAllTheirProblemsSaidAtOnce) {
  const std::string problems =
      problems_of(with("label = 'near', seconds = 3", "label = 'nera', seconds = -1") +
                  "[[stimulus]]\nname = 'near_then_far'\ngraph = 'gone.graph'\n");
  for (const char* said : {"no label \"nera\"", "seconds", "gone.graph", "needs \"parts\"",
                           "near_then_far\" before"}) {
    EXPECT_NE(problems.find(said), std::string::npos) << said << " in " << problems;
  }
}

TEST(Stimuli, NeedAWholeGraph) {
  const std::string bytes = motion::to_bytes(toy::walks_graph());
  const std::string problems =
      problems_of(stimulus_text + rate_text, bytes.substr(0, bytes.size() - 1));
  EXPECT_NE(problems.find("toy.toml:7:9: error: cannot use the motion graph \"walks.graph\""),
            std::string::npos)
      << problems;
}

TEST(Stimuli, AreWarnedOfWhereNobodySeesThemOrTheirFigureIsAnother) {
  const StudyBundle bundle =
      stimulus_bundle(head_text + stimulus_text + rate_text +
                      "[[stimulus]]\nname = 'alone'\ngraph = 'walks.graph'\nparts = [{label = "
                      "'far', seconds = 2.5}]");
  ASSERT_EQ(bundle.warnings.size(), 2U);
  EXPECT_NE(bundle.warnings[0].message.find("has other bones"), std::string::npos);
  EXPECT_EQ(bundle.warnings[1].message, "no task shows the stimulus \"alone\"");
}

TEST(Stimuli, AreWarnedOfWhereTheGraphHasNoWalkOfThatLength) {
  const StudyBundle bundle =
      stimulus_bundle(head_text + with("'far', seconds = 2", "'far', seconds = 1.5"));
  const auto about_far = [](const Problem& one) {
    return one.message.starts_with("\"far\" is seen for ") && one.line == 8;
  };
  EXPECT_EQ(std::count_if(bundle.warnings.begin(), bundle.warnings.end(), about_far), 1);
}

TEST(Stimuli, AreInTheOutlineOfTheirStudy) {
  const Outline outline = outline_of(head_text + stimulus_text + rate_text);
  EXPECT_EQ(outline.stimuli, std::vector<std::string>{"near_then_far"});
  EXPECT_EQ(outline.targets, (std::vector<std::string>{"side", "near_then_far"}));
}

TEST(Stimuli, ComeOutOfAPackAsTheyWere) {
  const StudyBundle bundle = stimulus_bundle();
  const StudyBundle unpacked = unpack_study(to_bytes(pack_of(bundle)), "x.study", toy::registry());
  EXPECT_EQ(unpacked.sha256, bundle.sha256);
  EXPECT_EQ(to_bytes(pack_of(unpacked)), to_bytes(pack_of(bundle)));
  EXPECT_EQ(unpacked.study.stimuli[0]->edges, bundle.study.stimuli[0]->edges);
  EXPECT_EQ(unpacked.study.stimuli[0]->take.poses.back().root,
            bundle.study.stimuli[0]->take.poses.back().root);
}

class StoredStimuli : public FolderTest {};

TEST_F(StoredStimuli, ComeOutOfADatabaseByteForByte) {
  const StudyBundle bundle = stimulus_bundle();
  { Store store(file(), bundle); }
  Database database(file(), Database::Mode::read_only);
  const auto stored = read_newest_study(database, toy::registry());
  ASSERT_TRUE(stored);
  ASSERT_EQ(stored->parts.size(), bundle.parts.size());
  for (std::size_t i = 0; i < bundle.parts.size(); ++i) {
    EXPECT_EQ(stored->parts[i].path, bundle.parts[i].path);
    EXPECT_EQ(stored->parts[i].content, bundle.parts[i].content);
  }
  EXPECT_EQ(study_hash(*stored, toy::registry()), bundle.sha256);
  EXPECT_EQ(stored->study.tasks[0].targets[1].stimulus->edges, bundle.study.stimuli[0]->edges);
}

}  // namespace
}  // namespace promenade::study
