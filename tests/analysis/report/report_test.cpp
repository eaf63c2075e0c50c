#include "analysis/report/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "analysis/report/cells.h"
#include "motion/files.h"
#include "motion/problem.h"
#include "tests/analysis/toy_log.h"
#include "tests/study/toy.h"

namespace promenade::analysis {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

void make(const TestFolder& folder, const std::string& name, int people, double step) {
  fill(*std::make_unique<ToyLog>(folder.file(name)), people, step);
}

std::map<std::string, std::string> contents(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[fs::relative(entry.path(), folder).string()] = read_file(entry.path());
    }
  }
  return files;
}

Json report(const TestFolder& folder, const SelectionOptions& selection = {}) {
  write_report({{folder.file("a.db")}, folder.file("out"), selection, {}});
  return Json::parse(read_file(folder.file("out/report.json")));
}

Json row_of(const Json& report, const std::string& measure, const Json& pooling) {
  for (const Json& row : report["wilcoxon"]) {
    if (row["measure"] == measure && row["pooling"] == pooling) return row;
  }
  return {};
}

// weights - labels is 0.001 i metres and 10 s for person i = 1..7: W+ = 28, p = 2/128, the
// middle of the 28 Walsh averages is 0.004, and c = 3 by tables (2 P(W <= 2) = 6/128): the
// third of 0.001, 0.0015, 0.002, 0.002, ...
TEST(Report, HasTheNumbersOfTheContractInJson) {
  const TestFolder folder;
  make(folder, "a.db", 7, 0.001);
  const Json row = row_of(report(folder), "d_final", "participants");
  EXPECT_EQ(row["a"], "weights");
  EXPECT_EQ(row["b"], "labels");
  EXPECT_TRUE(row["target"].is_null());
  EXPECT_EQ(row["n"], 7);
  EXPECT_EQ(row["n_zero"], 0);
  EXPECT_EQ(row["W_plus"], 28);
  EXPECT_EQ(row["W_minus"], 0);
  EXPECT_EQ(row["p_exact_two"], 2.0 / 128);
  EXPECT_EQ(row["p_holm"], 2.0 / 128);
  EXPECT_EQ(row["rank_biserial"], 1);
  EXPECT_NEAR(row["hl"], 0.004, 1e-12);
  EXPECT_NEAR(row["hl_ci"][0], 0.002, 1e-12);
  EXPECT_NEAR(row["hl_ci"][1], 0.006, 1e-12);
}

TEST(Report, PutsEveryFileInItsPlace) {
  const TestFolder folder;
  make(folder, "a.db", 6, 0.001);
  report(folder);
  for (const char* file : {"report.html", "report.json", "figures/d_final.svg",
                           "figures/d_final.pdf", "figures/time_s.svg", "figures/time_s.pdf",
                           "tables/comparisons.csv", "tables/trials.csv"}) {
    EXPECT_TRUE(fs::is_regular_file(folder.file("out") + "/" + file)) << file;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.file("")), {}), 2) << "a.db and out";
}

TEST(Report, GivesTheStatusOfEveryoneAndTheReasonOfWhoIsExcluded) {
  const TestFolder folder;
  make(folder, "a.db", 2, 0.001);
  write_file(folder.file("x.csv"), "P2,\"spoke, slept\"\n");
  report(folder, {false, false, folder.file("x.csv")});
  EXPECT_EQ(read_file(folder.file("out/tables/participants.csv")),
            "participant,status,reason,simulated,pilot,station,sequence,study_version\n"
            "P1,analysed,,0,0,1,0,1\nP2,excluded,\"spoke, slept\",0,0,1,0,1\n");
}

TEST(Report, IsTheSameByteForByteWhenMadeAgain) {
  const TestFolder folder;
  make(folder, "a.db", 8, 0.002);
  write_report({{folder.file("a.db")}, folder.file("one"), {}, {}});
  write_report({{folder.file("a.db")}, folder.file("two"), {}, {}});
  EXPECT_EQ(contents(folder.file("one")), contents(folder.file("two")));
}

TEST(Report, MadeAgainSaysNothing) {
  const TestFolder folder;
  make(folder, "a.db", 6, 0.001);
  const ReportOptions options{{folder.file("a.db")}, folder.file("out"), {}, {}};
  EXPECT_TRUE(write_report(options).empty());
  EXPECT_TRUE(write_report(options).empty());
}

TEST(Report, ListsWhatIsDifferentFromTheOneBefore) {
  const TestFolder folder;
  make(folder, "a.db", 6, 0.001);
  const ReportOptions options{{folder.file("a.db")}, folder.file("out"), {}, {}};
  write_report(options);
  const std::string file = folder.file("out/report.json");
  auto before = nlohmann::ordered_json::parse(read_file(file));
  before["program_version"] = "0.0.9";
  before["wilcoxon"][0]["hl"] = 1;
  write_file(file, before.dump());
  const ReportNotes notes = write_report(options);
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_EQ(notes[0], file + " was there before; 2 values differ:");
  EXPECT_NE(notes[1].find("\"0.0.9\" -> "), std::string::npos) << notes[1];
  EXPECT_NE(notes[2].find(".hl: 1 -> "), std::string::npos) << notes[2];
}

TEST(Report, ReplacesAnOlderOneAndLeavesOtherFilesAlone) {
  const TestFolder folder;
  make(folder, "a.db", 6, 0.001);
  write_file(folder.file("out/report.html"), "old");
  write_file(folder.file("out/notes.txt"), "mine");
  report(folder);
  EXPECT_NE(read_file(folder.file("out/report.html")), "old");
  EXPECT_EQ(read_file(folder.file("out/notes.txt")), "mine");
}

TEST(Report, SaysWhyThereIsNoMap) {
  const TestFolder folder;
  make(folder, "a.db", 2, 0.001);
  ReportOptions options{{folder.file("a.db")}, folder.file("out"), {}, {}};
  options.registry = &study::toy::registry();
  write_report(options);
  EXPECT_NE(read_file(folder.file("out/report.html")).find("Where on the map people spent"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(folder.file("out/figures/map_time.svg")));
}

// In any case of letters, as a word of its own. Pictures inside the page do not count.
bool has_word(std::string text, const std::string& word) {
  for (auto at = text.find("base64,"); at != std::string::npos; at = text.find("base64,", at + 1)) {
    text.erase(at, text.find('"', at) - at);
  }
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  std::transform(text.begin(), text.end(), text.begin(), lower);
  const auto letter = [&](std::size_t i) {
    return i < text.size() && text[i] >= 'a' && text[i] <= 'z';
  };
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    if (!letter(at - 1) && !letter(at + word.size())) return true;
  }
  return false;
}

TEST(Report, NeverPrintsWhatIsNoNumber) {
  for (const auto& [people, step] : {std::pair{1, 0.0}, {1, 0.01}, {3, 0.0}, {12, 0.0}}) {
    const TestFolder folder;
    make(folder, "a.db", people, step);
    report(folder);
    for (const auto& [name, bytes] : contents(folder.file("out"))) {
      if (name.find(".pdf") != std::string::npos) continue;
      EXPECT_FALSE(has_word(bytes, "nan")) << name << " " << people;
      EXPECT_FALSE(has_word(bytes, "inf")) << name << " " << people;
    }
  }
}

TEST(Report, NotesValuesThatAreNotFinite) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    fill(log, 3, 0.001);
    log.database().exec("UPDATE trial SET d_final = 9e999 WHERE uuid = '1/1'");
  }
  EXPECT_EQ(report(folder)["caveats"].back(),
            "1 logged value is not finite and taken for missing.");
}

TEST(Report, ShowsNamesAsTextWhateverTheyHold) {
  const TestFolder folder;
  const std::string evil = "<script>alert(1)</script>";
  {
    ToyLog log(folder.file("a.db"));
    log.session({"<i>P1"}).trial({evil, "\"<b>\"", 10}).answer(evil, 3);
    log.trial({"it's `touch pwned`", "\"<b>\"", 12}).answer(evil, 4);
  }
  report(folder);
  const std::string page = read_file(folder.file("out/report.html"));
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("<b>\""), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(1)"), std::string::npos);
}

TEST(Report, RefersToNothingOutsideItself) {
  const TestFolder folder;
  make(folder, "a.db", 6, 0.001);
  report(folder);
  const std::string page = read_file(folder.file("out/report.html"));
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_EQ(page.find("@import"), std::string::npos);
  EXPECT_EQ(page.find("url("), std::string::npos);
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Report, HasALineInItsContentsForEverySection) {
  const TestFolder folder;
  make(folder, "a.db", 6, 0.001);
  report(folder);
  const std::string page = read_file(folder.file("out/report.html"));
  const std::size_t start = page.find("aria-label=\"Contents\"");
  ASSERT_NE(start, page.npos);
  const std::string contents = page.substr(start, page.find("</nav>", start) - start);
  EXPECT_EQ(occurrences(contents, "<li>"), occurrences(page, "<h2 id="));
}

TEST(Report, SaysNearTheTopWhereToReadWhoIsExcludedAndWhy) {
  const TestFolder folder;
  make(folder, "a.db", 6, 0.001);
  write_file(folder.file("x.csv"), "code,reason,rule,date\nP2,slept,by hand,2026-11-01\n");
  report(folder, {false, false, folder.file("x.csv")});
  const std::string page = read_file(folder.file("out/report.html"));
  EXPECT_LT(page.find("<a href=\"#excluded-participants\">1 excluded"),
            page.find("id=\"figures\""));
  EXPECT_LT(page.find("<h2 id=\"excluded-participants\""), page.find("by hand"));
}

TEST(Cells, FoldATableOfDetailsOnlyWhereItIsLong) {
  HtmlTable table{"All of them. In full.", {"a"}, {{"1"}}, {}};
  EXPECT_EQ(folded(table).code, wide(table).code);
  table.rows.resize(100, {"1"});
  EXPECT_NE(folded(table).code.find("<summary>Show 100 rows: All of them</summary>"),
            std::string::npos);
}

TEST(Report, ShowsAStripeOnlyWhenSomethingIsSimulated) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({"P1"}).trial({}).session({"S1", "finished", true}).trial({});
  }
  report(folder);
  EXPECT_EQ(read_file(folder.file("out/report.html")).find("class=\"stripe\""), std::string::npos);
  const Json json = report(folder, {true, false, ""});
  EXPECT_NE(read_file(folder.file("out/report.html")).find("1 of 2 participants are simulated"),
            std::string::npos);
  EXPECT_EQ(json["participants"]["analysed"], 2);
}

void expect_nothing(const TestFolder& folder, const std::string& hint) {
  try {
    report(folder);
    FAIL() << "there was nothing to report";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(hint), std::string::npos) << error.what();
  }
  EXPECT_FALSE(fs::exists(folder.file("out")));
}

TEST(Report, OfNothingFinishedSaysSoAndWritesNothing) {
  const TestFolder folder;
  { ToyLog log(folder.file("a.db")); }
  expect_nothing(folder, "holds no finished trial");
}

TEST(Report, OfPracticeAloneSaysSo) {
  const TestFolder folder;
  { ToyLog(folder.file("a.db")).session({}).trial({.practice = true}); }
  expect_nothing(folder, "holds no finished trial");
}

TEST(Report, OfSimulatedPeopleAloneSaysHowToIncludeThem) {
  const TestFolder folder;
  { ToyLog(folder.file("a.db")).session({"S1", "finished", true}).trial({}); }
  expect_nothing(folder, "1 simulated participant is left out, add --include-simulated");
}

TEST(Report, OfUnfinishedSessionsSaysSo) {
  const TestFolder folder;
  { ToyLog(folder.file("a.db")).session({"P1", "stopped"}).trial({}); }
  expect_nothing(folder, "of a finished session");
}

TEST(Report, SaysHowFarItIs) {
  const TestFolder folder;
  make(folder, "a.db", 6, 0.001);
  std::map<std::string, std::vector<int>> seen;
  write_report({{folder.file("a.db")}, folder.file("out"), {}, [&](auto& what, int done, int) {
                  seen[what].push_back(done);
                  return true;
                }});
  EXPECT_EQ(seen["figures drawn:"].front(), 0);
  EXPECT_EQ(seen["figures drawn:"].back(), 10);
  EXPECT_EQ(seen["comparisons made:"].back(), 6 * 3) << "6 measures; mean, pooled, one target";
}

TEST(Report, StopsWhenAskedAndLeavesNothingBehind) {
  for (const std::string when : {"figures drawn:", "comparisons made:"}) {
    const TestFolder folder;
    make(folder, "a.db", 6, 0.001);
    const auto stop = [&](const std::string& what, int done, int) {
      return what != when || done < 1;
    };
    EXPECT_THROW(write_report({{folder.file("a.db")}, folder.file("out"), {}, stop}), OutsideError);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.file("")), {}), 1) << "a.db alone";
  }
}

TEST(Report, DoesNotOverwriteAFile) {
  const TestFolder folder;
  make(folder, "a.db", 2, 0);
  write_file(folder.file("out"), "precious");
  EXPECT_THROW(report(folder), InputError);
  EXPECT_EQ(read_file(folder.file("out")), "precious");
}

}  // namespace
}  // namespace promenade::analysis
