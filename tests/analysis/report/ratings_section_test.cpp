// What a report says of ratings on pairs of adjectives, on whole databases.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/report/figures.h"
#include "analysis/report/report_sections.h"
#include "motion/files.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

using Json = nlohmann::json;

class RatingsSection : public ::testing::Test {
 protected:
  Results results(const SelectionOptions& options = {}) { return compute_results(files, options); }
  Section section(const SelectionOptions& options = {}) {
    return ratings_section(results(options));
  }
  Json json(const SelectionOptions& options = {}) { return section(options).json["ratings"]; }
  TestFolder folder;
  std::vector<std::string> files = {folder.file("a.db")};
};

void rate(ToyLog& log, const std::string& motion) {
  log.trial({"", motion, 20, {}, "done", "rate"});
}

// One pair for each fate: on "weak-strong" the fourth disagrees, and "heavy-light" nobody was
// asked about the sad motion.
void fill_fates(ToyLog& log, bool simulated = false) {
  for (int i = 1; i <= 4; ++i) {
    log.session({(simulated ? "S" : "P") + std::to_string(i), "finished", simulated});
    rate(log, "happy");
    log.answer("slow-fast", 2).answer("weak-strong", i == 4 ? -2 : 2);
    log.answer("dark-bright", i % 2).answer("heavy-light", 2);
    rate(log, "sad");
    log.answer("slow-fast", -2).answer("weak-strong", 0).answer("dark-bright", 0);
  }
}

// Two clusters of two pairs each: what moves fast or slow, and what is large or small. Everyone
// says the same, but for one step of one answer each.
void fill_clusters(ToyLog& log, int people) {
  const std::vector<double> fast = {2, -2, 2, -2, 1};
  const std::vector<double> large = {2, 1, -2, -2, -1};
  for (int i = 1; i <= people; ++i) {
    log.session({"P" + std::to_string(i)});
    for (std::size_t m = 0; m < fast.size(); ++m) {
      rate(log, "walk" + std::to_string(m + 1));
      const double own = static_cast<int>(m) == i % 5 ? 0.5 : 0;
      log.answer("slow-fast", fast[m] < 0 ? fast[m] + own : fast[m] - own);
      log.answer("dull-quick", fast[m]).answer("small-large", large[m]);
      log.answer("closed-open", large[m] < 0 ? large[m] + own : large[m] - own);
    }
  }
}

std::map<std::string, Json> by(const Json& rows, const std::string& key) {
  std::map<std::string, Json> found;
  for (const Json& row : rows) found[row[key]] = row;
  return found;
}

TEST_F(RatingsSection, SaysWhichThresholdDropsAPair) {
  { fill_fates(*std::make_unique<ToyLog>(files[0])); }
  const Section found = section();
  const Json& numbers = found.json["ratings"];
  EXPECT_EQ(found.title, "Ratings");
  EXPECT_EQ(numbers["raters"], 4);
  EXPECT_EQ(numbers["motions"], 2);
  auto pairs = by(numbers["pairs"], "pair");
  ASSERT_EQ(pairs.size(), 4U);
  EXPECT_EQ(pairs["slow-fast"]["fate"], "kept");
  EXPECT_EQ(pairs["slow-fast"]["alpha_ordinal"], 1);
  EXPECT_EQ(pairs["weak-strong"]["fate"], "disagreed");
  EXPECT_EQ(pairs["weak-strong"]["sigma"], 1) << "2 of the one motion, 0 of the other";
  EXPECT_EQ(pairs["dark-bright"]["fate"], "never extreme");
  EXPECT_EQ(pairs["dark-bright"]["extreme"], 0.5);
  EXPECT_EQ(pairs["heavy-light"]["fate"], "not rated everywhere");
  EXPECT_NE(found.html.code.find(
                "4 people rated 2 motions on 4 pairs of adjectives: 1 pair is kept, 1 dropped "
                "because no motion is far from neutral (μ* below 1), 1 dropped because raters "
                "differ too much (σ above 0.85), 1 dropped because not every motion was rated, or "
                "none by two people."),
            std::string::npos)
      << found.html.code;
}

TEST_F(RatingsSection, SaysThatTooFewPairsAreLeft) {
  { fill_fates(*std::make_unique<ToyLog>(files[0])); }
  EXPECT_FALSE(json()["agrees"]);
  EXPECT_NE(section().html.code.find("Too few pairs are left for sliders: 1, and 4 are needed"),
            std::string::npos);
}

TEST_F(RatingsSection, NamesClustersAndHowMuchTheyAreThePrintedOnes) {
  { fill_clusters(*std::make_unique<ToyLog>(files[0]), 6); }
  Results found = results();
  found.rated_pairs->model =
      study::make_adjective_model(found.rated_pairs->model.table, "", {.clusters = 2});
  const Json numbers = ratings_section(found).json["ratings"];
  auto clusters = by(numbers["clusters"], "name");
  ASSERT_EQ(clusters.size(), 2U);
  EXPECT_EQ(clusters["quickness"]["pairs"], Json({"slow-fast", "dull-quick"}));
  EXPECT_EQ(clusters["largeness"]["pairs"], Json({"small-large", "closed-open"}));
  EXPECT_EQ(by(numbers["pairs"], "pair")["small-large"]["cluster"], "largeness");
}

TEST_F(RatingsSection, SaysThatRatersAgreeAndHowSure) {
  { fill_clusters(*std::make_unique<ToyLog>(files[0]), 6); }
  const Section found = section();
  EXPECT_TRUE(found.json["ratings"]["agrees"]);
  EXPECT_EQ(found.json["ratings"]["p"], 0.005) << "no shuffle of 199 is as good";
  EXPECT_NE(found.html.code.find("Raters agree: "), std::string::npos);
  EXPECT_NE(found.html.code.find("(p = .005, 199 shuffles)"), std::string::npos);
  EXPECT_NE(found.html.code.find("ordinal alpha over all pairs is 0.9"), std::string::npos);
}

TEST_F(RatingsSection, NamesRatersAsOtherTablesDo) {
  {
    ToyLog log(files[0]);
    fill_clusters(log, 10);
    log.database().exec("DELETE FROM answer WHERE session = '10' AND item = 'slow-fast'");
  }
  const Json raters = json()["by_rater"];
  ASSERT_EQ(raters.size(), 10U);
  EXPECT_EQ(raters[1]["participant"], "P2");
  EXPECT_EQ(raters[1]["ratings"], 20);
  EXPECT_EQ(raters[9]["participant"], "P10");
  EXPECT_EQ(raters[9]["ratings"], 15);
}

TEST_F(RatingsSection, IsOfThosePeopleWhoAreAnalysed) {
  {
    ToyLog log(files[0]);
    fill_fates(log);
    log.database().exec("UPDATE session SET outcome = 'stopped' WHERE uuid = '3'");
  }
  write_file(folder.file("x.csv"), "P4,slept\n");
  EXPECT_EQ(json()["raters"], 3);
  const Json numbers = json({false, false, folder.file("x.csv")});
  EXPECT_EQ(numbers["raters"], 2);
  EXPECT_EQ(by(numbers["pairs"], "pair")["weak-strong"]["fate"], "kept") << "P4 alone disagreed";
}

TEST_F(RatingsSection, ReadsFilesOfOtherMotionsAndASessionOfTwoFilesOnce) {
  { fill_fates(*std::make_unique<ToyLog>(files[0])); }
  {
    ToyLog log(folder.file("b.db"));
    log.session({"Q1"}, "other");
    rate(log, "tired");
    log.answer("slow-fast", -1);
  }
  write_file(folder.file("c.db"), read_file(files[0]));
  files.push_back(folder.file("b.db"));
  files.push_back(folder.file("c.db"));
  const Json numbers = json();
  EXPECT_EQ(numbers["raters"], 5);
  EXPECT_EQ(numbers["motions"], 3);
  EXPECT_EQ(by(numbers["pairs"], "pair")["slow-fast"]["ratings"], 9);
}

TEST_F(RatingsSection, SaysThatRatersWereSimulated) {
  {
    ToyLog log(files[0]);
    fill_fates(log);
    fill_fates(log, true);
  }
  EXPECT_EQ(json()["simulated_raters"], 0);
  EXPECT_EQ(section().html.code.find("simulated"), std::string::npos);
  const Section both = section({true, false, ""});
  EXPECT_EQ(both.json["ratings"]["simulated_raters"], 4);
  EXPECT_NE(both.html.code.find("4 raters are simulated"), std::string::npos);
}

TEST_F(RatingsSection, SaysWhatIsWrongWithAnswersOffTheScale) {
  {
    ToyLog log(files[0]);
    fill_fates(log);
    rate(log, "old");
    log.answer("slow-fast", 7);
  }
  const Section found = section();
  EXPECT_NE(found.html.code.find("is not from -2 to 2"), std::string::npos);
  EXPECT_TRUE(found.tables.empty());
}

TEST_F(RatingsSection, IsNotThereWhereNobodyWasAskedAboutPairs) {
  {
    ToyLog log(files[0]);
    log.session({"P1"}).trial({"labels"}).answer("slow-fast", 7);
    rate(log, "happy");
    log.answer("liking", 7);
  }
  EXPECT_FALSE(results().rated_pairs);
  EXPECT_TRUE(section().title.empty());
}

const Figure* pairs_in(const std::vector<Figure>& figures) {
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [](const Figure& one) { return one.name == "dendrogram_pairs"; });
  return found == figures.end() ? nullptr : &*found;
}

TEST_F(RatingsSection, HasATreeOfThePairsInItsClusters) {
  { fill_clusters(*std::make_unique<ToyLog>(files[0]), 6); }
  Results found = results();
  found.rated_pairs->model =
      study::make_adjective_model(found.rated_pairs->model.table, "", {.clusters = 2});
  const auto figures = figures_of(found);
  const Figure* tree = pairs_in(figures);
  ASSERT_TRUE(tree);
  EXPECT_NE(tree->caption.find("quickness (2)"), std::string::npos) << tree->caption;
  EXPECT_NE(tree->caption.find("largeness (2)"), std::string::npos);
  const Table& brackets = tree->data[0];
  ASSERT_EQ(brackets.rows.size(), 15U) << "three merges of four points and a gap";
  EXPECT_EQ(std::get<std::int64_t>(brackets.rows[10][4]), 0) << "the last joins both";
  EXPECT_GT(std::get<std::int64_t>(brackets.rows[0][4]), 0);
  std::filesystem::create_directories(folder.file("figures"));
  draw({*tree}, folder.file("figures"));
  EXPECT_NE(read_file(folder.file("figures/dendrogram_pairs.svg")).find("dull-quick"),
            std::string::npos);
}

// A stimulus beside what the toy log's study has.
void add_stimulus(ToyLog& log) {
  log.database().exec(
      "UPDATE study SET config_text = config_text || '[[stimulus]]' || char(10) || "
      "'name = \"turn\"'");
}

TEST_F(RatingsSection, HasStimuliByNameAndApart) {
  {
    ToyLog log(files[0]);
    add_stimulus(log);
    fill_fates(log);
    for (const double value : {1.0, 2.0}) {
      log.session({"P" + std::to_string(4 + value)});
      rate(log, "turn");
      log.answer("slow-fast", value);
    }
  }
  const Section found = section();
  const Json& ratings = found.json["ratings"];
  EXPECT_EQ(ratings["raters"], 4) << "the model is of the motions alone";
  EXPECT_EQ(ratings["motions_in_set"], 2);
  ASSERT_EQ(ratings["stimuli"].size(), 1U);
  EXPECT_EQ(ratings["stimuli"][0]["stimulus"], "turn");
  EXPECT_EQ(ratings["stimuli"][0]["mean"], 1.5);
  EXPECT_NE(found.html.code.find("turn"), std::string::npos) << found.html.code;
}

TEST_F(RatingsSection, HasStimuliAlsoWhereNoMotionOfTheSetWasRated) {
  {
    ToyLog log(files[0]);
    add_stimulus(log);
    log.session({"P1"});
    rate(log, "turn");
    log.answer("slow-fast", 2);
  }
  const Section found = section();
  EXPECT_NE(found.html.code.find("holds ratings of stimuli alone"), std::string::npos)
      << found.html.code;
  EXPECT_EQ(found.json["ratings"]["stimuli"].size(), 1U);
}

TEST_F(RatingsSection, HasNoTreeOfOnePair) {
  { fill_fates(*std::make_unique<ToyLog>(files[0])); }
  EXPECT_FALSE(pairs_in(figures_of(results())));
}

}  // namespace
}  // namespace promenade::analysis
