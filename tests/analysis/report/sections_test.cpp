// The sections that test something, on whole databases.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>

#include "analysis/report/comparison_table.h"
#include "analysis/report/report_sections.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

Results results_of(const TestFolder& folder) { return compute_results({folder.file("a.db")}, {}); }

// weights is slower than labels by 10 s and "mixer" faster by 5 + i s, i = 1..people.
void fill_three(const TestFolder& folder, int people, const std::string& outcome = "success") {
  ToyLog log(folder.file("a.db"));
  for (int i = 1; i <= people; ++i) {
    log.session({"P" + std::to_string(i)});
    log.trial({"labels", "happy", 20.0 + i, 0.03 + 0.001 * i, outcome});
    log.trial({"weights", "happy", 30.0 + i, 0.02, outcome});
    log.trial({"mixer", "happy", 15, 0.04, outcome});
  }
}

bool has_word(const std::string& text, const std::string& word) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    const bool begins = at == 0 || std::isalpha(static_cast<unsigned char>(text[at - 1])) == 0;
    const std::size_t end = at + word.size();
    const bool ends =
        end == text.size() || std::isalpha(static_cast<unsigned char>(text[end])) == 0;
    if (begins && ends) return true;
  }
  return false;
}

void expect_numbers(const Results& results) {
  for (const Section& section : sections_of(results)) {
    std::string all = section.html.code + section.json.dump();
    for (const Table& table : section.tables) all += to_csv(table);
    EXPECT_FALSE(has_word(all, "nan")) << section.title;
    EXPECT_FALSE(has_word(all, "inf")) << section.title;
    EXPECT_TRUE(section.title.empty() || !section.html.code.empty()) << section.title;
  }
}

TEST(Sections, HoldForFewPeopleTiesAndThreeInterfaces) {
  for (const int people : {1, 2, 6, 13}) {
    for (const char* outcome : {"success", "timeout"}) {
      const TestFolder folder;
      fill_three(folder, people, outcome);
      expect_numbers(results_of(folder));
    }
  }
}

TEST(Sections, LeaveOutAStartThatWasTheSameForAll) {
  const TestFolder folder;
  fill_three(folder, 6);
  const Results results = results_of(folder);
  const Section section = comparisons_section(results);
  EXPECT_EQ(section.html.code.find(">D at the start<"), std::string::npos);
  EXPECT_NE(section.html.code.find(">final D<"), std::string::npos);
}

TEST(Sections, HoldForOneInterface) {
  const TestFolder folder;
  { ToyLog(folder.file("a.db")).session({}).trial({}); }
  const Results results = results_of(folder);
  expect_numbers(results);
  EXPECT_NE(comparisons_section(results).html.code.find("Only one interface"), std::string::npos);
  EXPECT_TRUE(omnibus_section(results).title.empty());
  EXPECT_TRUE(preference_section(results).title.empty());
}

TEST(Sections, HoldWhereNobodyUsedBothInterfaces) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({"P1"}).trial({"labels"}).session({"P2"}).trial({"weights"});
  }
  expect_numbers(results_of(folder));
}

// Everyone ranks the three alike: chi-square = n (k - 1) = 12, p = 6 / 6^6 exactly.
TEST(OmnibusSection, HasTheExactTestOfThreeInterfaces) {
  const TestFolder folder;
  fill_three(folder, 6);
  const nlohmann::json json = omnibus_section(results_of(folder)).json;
  for (const auto& row : json["friedman"]) {
    if (row["measure"] != "time_s") continue;
    EXPECT_NEAR(row["chi2"], 12, 1e-12);
    EXPECT_NEAR(row["p_exact"], std::pow(6.0, -5), 1e-15);
    EXPECT_NEAR(row["kendall_w"], 1, 1e-12);
  }
  EXPECT_EQ(json["friedman_pairs"].size() % 3, 0u);
  EXPECT_GT(json["friedman_pairs"].size(), 0u);
}

// The convention of [O] stands beside the exact p: six times the same, z = 10.5 / sqrt(6) 1.75.
TEST(TargetsSection, PrintsTheNormalPBesideTheExactOne) {
  const TestFolder folder;
  fill_three(folder, 6);
  const std::string html = targets_section(results_of(folder)).html.code;
  EXPECT_NE(html.find("<th scope=\"col\" class=\"right\">exact p</th>"), std::string::npos);
  EXPECT_NE(html.find("without continuity correction"), std::string::npos);
  EXPECT_NE(html.find("<td>.031</td>"), std::string::npos) << "2/64";
  EXPECT_NE(html.find("<td>.094</td>"), std::string::npos) << "Holm over three";
  EXPECT_NE(html.find("<td>.014</td>"), std::string::npos) << "normal, all tied";
  EXPECT_NE(html.find("up to 3 tests"), std::string::npos);
}

Comparison many_pooled(std::size_t n) {
  std::vector<std::optional<double>> a, b;
  for (std::size_t i = 1; i <= n; ++i) {
    a.push_back(i % 3 == 0 ? -1.0 * static_cast<double>(i) : static_cast<double>(i));
    b.push_back(0);
  }
  Comparison place;
  place.pooling = Pooling::trials;
  return compare_pairs(place, {a, b})[0];
}

TEST(ComparisonTable, SaysWhereTheNormalPStandsForTheExactOneAndWhy) {
  Results results;
  results.data.interfaces = {"a", "b"};
  results.comparisons = {many_pooled(pooled_limit)};
  EXPECT_EQ(family_note(results, Pooling::trials).code.find("(normal)"), std::string::npos);
  results.comparisons = {many_pooled(pooled_limit + 1)};
  EXPECT_NE(family_note(results, Pooling::trials).code.find("exact up to 1000"), std::string::npos);
  const std::vector<std::string> cells =
      test_cells({"time_s", "time", "s", "s", 1, 1}, results.comparisons[0]);
  EXPECT_EQ(cells[5], "< .001 (normal)");
}

TEST(FailuresSection, SaysThatNobodyFailed) {
  const TestFolder folder;
  fill_three(folder, 3);
  EXPECT_NE(failures_section(results_of(folder)).html.code.find("Nobody failed"),
            std::string::npos);
}

TEST(TimesSection, SaysThatTrialsOfAPersonAreNotIndependent) {
  const TestFolder folder;
  fill_three(folder, 3);
  const Section section = times_section(results_of(folder));
  EXPECT_NE(section.html.code.find("Trials of one person are not independent"), std::string::npos);
  EXPECT_EQ(section.json["times"].size(), 3u);
  EXPECT_EQ(section.json["log_rank"].size(), 4u) << "all, and three pairs";
}

TEST(GuessesSection, CountsWhatWasBelowTheThreshold) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.database().exec(
        "UPDATE study SET config_text = '[[task]]' || char(10) || 'name = \"match\"' || char(10) "
        "|| 'kind = \"guess\"'");
    for (int i = 0; i < 4; ++i) {
      log.session({"P" + std::to_string(i)});
      log.trial({.d_final = i == 0 ? 0.02 : 0.09, .threshold_m = 0.06});
    }
  }
  const Section section = guesses_section(results_of(folder));
  EXPECT_EQ(section.json["guesses"][0]["right"], 1);
  EXPECT_EQ(section.json["guesses"][0]["ratio"], 0.25);
  // Clopper-Pearson below: the p with 1 - (1-p)^4 = .025.
  EXPECT_NEAR(section.json["guesses"][0]["clopper_pearson_lower"], 1 - std::pow(0.975, 0.25),
              1e-12);
}

TEST(MethodsSection, NamesWhatWasUsedAndNothingElse) {
  const TestFolder folder;
  fill_three(folder, 6);
  const nlohmann::json json = methods_section(results_of(folder)).json;
  const std::string draft = json["methods"].dump();
  for (const char* words : {"6 people took part", "3 interfaces were compared", "Friedman",
                            "over the 3 pairs", "at most 60 s", "Promenade 0.1.0"}) {
    EXPECT_NE(draft.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(draft.find("Preferences"), std::string::npos) << "nobody was asked";
  EXPECT_EQ(draft.find("McNemar"), std::string::npos) << "nobody failed";
  const std::string works = json["references"].dump();
  EXPECT_NE(works.find("F. Wilcoxon (1945)"), std::string::npos);
  EXPECT_EQ(works.find("McNemar (1947)"), std::string::npos) << "nobody failed";
}

TEST(MethodsSection, SaysWhetherPeopleJudgedTheMotionsBehindTheAdjectives) {
  const TestFolder folder;
  fill_three(folder, 6);
  Results results = results_of(folder);
  const auto draft = [&] { return methods_section(results).json["methods"].dump(); };
  EXPECT_EQ(draft().find("adjectives"), std::string::npos) << "no interface used them";
  results.adjectives = AdjectiveSource{"14 simulated raters, seed 1", 14, true};
  EXPECT_NE(draft().find("by simulated raters (14 simulated raters, seed 1): no person"),
            std::string::npos);
  EXPECT_TRUE(methods_section(results).json["adjectives"]["simulated"]);
  results.adjectives = AdjectiveSource{"ratings.csv", 9, false};
  EXPECT_NE(draft().find("ratings by 9 people (ratings.csv)"), std::string::npos);
}

TEST(FailuresSection, HasNoSharesOfATaskThatCannotFail) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    for (const char* name : {"labels", "weights"}) {
      log.session({name}).trial({name, "tired", 5, {}, "done", "find", false, {}});
    }
  }
  const Section section = failures_section(results_of(folder));
  EXPECT_NE(section.html.code.find("there are no shares of failures"), std::string::npos);
  EXPECT_EQ(section.html.code.find("Wilson"), std::string::npos);
}

TEST(TimesSection, CountsWhatWasWonBeforeItBegan) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({"P1"}).trial({"labels", "happy", 0, 0.01, "success"});
    log.trial({"weights", "happy", 9, 0.01, "success"});
  }
  EXPECT_NE(times_section(results_of(folder)).html.code.find("weights 0 of 1, labels 1 of 1"),
            std::string::npos);
}

TEST(ComparisonTable, HasOnlyPairsThatATaskAllows) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({"P1"}).trial({"labels"}).trial({"weights"});
    log.trial({"map", "tired", 5, {}, "done", "find"});
  }
  const Results results = results_of(folder);
  const HtmlTable table = comparison_table(results, 0, Pooling::participants, "");
  EXPECT_FALSE(table.rows.empty());
  for (const auto& row : table.rows) EXPECT_EQ(row[1].find("map"), std::string::npos) << row[1];
}

void set_config(ToyLog& log, const std::string& text) {
  study::Statement row(log.database(), "UPDATE study SET config_text = ?");
  row.bind(1, text).run();
}

// Each of `people` rated one walk on two pairs of adjectives.
Results rated(const TestFolder& folder, int people) {
  {
    ToyLog log(folder.file("a.db"));
    set_config(log, "[study]\npublished = \"oshita-questionnaire-a\"\n");
    for (int i = 1; i <= people; ++i) {
      log.session({"P" + std::to_string(i)}).trial({"", "happy", 20, {}, "done", "rate"});
      log.answer("slow-fast", 2).answer("dark-bright", i % 2);
    }
  }
  return results_of(folder);
}

TEST(Sections, HoldWhereWalksWereOnlyRated) {
  const TestFolder folder;
  const Results results = rated(folder, 3);
  EXPECT_TRUE(results.data.trials.empty());
  EXPECT_EQ(results.rated_walks, 3);
  expect_numbers(results);
  EXPECT_TRUE(comparisons_section(results).title.empty());
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// In each table, a row has as many cells as there are headings.
void expect_whole_tables(const std::string& html) {
  for (std::size_t at = html.find("<table"); at != html.npos; at = html.find("<table", at + 1)) {
    const std::string table = html.substr(at, html.find("</table>", at) - at);
    const int columns = count(table, "scope=\"col\"");
    for (std::size_t row = table.find("<tr"); row != table.npos; row = table.find("<tr", row + 1)) {
      const std::string cells = table.substr(row, table.find("</tr>", row) - row);
      EXPECT_EQ(count(cells, "<td") + count(cells, "<th"), columns) << cells;
    }
  }
}

TEST(PublishedSection, ShowsKeptPairsBesideTheirPrint) {
  const TestFolder folder;
  const Section section = published_section(rated(folder, 3));
  expect_whole_tables(section.html.code);
  EXPECT_EQ(section.title, "Printed / this run");
  const auto& json = section.json["published"];
  EXPECT_EQ(json["study"], "oshita-questionnaire-a");
  EXPECT_EQ(json["pairs"].size(), 41U);
  EXPECT_EQ(json["pairs"][0]["pair"], "slow-fast");
  EXPECT_EQ(json["pairs"][0]["kept"], 1) << "2 of all three";
  EXPECT_EQ(json["pairs"][0]["extreme"], 2);
  EXPECT_EQ(json["pairs"][0]["sigma"], 0);
  EXPECT_EQ(json["pairs"][0]["cluster_in_print"], "quickness");
  EXPECT_EQ(json["pairs"][16]["pair"], "dark-bright");
  EXPECT_EQ(json["pairs"][16]["kept"], 0) << "2/3 is never extreme";
  EXPECT_TRUE(json["pairs"][1]["kept"].is_null()) << "nobody rated it";
  EXPECT_EQ(json["kept"], 1);
  EXPECT_EQ(json["kept_in_both"], 1);
  EXPECT_EQ(section.tables.size(), 2U);
}

TEST(PublishedSection, IsNotThereWithoutAPublishedStudy) {
  const TestFolder folder;
  fill_three(folder, 3);
  EXPECT_TRUE(published_section(results_of(folder)).title.empty());
}

TEST(PublishedSection, CountsTestsOnBothSides) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    fill(log, 13, 0.001);
    set_config(log,
               "[study]\npublished = \"oshita-2018\"\n[[interface]]\nname = \"labels\"\n"
               "type = \"adjectives\"\n[[interface]]\nname = \"weights\"\n[[task]]\nname = "
               "\"match\"\nkind = \"guess\"\n");
  }
  const std::string page = published_section(results_of(folder)).html.code;
  EXPECT_NE(page.find("D of the guess: of 15 tests of single targets 11 are significant in print "
                      "and 1 in this run; 0 have the same answer."),
            std::string::npos)
      << page;
  expect_whole_tables(page);
}

}  // namespace
}  // namespace promenade::analysis
