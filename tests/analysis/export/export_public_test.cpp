#include "analysis/export/export_public.h"

#include <gtest/gtest.h>

#include "motion/problem.h"
#include "study/csv.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

using study::ItemKind;
using study::Statement;

study::Instrument about_you() {
  study::Instrument instrument;
  instrument.name = "demographics";
  study::Item gender;
  gender.name = "gender";
  gender.kind = ItemKind::choice;
  gender.choices = {{"woman", {}}, {"man", {}}, {"other", {}}};
  study::Item age;
  age.name = "age";
  age.kind = ItemKind::number;
  study::Item comment;
  comment.name = "comment";
  comment.kind = ItemKind::text;
  instrument.items = {gender, age, comment};
  return instrument;
}

void tell(ToyLog& log, const std::string& session, const std::string& item, double value,
          const std::string& text = "") {
  Statement row(log.database(),
                "INSERT INTO answer(session, instrument, version, item, value, text, declined, "
                "touched, t_us, asked) VALUES (?,'demographics','1',?,?,?,0,1,5,'start')");
  row.bind(1, session).bind(2, item).bind(3, value);
  text.empty() ? row.bind_null(4) : row.bind(4, text);
  row.run();
}

// People of one gender and age each.
void fill_people(ToyLog& log, int first, int count, double gender, const char* name, double age) {
  for (int i = first; i < first + count; ++i) {
    log.session({"LAB" + std::to_string(i)}).trial({});
    tell(log, std::to_string(i), "gender", gender, name);
    tell(log, std::to_string(i), "age", age);
  }
}

std::vector<std::string> column(study::Database& database, const std::string& sql) {
  Statement row(database, sql);
  std::vector<std::string> values;
  while (row.step()) values.push_back(row.text(0));
  return values;
}

struct Published {
  ExportSource source;
  PublicData data;
};

Published publish(ToyLog& log, const ReviewedAnswers& reviewed = {}) {
  Published one{{log.database(), read_log(log.database()), {}, {about_you()}, false}, {}};
  one.data = make_public(one.source, reviewed);
  return one;
}

class Public : public ::testing::Test {
 protected:
  TestFolder folder;
  ToyLog log{folder.file("a.db")};
};

TEST_F(Public, GivesPeopleNewCodesByChance) {
  log.session({"LAB1"}).trial({}).session({"LAB2"}).trial({});
  const Published one = publish(log);
  const auto codes = column(log.database(), "SELECT code FROM participant");
  ASSERT_EQ(codes.size(), 2u);
  for (const std::string& code : codes) EXPECT_EQ(code.find("LAB"), std::string::npos);
  EXPECT_NE(codes[0], codes[1]);
  EXPECT_EQ(one.source.log.sessions[0].code.size(), 6u);
}

TEST_F(Public, ShowsNoDateStationMachineOrSeed) {
  log.session({"LAB1"}).trial({});
  publish(log);
  for (const char* hidden : {"station", "machine", "seed", "sequence", "started_utc", "ended_utc",
                             "process", "process_start"}) {
    EXPECT_FALSE(has_column(log.database(), "session", hidden)) << hidden;
  }
  EXPECT_FALSE(has_column(log.database(), "study", "config_text"));
  EXPECT_FALSE(has_column(log.database(), "study", "created_utc"));
}

TEST_F(Public, NamesTrialsAfterTheNewCode) {
  log.session({"LAB1"}).trial({}).trial({});
  const Published one = publish(log);
  const std::string code = one.source.log.sessions[0].code;
  EXPECT_EQ(column(log.database(), "SELECT uuid FROM trial ORDER BY 1"),
            (std::vector<std::string>{code + "-01-001", code + "-01-002"}));
  EXPECT_EQ(column(log.database(), "SELECT DISTINCT session FROM trial"),
            (std::vector<std::string>{code + "-01"}));
}

TEST_F(Public, LeavesOutWhoDeclinedOrWithdrew) {
  log.session({"LAB1", "declined"}).session({"LAB2"}).trial({});
  log.session({"LAB2", "withdrawn"}).trial({}).session({"LAB3"}).trial({});
  const Published one = publish(log);
  EXPECT_EQ(column(log.database(), "SELECT uuid FROM session").size(), 1u);
  EXPECT_EQ(column(log.database(), "SELECT uuid FROM trial").size(), 1u);
  EXPECT_EQ(one.data.left_out_people, 2);
}

TEST_F(Public, GroupsAgesByTenYears) {
  fill_people(log, 1, 5, 1, "woman", 27);
  publish(log);
  EXPECT_EQ(column(log.database(), "SELECT DISTINCT text FROM answer WHERE item = 'age'"),
            (std::vector<std::string>{"20-29"}));
  EXPECT_EQ(
      column(log.database(), "SELECT value FROM answer WHERE item = 'age' AND value > 0").size(),
      0u);
}

TEST_F(Public, HidesTheDemographicsOfSmallCells) {
  fill_people(log, 1, 7, 1, "woman", 27);
  fill_people(log, 8, 5, 2, "man", 34);
  fill_people(log, 13, 1, 2, "man", 71);
  const Published one = publish(log);
  EXPECT_EQ(column(log.database(), "SELECT text FROM answer WHERE item = 'gender'"),
            std::vector<std::string>(7, "woman"))
      << "the cell of one, and the next one, so that nobody can tell who is alone";
  EXPECT_EQ(cells_csv(one.data.questions, one.data.cells),
            "simulated,demographics.age,demographics.gender,people\n0,20-29,woman,7\n"
            "(suppressed),(suppressed),(suppressed),6\n");
}

TEST_F(Public, DoesNotHidePeopleAmongSimulatedOnes) {
  fill_people(log, 1, 1, 1, "woman", 27);
  fill_people(log, 2, 9, 1, "woman", 27);
  log.database().exec("UPDATE session SET simulated = 1 WHERE uuid <> '1'");
  publish(log);
  EXPECT_EQ(column(log.database(), "SELECT text FROM answer WHERE item = 'gender'").size(), 9u);
}

TEST_F(Public, LeavesWordsOutUnlessTheyWereReviewed) {
  log.session({"LAB1"}).session({"LAB2"});
  tell(log, "1", "comment", 0, "I am Kim");
  tell(log, "2", "comment", 0, "nice");
  const Published one = publish(log, {{"2", "demographics", "comment", "nice"}});
  EXPECT_EQ(column(log.database(), "SELECT text FROM answer WHERE text IS NOT NULL"),
            (std::vector<std::string>{"nice"}));
  EXPECT_EQ(one.data.withheld_texts, 1);
}

TEST_F(Public, KeepsTheChoiceButNotTheWordsForIt) {
  log.session({"LAB1"});
  tell(log, "1", "gender", 3, "my own words");
  study::Instrument late = about_you();
  late.name = "late";
  log.database().exec("UPDATE answer SET instrument = 'late', asked = 'end'");
  ExportSource source{log.database(), read_log(log.database()), {}, {late}, false};
  make_public(source, {});
  EXPECT_EQ(column(log.database(), "SELECT text FROM answer"), (std::vector<std::string>{"other"}));
}

TEST_F(Public, KeepsNothingFromTheStartThatItDoesNotKnow) {
  log.session({"LAB1"});
  tell(log, "1", "gender", 1, "woman");
  ExportSource source{log.database(), read_log(log.database()), {}, {}, false};
  make_public(source, {});
  EXPECT_TRUE(column(log.database(), "SELECT item FROM answer").empty());
}

TEST_F(Public, ShowsNoWordsOfEvents) {
  log.session({"LAB1"}).trial({});
  log.database().exec(
      "INSERT INTO event(session, seq, t_us, uncertainty_us, actor, kind, target, value, detail) "
      "VALUES ('1', 1, 1, 0, 'participant', 'answer', 'age', 27, '{\"text\":\"Kim\"}'), "
      "('1', 2, 2, 0, 'experimenter', 'note', 'Kim', 1, '{\"text\":\"Kim\"}'), "
      "('1', 3, 3, 0, 'participant', 'filter', 'list', 1, "
      "'{\"applied\":true,\"share\":0.30000000000000004,\"text\":\"Kim\"}')");
  publish(log);
  EXPECT_EQ(column(log.database(),
                   "SELECT coalesce(target, '-') || coalesce(value, '-') || "
                   "coalesce(detail, '-') FROM event ORDER BY seq"),
            (std::vector<std::string>{"age--", "-1.0-",
                                      "list1.0{\"applied\":true,\"share\":0.30000000000000004}"}));
}

TEST_F(Public, HasNoRosterTombstonesBackupsOrReceipts) {
  publish(log);
  for (const char* table : {"roster", "tombstone", "backup", "receipt", "study_part"}) {
    EXPECT_TRUE(column(log.database(),
                       "SELECT name FROM temp.sqlite_schema WHERE type = 'view' "
                       "AND name = '" +
                           std::string(table) + "'")
                    .empty());
  }
}

TEST_F(Public, RefusesAReviewOfWhatNobodySaid) {
  log.session({"LAB1"});
  tell(log, "1", "comment", 0, "nice");
  const std::string head = "session,instrument,item,text\n";
  EXPECT_EQ(parse_reviewed("r.csv", head + "1,demographics,comment,nice\n", log.database()).size(),
            1u);
  EXPECT_THROW(parse_reviewed("r.csv", head + "1,demographics,comment,Nice\n", log.database()),
               InputError);
  EXPECT_THROW(parse_reviewed("r.csv", "session,item,text\n", log.database()), InputError);
}

}  // namespace
}  // namespace promenade::analysis
