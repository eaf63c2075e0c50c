#include "analysis/export/export_wide.h"

#include <gtest/gtest.h>

#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

using study::Statement;

// Two scales of 0 to 10, and their mean.
study::Instrument load() {
  study::Instrument instrument;
  instrument.name = "load";
  for (const char* name : {"effort", "time"}) {
    study::Item item;
    item.name = name;
    item.least = 0;
    item.most = 10;
    instrument.items.push_back(item);
  }
  study::Score score;
  score.name = "all";
  score.items = {{"effort", false, ""}, {"time", false, ""}};
  instrument.scores = {score};
  return instrument;
}

struct Given {
  std::string item;
  double value = 0;
  std::string asked = "end", interface = "", text = "", session = "1";
  bool about_trial = false;
};

int now = 0;

void give(ToyLog& log, const Given& given) {
  Statement row(log.database(),
                "INSERT INTO answer(session, trial, instrument, version, item, value, text, "
                "declined, touched, t_us, asked, interface) "
                "VALUES (?,?,'load','1',?,?,nullif(?,''),0,1,?,?,nullif(?,''))");
  row.bind(1, given.session);
  given.about_trial ? row.bind(2, given.session + "/1") : row.bind_null(2);
  row.bind(3, given.item).bind(4, given.value).bind(5, given.text).bind(6, ++now);
  row.bind(7, given.asked).bind(8, given.interface).run();
}

class Wide : public ::testing::Test {
 protected:
  std::string cell(const std::string& column) {
    ExportSource source{log.database(), read_log(log.database()), {}, {load()}, false};
    source.selection = select(source.log, {});
    for (const WideColumn& one : make_wide(source).columns) {
      if (one.name == column) return one.cells.at(0);
    }
    return "(no such column)";
  }
  TestFolder folder;
  ToyLog log{folder.file("a.db")};
};

TEST_F(Wide, HasAnswersAndScoresOfWhatWasAskedOnce) {
  log.session({}).trial({});
  give(log, {"effort", 4});
  give(log, {"time", 7});
  EXPECT_EQ(cell("load.effort"), "4");
  EXPECT_EQ(cell("load.all"), "5.5");
}

TEST_F(Wide, TellsInterfacesApart) {
  log.session({}).trial({});
  give(log, {"effort", 4, "block", "labels"});
  give(log, {"effort", 9, "block", "weights"});
  EXPECT_EQ(cell("load.effort.labels"), "4");
  EXPECT_EQ(cell("load.effort.weights"), "9");
}

TEST_F(Wide, TellsMomentsApart) {
  log.session({}).trial({});
  give(log, {"effort", 1, "start"});
  give(log, {"effort", 2, "end"});
  EXPECT_EQ(cell("load.effort.start"), "1");
  EXPECT_EQ(cell("load.effort.end"), "2");
}

TEST_F(Wide, TakesTheLastOfTwoAnswers) {
  log.session({}).trial({});
  give(log, {"effort", 1});
  give(log, {"effort", 3});
  EXPECT_EQ(cell("load.effort"), "3");
}

TEST_F(Wide, HasNoScoreWhereAnAnswerIsMissing) {
  log.session({}).trial({});
  give(log, {"effort", 1});
  EXPECT_EQ(cell("load.all"), "(no such column)");
}

TEST_F(Wide, ScoresWhatWasAskedAboutATrial) {
  log.session({}).trial({});
  give(log, {"effort", 2, "trial", "", "", "1", true});
  give(log, {"time", 8, "trial", "", "", "1", true});
  EXPECT_EQ(cell("load.all.match.labels"), "5");
  EXPECT_EQ(cell("load.all.match.labels.happy"), "5");
  EXPECT_EQ(cell("effort.match.labels"), "2") << "the answer itself is a measure of the trial";
}

TEST_F(Wide, LeavesOutAnswersAboutTrialsThatWereDoneAgain) {
  log.session({}).trial({}).trial({});
  give(log, {"effort", 2, "trial", "", "", "1", true});
  give(log, {"time", 8, "trial", "", "", "1", true});
  log.database().exec("UPDATE trial SET superseded = 1 WHERE uuid = '1/1'");
  EXPECT_EQ(cell("load.all.match.labels"), "(no such column)");
}

TEST_F(Wide, GivesAChoiceByItsName) {
  log.session({}).trial({});
  give(log, {"effort", 2, "end", "", "some"});
  EXPECT_EQ(cell("load.effort"), "some");
}

TEST_F(Wide, HasTheProcessMeasuresOfTheTrials) {
  log.session({}).trial({}).trial({.target = "sad"});
  log.database().exec("UPDATE trial SET path_m = position, reversals = 3");
  EXPECT_EQ(cell("path_m.match.labels"), "1.5");
  EXPECT_EQ(cell("path_m.match.labels.sad"), "2");
  EXPECT_EQ(cell("reversals.match.labels"), "3");
}

TEST_F(Wide, HasNoProcessMeasuresOfTrialsThatWereDoneAgain) {
  log.session({}).trial({}).trial({});
  log.database().exec(
      "UPDATE trial SET path_m = position, superseded = position - 1, position = 1");
  EXPECT_EQ(cell("path_m.match.labels"), "1");
}

}  // namespace
}  // namespace promenade::analysis
