#include "analysis/report/sentences.h"

#include <gtest/gtest.h>

#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

Results results_of(const TestFolder& folder, int people, double step) {
  { fill(*std::make_unique<ToyLog>(folder.file("a.db")), people, step); }
  return compute_results({folder.file("a.db")}, {});
}

std::string sentence(const Results& results, const char* measure) {
  return sentence_on_measure(results, results.data.measure(measure), 0);
}

// Differences are 0.1 cm, 0.2 cm, ... 1.2 cm: the median of their Walsh averages is 0.65.
TEST(Sentences, SayWhatIsBetterByHowMuchAndHowSure) {
  const TestFolder folder;
  const Results results = results_of(folder, 12, 0.001);
  EXPECT_EQ(sentence(results, "d_final"),
            "With labels people came 0.7 cm closer than with weights (95 % CI 0.4 to 0.9; n = 12; "
            "exact p < .001).");
  EXPECT_EQ(
      sentence(results, "time_s"),
      "With labels people were 10.0 s faster than with weights (95 % CI 10.0 to 10.0; n = 12; "
      "exact p < .001).");
}

TEST(Sentences, DoNotCallSimulatedParticipantsPeople) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    fill(log, 12, 0.001);
    log.database().exec("UPDATE session SET simulated = 1");
  }
  const Results results = compute_results({folder.file("a.db")}, {true, false, ""});
  EXPECT_EQ(sentence(results, "d_final").find("With labels simulated participants came 0.7 cm"),
            0u);
}

TEST(Sentences, SayThatAllDifferencesAreZero) {
  const TestFolder folder;
  EXPECT_EQ(sentence(results_of(folder, 12, 0), "d_final"),
            "All 12 people had the same final D with weights as with labels.");
}

TEST(Sentences, SayThatOnePersonIsTooFew) {
  const TestFolder folder;
  const Results results = results_of(folder, 1, 0.01);
  EXPECT_EQ(sentence(results, "d_final"),
            "One participant is too few to compare weights with labels. Final D was 1.0 cm lower "
            "with labels.");
  EXPECT_EQ(caveats(results).size(), 1u);
}

TEST(Sentences, SayThatThereIsOnlyOneInterface) {
  const TestFolder folder;
  { ToyLog(folder.file("a.db")).session({}).trial({}); }
  const Results results = compute_results({folder.file("a.db")}, {});
  EXPECT_EQ(sentence(results, "d_final"),
            "Only one interface was used, labels, so there is nothing to compare: median final D "
            "5.0 cm (n = 1, too few for an interval).");
}

TEST(Sentences, SayThatNobodyUsedBoth) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({"P1"}).trial({"labels"}).session({"P2"}).trial({"weights"});
  }
  const Results results = compute_results({folder.file("a.db")}, {});
  EXPECT_EQ(sentence(results, "time_s"),
            "Nobody has a value of time with both weights and labels.");
}

// Task match is for labels and weights alone, find for labels and map.
Results two_tasks(const TestFolder& folder) {
  {
    ToyLog log(folder.file("a.db"));
    for (int i = 1; i <= 8; ++i) {
      log.session({"P" + std::to_string(i)});
      log.trial({"labels", "happy", 10.0 + i, 0.02}).trial({"weights", "happy", 20.0 + i, 0.03});
      log.trial({"labels", "tired", 5, {}, "done", "find"});
      log.trial({"map", "tired", 5.0 + i, {}, "done", "find"});
    }
  }
  return compute_results({folder.file("a.db")}, {});
}

TEST(Sentences, NameTheTaskAndCountThePairsThatItHas) {
  const TestFolder folder;
  EXPECT_EQ(sentence(two_tasks(folder), "d_final"),
            "Task match: With labels people came 1.0 cm closer than with weights (95 % CI 1.0 to "
            "1.0; n = 8; exact p = .008).");
}

TEST(Sentences, CountMissingTrialsInGoodGrammar) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    fill(log, 12, 0.001);
    log.trial({"labels", "sad", 1, 0.1, "aborted"}).trial({"labels", "old", 1, 0.1, "skipped"});
  }
  EXPECT_EQ(caveats(compute_results({folder.file("a.db")}, {})).at(0),
            "2 trials were skipped, aborted or cut off and count as missing.");
}

// What the first page says of a study whose targets come from `model`, with the interfaces
// "words" (adjectives) and "weights".
std::vector<std::string> caveats_on(const std::string& model) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    fill(log, 12, 0.001);
    study::Statement row(log.database(), "UPDATE study SET config_text = ?");
    row.bind(1,
             "[[interface]]\nname = \"words\"\ntype = \"adjectives\"\n[[interface]]\nname = "
             "\"weights\"\n[[task]]\nname = \"match\"\ntargets = [{ random = \"" +
                 model + "\", count = 1 }]\n")
        .run();
  }
  return caveats(compute_results({folder.file("a.db")}, {}));
}

TEST(Sentences, SayWhomDrawnTargetsFavour) {
  EXPECT_EQ(caveats_on("adjectives"),
            std::vector<std::string>{
                "The targets of task match were drawn as random settings of the sliders of "
                "adjectives, so that its sliders can always reach them: this favours words."});
  EXPECT_TRUE(caveats_on("features").empty()) << "no interface has these sliders";
  EXPECT_TRUE(caveats_on("pca").empty());
}

}  // namespace
}  // namespace promenade::analysis
