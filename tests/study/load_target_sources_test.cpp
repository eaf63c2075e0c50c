// { random = ... }, { file = ... } and deal = ... of a study file.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "study/fairness.h"
#include "study/load_study.h"
#include "study/plan.h"
#include "toy.h"

namespace promenade::study {
namespace {

// The toy study with other targets, and with the files that it names.
StudyBundle bundle_of(const std::string& targets, const std::string& file = "") {
  std::string text = toy::study_text();
  const std::string old = "[{ example = \"far\" }]";
  text.replace(text.find(old), old.size(), targets);
  return read_study(
      "toy.toml", text, toy::registry(),
      [](const std::string&, const std::string&) { return toy::motion_set(); },
      [&](const std::string& name, const std::string& folder) {
        if (name.starts_with("builtin:")) return load_file(name, folder);
        if (file.empty()) throw InputError(name, "there is no such file");
        return file;
      });
}

std::string problems_of(const std::string& targets, const std::string& file = "") {
  try {
    bundle_of(targets, file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> names_of(const std::vector<Target>& targets) {
  std::vector<std::string> names;
  for (const Target& target : targets) names.push_back(target.name);
  return names;
}

TEST(RandomTargets, AreDrawnOnceForAStudy) {
  const std::string targets = "[{ random = 'weights', count = 3, draw = 12, name = 'r' }]";
  const StudyBundle bundle = bundle_of(targets);
  const Task& task = bundle.study.tasks[0];
  EXPECT_EQ(names_of(task.targets), (std::vector<std::string>{"r1", "r2", "r3"}));
  const StudyBundle again = bundle_of(targets);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(task.targets[i].weights);
    EXPECT_EQ(*task.targets[i].weights, *again.study.tasks[0].targets[i].weights);
    EXPECT_GT(start_distance(bundle.space, *task.targets[i].weights), *task.threshold_m);
  }
}

TEST(RandomTargets, StandBesideOthersAndTakeTheNameOfTheirModel) {
  const StudyBundle bundle = bundle_of(
      "[{ example = 'far' }, { random = 'pca', count = 2 }, { random = 'features', count = 1 }]");
  EXPECT_EQ(names_of(bundle.study.tasks[0].targets),
            (std::vector<std::string>{"far", "pca1", "pca2", "features1"}));
}

TEST(RandomTargets, FollowFromTheSeedOfTheStudy) {
  std::string text = toy::study_text();
  const std::string old = "{ example = \"far\" }";
  text.replace(text.find(old), old.size(), "{ random = 'weights', count = 1 }");
  const Eigen::VectorXd one = *toy::bundle(text).study.tasks[0].targets[0].weights;
  text.replace(text.find("seed = 7"), 8, "seed = 8");
  EXPECT_NE(one, *toy::bundle(text).study.tasks[0].targets[0].weights);
}

TEST(RandomTargets, ArePartOfTheHashAsTheyWereDrawn) {
  StudyBundle bundle = bundle_of("[{ random = 'weights', count = 1 }]");
  const std::string before = study_hash(bundle, toy::registry());
  EXPECT_EQ(before, bundle.sha256);
  (*bundle.study.tasks[0].targets[0].weights)(0) += 0.001;
  EXPECT_NE(study_hash(bundle, toy::registry()), before);
}

const char* each = "[{ random = 'weights', count = 3, draw = 9, per = 'participant', name = 'r' }]";

// What a person gets, by target.
std::map<std::string, Eigen::VectorXd> drawn(const StudyBundle& bundle, int sequence) {
  std::map<std::string, Eigen::VectorXd> walks;
  for (const PlannedTrial& trial : make_plan(bundle.study, sequence).trials) {
    if (trial.drawn.size() == 0) continue;
    Eigen::VectorXd& walk = walks[target_of(bundle.study, trial).name];
    EXPECT_TRUE(walk.size() == 0 || walk == trial.drawn);  // the same at every interface
    walk = trial.drawn;
  }
  return walks;
}

TEST(RandomTargets, AreAnewForEachParticipantAndTheSameAtEveryInterface) {
  const StudyBundle bundle = bundle_of(each);
  const auto one = drawn(bundle, 0);
  const auto two = drawn(bundle, 1);
  ASSERT_EQ(one.size(), 3U);
  EXPECT_EQ(one, drawn(bundle_of(each), 0));
  for (const auto& [name, walk] : one) EXPECT_NE(walk, two.at(name)) << name;
  EXPECT_NE(one.at("r1"), one.at("r2"));
}

TEST(RandomTargets, NeverBeginBelowAnAutomaticThresholdWhoeverGetsThem) {
  const StudyBundle bundle = bundle_of(each);
  const Task& task = bundle.study.tasks[0];
  for (int sequence = 0; sequence < 20; ++sequence) {
    for (const auto& [name, walk] : drawn(bundle, sequence)) {
      EXPECT_GE(start_distance(bundle.space, walk), *task.threshold_m / start_margin - 1e-9);
    }
  }
}

TEST(RandomTargets, OfPracticeAreNeverThoseThatCount) {
  std::string text = toy::study_text();
  for (const std::string old : {"{ example = \"far\" }", "{ example = \"side\" }"}) {
    text.replace(text.find(old), old.size(),
                 "{ random = 'weights', count = 1, per = 'participant' }");
  }
  const StudyBundle bundle = toy::bundle(text);
  const Plan plan = make_plan(bundle.study, 0);
  EXPECT_NE(plan.trials[0].drawn, plan.trials[1].drawn);
}

TEST(RandomTargets, OfAGuessAreThoseOfTheTaskThatBeginsFromIt) {
  std::string text = toy::study_text();
  text.replace(text.find("kind = \"match\""), 14, "kind = \"guess\"");
  const std::string old = "{ example = \"far\" }";
  text.replace(text.find(old), old.size(),
               "{ random = 'weights', count = 2, per = 'participant' }");
  text += "[[task]]\nname = 'go on'\nkind = 'match'\nstart = 'copy'\nthreshold = 'auto'\n";
  const StudyBundle bundle = toy::bundle(text);
  const Plan plan = make_plan(bundle.study, 3);
  std::map<std::string, std::set<std::vector<double>>> walks;
  for (const PlannedTrial& trial : plan.trials) {
    if (trial.practice || trial.drawn.size() == 0) continue;
    walks[target_of(bundle.study, trial).name].insert({trial.drawn.begin(), trial.drawn.end()});
  }
  ASSERT_EQ(walks.size(), 2U);
  for (const auto& [name, one] : walks) EXPECT_EQ(one.size(), 1U) << name;
}

TEST(TargetFiles, BecomePartOfTheStudy) {
  const std::string csv = "name,near,side,far\nm,0,0.25,0.75\nn,0,0.75,0.25\n";
  const StudyBundle bundle = bundle_of("[{ file = 'targets.csv' }]", csv);
  EXPECT_EQ(names_of(bundle.study.tasks[0].targets), (std::vector<std::string>{"m", "n"}));
  EXPECT_EQ(*bundle.study.tasks[0].targets[0].weights, Eigen::Vector3d(0, 0.25, 0.75));
  ASSERT_EQ(bundle.parts.size(), 2U) << "the first one is the texts";
  EXPECT_EQ(bundle.parts[1].content, csv);
  EXPECT_NE(bundle.sha256, bundle_of("[{ file = 'targets.csv' }]", csv + "\n").sha256);
}

struct Broken {
  const char* targets;
  const char* problems;
};

void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.targets; }

class BrokenTargets : public testing::TestWithParam<Broken> {};

TEST_P(BrokenTargets, AreRefusedWithTheirPlaceAndReason) {
  const std::string csv = "name,near,fra\nm,0,1\n";
  EXPECT_EQ(problems_of(GetParam().targets, csv), GetParam().problems);
}

INSTANTIATE_TEST_SUITE_P(
    Sources, BrokenTargets,
    testing::Values(
        Broken{"[{ random = 'weigths', count = 2 }]",
               "toy.toml:13:23: error: \"random\" is \"weigths\", but must be one of "
               "\"adjectives\", \"features\", \"weights\", \"pca\", \"examples\"; did you mean "
               "\"weights\"?"},
        Broken{"[{ random = 'weights' }]", "toy.toml:13:12: error: \"count\" is missing here"},
        Broken{"[{ random = 'weights', count = 0 }]",
               "toy.toml:13:42: error: \"count\" is 0, but must be from 1 to 100"},
        Broken{"[{ random = 'weights', count = 5, draw = 4 }]",
               "toy.toml:13:52: error: \"draw\" is 4, but 5 of them are to be kept"},
        Broken{"[{ random = 'weights', count = 2, per = 'person' }]",
               "toy.toml:13:51: error: \"per\" is \"person\", but must be one of \"study\", "
               "\"participant\""},
        Broken{"[{ random = 'weights', count = 2, darw = 4 }]",
               "toy.toml:13:45: error: unknown key \"darw\"; did you mean \"draw\"?"},
        Broken{"[{ random = 'weights', count = 2, name = 'a/b' }]",
               "toy.toml:13:52: error: \"name\" must have up to 80 characters, none of them \"/\" "
               "or a control character, and not begin with a dot"},
        Broken{"[{ radnom = 'weights', count = 2 }]",
               "toy.toml:13:12: error: a target needs one of \"example\", \"weights\", \"random\", "
               "\"file\", \"all\", \"stimulus\"\n"
               "toy.toml:13:14: error: unknown key \"radnom\"; did you mean \"random\"?\n"
               "toy.toml:13:34: error: unknown key \"count\""},
        Broken{"[{ name = 'r1', example = 'far' }, { random = 'weights', count = 1, name = 'r' }]",
               "toy.toml:13:46: error: there is another target with the name \"r1\" before"},
        Broken{"[{ file = 'targets.csv' }]",
               "targets.csv:1:11: error: the set has no motion "
               "\"fra\"; did you mean \"far\"?"}));

TEST(RandomTargets, NeedRatingsForAdjectives) {
  std::string text = toy::study_text();
  const std::string old = "{ example = \"far\" }";
  text.replace(text.find(old), old.size(), "{ random = 'adjectives', count = 2 }");
  text.replace(text.find("seed = 7"), 8, "set = 'toy'");
  try {
    toy::bundle(text);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "toy.toml:13:23: error: nothing can be drawn from \"adjectives\": nobody has rated "
        "the motions of this set");
  }
}

TEST(TargetFiles, ThatAreNotThereAreNamedInTheStudy) {
  EXPECT_EQ(problems_of("[{ file = 'none.csv' }]"),
            "toy.toml:13:21: error: cannot use the targets \"none.csv\": there is no such file");
}

TEST(RandomTargets, AreRefusedWhereNearlyAllBeginBelowTheThreshold) {
  std::string text = toy::study_text();
  const std::string old = "{ example = \"far\" }";
  text.replace(text.find(old), old.size(), "{ random = 'weights', count = 1 }");
  text.replace(text.find("\"auto\""), 6, "0.5");
  try {
    toy::bundle(text);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("walks drawn by \"weights\" begin above the threshold "
                        "of 0.5000 m"),
              std::string::npos)
        << error.what();
  }
}

TEST(DealtTargets, AreInListsOfEqualNumber) {
  const StudyBundle bundle = bundle_of(
      "[{ example = 'far' }, { example = 'side' }, { name = 'm', weights = { far = 0.5, side = 0.5 "
      "} }, { name = 'n', weights = { near = 0.5, side = 0.5 } }]\ndeal = 'rotated'");
  const Task& task = bundle.study.tasks[0];
  ASSERT_EQ(task.lists.size(), 2U);
  EXPECT_EQ(task.lists[0].size(), 2U);
  double sums[2] = {0, 0};
  for (int l : {0, 1}) {
    for (const int target : task.lists[static_cast<std::size_t>(l)]) {
      sums[l] +=
          start_distance(bundle.space, *task.targets[static_cast<std::size_t>(target)].weights);
    }
  }
  EXPECT_LT(std::abs(sums[0] - sums[1]), 0.5 * std::max(sums[0], sums[1]));
}

TEST(DealtTargets, AreRefusedWhenTheyAreNoMultipleOfTheInterfaces) {
  EXPECT_EQ(problems_of("[{ example = 'far' }, { example = 'side' }, { name = 'm', weights = { far "
                        "= 0.5, side = 0.5 } }]\ndeal = 'rotated'"),
            "toy.toml:14:8: error: 3 targets cannot be dealt evenly to 2 interfaces; take 2 or 4");
  EXPECT_NE(problems_of("[{ example = 'far' }]\ndeal = 'rotate'").find("did you mean \"rotated\""),
            std::string::npos);
}

TEST(Guesses, NeedTheInterfacesOfTheTasksThatBeginFromThem) {
  std::string text = toy::study_text();
  text.replace(text.find("kind = \"match\""), 14, "kind = \"guess\"\ninterfaces = ['mix']");
  text += "[[task]]\nname = 'go on'\nkind = 'match'\nstart = 'copy'\n";
  try {
    toy::bundle(text);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("nobody does the task \"copy\" with the interface "
                        "\"pick\""),
              std::string::npos)
        << error.what();
  }
}

std::vector<Problem> warnings_with(const std::string& keys) {
  std::string text = toy::study_text();
  return toy::bundle(text.replace(text.find("seed = 7"), 8, keys)).warnings;
}

TEST(Participants, ThatAreNotBalancedAreWarnedOfWithTheNextGoodNumbers) {
  const std::vector<Problem> warnings = warnings_with("participants = 13");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(to_text(warnings[0]),
            "toy.toml:3:16: warning: 13 people are not balanced over the 2 "
            "orders of the interfaces; 12 or 14 are");
  EXPECT_TRUE(warnings_with("participants = 12").empty());
  EXPECT_TRUE(warnings_with("participants = 13\norder = 'random'").empty());
}

TEST(Participants, AreCountedWithTheListsOfTargets) {
  const std::string two = "[{ example = 'far' }, { example = 'side' }]\ndeal = 'rotated'";
  std::string text = toy::study_text();
  const std::string old = "[{ example = \"far\" }]";
  text.replace(text.find(old), old.size(), two);
  text.replace(text.find("seed = 7"), 8, "participants = 2");
  const std::vector<Problem> warnings = toy::bundle(text).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].message.find("4 orders of the interfaces with the lists of targets; 4 or 8 "
                                     "are"),
            std::string::npos)
      << warnings[0].message;
}

TEST(ExamplesByLot, AreWalksOfTheSetUnderTheirOwnNamesAndNoneTwice) {
  std::string text = toy::study_text();
  text.replace(text.find("threshold = \"auto\""), 18, "threshold = 0.01");
  const std::string old = "{ example = \"far\" }";
  text.replace(text.find(old), old.size(), "{ random = 'examples', count = 2, draw = 9 }");
  const StudyBundle bundle = toy::bundle(text);
  const auto& targets = bundle.study.tasks[0].targets;
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_NE(targets[0].name, targets[1].name);
  for (const Target& target : targets) {
    const int cycle = motion::find_cycle(bundle.space.set, target.name);
    ASSERT_GE(cycle, 0) << target.name;
    EXPECT_EQ((*target.weights)(cycle), 1);
  }
}

TEST(ExamplesByLot, AreNumberedWhereEachPersonGetsOthers) {
  const StudyBundle bundle =
      bundle_of("[{ random = 'examples', count = 1, per = 'participant', name = 'walk' }]");
  EXPECT_EQ(names_of(bundle.study.tasks[0].targets), std::vector<std::string>{"walk1"});
}

TEST(ExamplesByLot, AreRefusedWhereTheSetHasFewer) {
  EXPECT_NE(problems_of("[{ random = 'examples', count = 4 }]").find("4 walks of the set"),
            std::string::npos);
}

TEST(AllExamples, AreTheWalksOfTheSetInItsOrder) {
  const StudyBundle bundle = bundle_of("[{ all = true }]");
  const auto& targets = bundle.study.tasks[0].targets;
  EXPECT_EQ(names_of(targets), motion::names_of(bundle.space.set));
  EXPECT_EQ(*targets[1].weights, Eigen::VectorXd::Unit(3, 1));
}

TEST(AllExamples, AreTrueOrLeftOutAndStandAlone) {
  EXPECT_NE(problems_of("[{ all = false }]").find("\"all\" is true"), std::string::npos);
  EXPECT_NE(problems_of("[{ all = 3 }]").find("all"), std::string::npos);
  EXPECT_NE(problems_of("[{ all = true, example = 'far' }]").find("a target needs one of"),
            std::string::npos);
  EXPECT_NE(problems_of("[{ all = true, name = 'x' }]").find("name"), std::string::npos);
}

constexpr const char* kept = "[{ random = 'weights', count = 2, kept_in = 'kept.csv' }]";
constexpr const char* kept_file = "name,near,far\none,1,0\ntwo,0.25,0.75\n";

TEST(KeptDraws, ComeFromTheirFileWhichIsPartOfTheStudy) {
  const StudyBundle bundle = bundle_of(kept, kept_file);
  const auto& targets = bundle.study.tasks[0].targets;
  EXPECT_EQ(names_of(targets), (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ((*targets[1].weights)(motion::find_cycle(bundle.space.set, "far")), 0.75);
  const auto is_file = [](const StudyPart& part) { return part.path == "kept.csv"; };
  EXPECT_TRUE(std::any_of(bundle.parts.begin(), bundle.parts.end(), is_file));
  EXPECT_TRUE(bundle.warnings.empty());
}

TEST(KeptDraws, OfAnotherSetAreDrawnAnewWithAWarning) {
  const StudyBundle bundle = bundle_of(kept, "name,happy,sad\none,1,0\ntwo,0,1\n");
  EXPECT_EQ(names_of(bundle.study.tasks[0].targets),
            (std::vector<std::string>{"weights1", "weights2"}));
  ASSERT_EQ(bundle.warnings.size(), 1U);
  EXPECT_NE(bundle.warnings[0].message.find("drawn anew"), std::string::npos);
}

TEST(KeptDraws, AreRefusedWhereFileAndStudyDisagree) {
  EXPECT_NE(problems_of(kept, "name,near\none,1\n").find("holds 1 targets, but \"count\" is 2"),
            std::string::npos);
  EXPECT_NE(problems_of(kept).find("cannot use the targets \"kept.csv\""), std::string::npos);
  EXPECT_NE(problems_of(kept, "name,near\none,1\ntwo,0.5\n").find("sum"), std::string::npos);
  const std::string each_kept =
      "[{ random = 'weights', count = 2, kept_in = 'kept.csv', per = 'participant' }]";
  EXPECT_NE(problems_of(each_kept, kept_file).find("for each participant"), std::string::npos);
  EXPECT_NE(problems_of("[{ random = 'weights', count = 2, kept_in = 3 }]").find("kept_in"),
            std::string::npos);
}

}  // namespace
}  // namespace promenade::study
