// What a report says about people, sessions and questionnaires, from databases to files.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analysis/report/report.h"
#include "motion/files.h"
#include "study/load_instrument.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

using Json = nlohmann::json;

void give(ToyLog& log, const std::string& session, const std::string& instrument,
          const std::string& item, double value, const std::string& text = "") {
  static int now = 0;
  study::Statement row(log.database(),
                       "INSERT INTO answer(session, instrument, version, item, value, text, "
                       "declined, touched, t_us, asked) VALUES (?,?,'1',?,?,?,0,1,?,'end')");
  row.bind(1, session).bind(2, instrument).bind(3, item).bind(4, value).bind(5, text);
  row.bind(6, ++now).run();
}

void keep_instrument(ToyLog& log, const std::string& name) {
  study::Statement row(log.database(), "INSERT INTO study_part SELECT uuid, ?, ? FROM study");
  row.bind(1, "instruments/" + name + ".toml");
  row.bind_blob(2, *study::embedded_instrument(name)).run();
}

class PeopleSections : public ::testing::Test {
 protected:
  Json report(const SelectionOptions& selection = {}) {
    write_report({files, folder.file("out"), selection, {}});
    return Json::parse(read_file(folder.file("out/report.json")));
  }
  std::string page() const { return read_file(folder.file("out/report.html")); }
  bool shows(const std::string& words) const { return page().find(words) != std::string::npos; }
  TestFolder folder;
  std::vector<std::string> files = {folder.file("a.db")};
};

// SUS: 5 to the good items and 1 to the bad ones is 100; 3 to all is 50.
void answer_sus(ToyLog& log, const std::string& session, bool best) {
  const auto file = study::load_instrument("sus", "");
  for (const study::ScoreItem& one : file.instrument.scores[0].items) {
    give(log, session, "sus", one.item, !best ? 3 : one.reversed ? 1 : 5);
  }
}

TEST_F(PeopleSections, ScoreInstrumentsWithTheirCitation) {
  {
    ToyLog log(files[0]);
    fill(log, 2, 0.001);
    keep_instrument(log, "sus");
    answer_sus(log, "1", true);
    answer_sus(log, "2", false);
  }
  const Json scale = report()["questionnaires"]["scales"][0];
  EXPECT_EQ(scale["instrument"], "sus");
  EXPECT_EQ(scale["kind"], "score");
  EXPECT_EQ(scale["mean"], 75);
  EXPECT_EQ(scale["n"], 2);
  EXPECT_TRUE(shows("J. Brooke"));
}

TEST_F(PeopleSections, CountASessionOfTwoFilesOnce) {
  {
    ToyLog log(files[0]);
    fill(log, 2, 0.001);
    keep_instrument(log, "sus");
    answer_sus(log, "1", true);
  }
  write_file(folder.file("b.db"), read_file(files[0]));
  files.push_back(folder.file("b.db"));
  EXPECT_EQ(report()["questionnaires"]["instruments"][0]["pages"], 1);
}

TEST_F(PeopleSections, NeverShowWhatPeopleWrote) {
  {
    ToyLog log(files[0]);
    fill(log, 2, 0.001);
    keep_instrument(log, "preference");
    give(log, "1", "preference", "reason", 0, "My name is Ann");
  }
  EXPECT_EQ(report()["questionnaires"]["instruments"][0]["free_answers"]["reason"], 1);
  EXPECT_FALSE(shows("is Ann"));
  EXPECT_TRUE(shows("1 free answer is not printed"));
}

TEST_F(PeopleSections, SayOnTheFirstPageWhetherConclusionsHold) {
  { fill(*std::make_unique<ToyLog>(files[0]), 8, 0.001); }
  write_file(folder.file("x.csv"), "P2,slept\n");
  const Json json = report({false, false, folder.file("x.csv")});
  EXPECT_EQ(json["sensitivity"]["sentences"][0], "Without P2: same conclusions.");
  EXPECT_TRUE(shows("<a href=\"#sensitivity\">Without P2: same conclusions.</a>"));
  EXPECT_TRUE(shows("id=\"sensitivity\""));
}

TEST_F(PeopleSections, ShowNoShowsInTheFlow) {
  {
    ToyLog log(files[0]);
    fill(log, 2, 0.001);
    log.database().exec("INSERT INTO roster VALUES ('P9', '1', 0, 'no_show', NULL, '')");
  }
  EXPECT_EQ(report()["participants"]["no_show"], 1);
  EXPECT_TRUE(shows("1 no-show</li>"));
}

TEST_F(PeopleSections, SpeakOfNoRosterWhereThereIsNone) {
  { fill(*std::make_unique<ToyLog>(files[0]), 2, 0.001); }
  EXPECT_TRUE(report()["participants"]["booked"].is_null());
  EXPECT_FALSE(shows(" no-show</li>"));
}

TEST_F(PeopleSections, ListEveryTrialWithItsFlags) {
  {
    ToyLog log(files[0]);
    log.session({}).trial({});
    log.database().exec("UPDATE trial SET paused_us = 1");
  }
  EXPECT_EQ(report()["quality"]["counts"][0]["flagged"], 1);
  EXPECT_NE(read_file(folder.file("out/tables/quality.csv")).find("1/1,1,labels,match,happy"),
            std::string::npos);
}

TEST_F(PeopleSections, StandEvenForOnePersonWithOneInterface) {
  { ToyLog(files[0]).session({}).trial({.outcome = "timeout"}); }
  report();
  EXPECT_TRUE(shows("There is no pair of interfaces whose comparison could change."));
  EXPECT_TRUE(shows("no order to balance"));
}

}  // namespace
}  // namespace promenade::analysis
