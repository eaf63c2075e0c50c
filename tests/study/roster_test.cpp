#include "study/roster.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "motion/problem.h"
#include "study/balance.h"
#include "study/person_code.h"
#include "study/schema.h"
#include "study/sqlite.h"
#include "toy.h"

namespace promenade::study {
namespace {

Study study_of(int interfaces, Order order = Order::williams) {
  Study study;
  study.order = order;
  study.seed = 5;
  Task task;
  for (int i = 0; i < interfaces; ++i) {
    study.interfaces.push_back({std::to_string(i), "pick", {}, nullptr});
    task.interfaces.push_back(i);
  }
  task.targets.resize(1);
  study.tasks = {task};
  return study;
}

std::vector<RosterRow> roster(const Study& study, int participants, int stations) {
  std::vector<RosterRow> rows;
  extend_roster("r.csv", study, participants, stations, rows);
  return rows;
}

template <typename Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

Balance balance_at(const Study& study, const std::vector<RosterRow>& rows,
                   const std::string& station) {
  std::vector<Plan> plans;
  for (const RosterRow& row : rows) {
    if (station.empty() || row.station == station) plans.push_back(make_plan(study, row.sequence));
  }
  return balance_of(study, plans);
}

TEST(ExtendRoster, GivesEveryoneACodeOfTheirOwn) {
  const std::vector<RosterRow> rows = roster(study_of(4), 500, 3);
  std::set<std::string> codes;
  for (const RosterRow& row : rows) {
    EXPECT_TRUE(is_person_code(row.code));
    codes.insert(row.code);
  }
  EXPECT_EQ(codes.size(), 500U);
}

// Whole rounds at every station: every count is equal.
TEST(ExtendRoster, BalancesTheTotalAndEachStation) {
  for (int n = 2; n <= 5; ++n) {
    for (int stations = 1; stations <= 5; ++stations) {
      for (int rounds = 1; rounds <= 2; ++rounds) {
        const Study study = study_of(n);
        const int round = round_of_design(study);
        const auto rows = roster(study, round * stations * rounds, stations);
        EXPECT_TRUE(balance_at(study, rows, "").even);
        for (int s = 1; s <= stations; ++s) {
          const Balance balance = balance_at(study, rows, std::to_string(s));
          EXPECT_TRUE((balance.position.array() == round * rounds / n).all()) << n << stations;
          EXPECT_TRUE(balance.even) << n << " interfaces, station " << s << " of " << stations;
        }
      }
    }
  }
}

int spread_of(const std::map<int, int>& counts, int kinds) {
  int least = static_cast<int>(counts.size()) < kinds ? 0 : INT32_MAX;
  int most = 0;
  for (const auto& [kind, count] : counts) {
    least = std::min(least, count);
    most = std::max(most, count);
  }
  return counts.empty() ? 0 : most - least;
}

// At any time, however many have come: people, and orders at each station, differ by one.
TEST(DealStations, StaysEvenWhilePeopleCome) {
  for (const int cells : {1, 2, 3, 4, 6, 8, 10, 12}) {
    for (int stations = 1; stations <= 8; ++stations) {
      const auto dealt = deal_stations({cells, cells}, 3 * cells * stations + 5, stations);
      std::map<int, int> people;
      std::map<int, std::map<int, int>> orders;
      for (std::size_t s = 0; s < dealt.size(); ++s) {
        ++people[dealt[s]];
        ++orders[dealt[s]][static_cast<int>(s) % cells];
        ASSERT_LE(spread_of(people, stations), 1);
        ASSERT_LE(spread_of(orders[dealt[s]], cells), 1) << cells << " " << stations;
      }
    }
  }
}

TEST(DealStations, GivesOrdersEvenlyBeforeListsWhereThereAreLists) {
  for (int stations = 1; stations <= 8; ++stations) {
    const auto dealt = deal_stations({4, 16}, 16 * stations, stations);
    std::map<int, std::map<int, int>> orders;
    for (std::size_t s = 0; s < dealt.size(); ++s) {
      ++orders[dealt[s]][static_cast<int>(s) % 4];
      ASSERT_LE(spread_of(orders[dealt[s]], 4), 2) << stations;
    }
  }
}

TEST(ExtendRoster, AddsPeopleBehindThoseWhoAreThere) {
  const Study study = study_of(3);
  std::vector<RosterRow> rows = roster(study, 10, 2);
  extend_roster("r.csv", study, 15, 2, rows);
  const std::vector<RosterRow> whole = roster(study, 15, 2);
  ASSERT_EQ(rows.size(), 15U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].code, whole[i].code);
    EXPECT_EQ(rows[i].station, whole[i].station);
  }
}

TEST(ExtendRoster, TakesNothingAway) {
  const Study study = study_of(3);
  std::vector<RosterRow> rows = roster(study, 10, 2);
  EXPECT_EQ(refusal([&] { extend_roster("r.csv", study, 9, 2, rows); }),
            "r.csv: error: has places for 10 people already; rows are never taken away");
  EXPECT_NE(refusal([&] { extend_roster("r.csv", study, 12, 3, rows); }).find("dealt otherwise"),
            std::string::npos);
  EXPECT_EQ(rows.size(), 10U);
}

TEST(ReplacePerson, GivesTheSamePlaceToANewCode) {
  const Study study = study_of(4);
  std::vector<RosterRow> rows = roster(study, 8, 2);
  const std::string old = rows[3].code;
  const RosterRow added = replace_person("r.csv", study, old, rows);
  EXPECT_EQ(rows[3].state, Attendance::replaced);
  EXPECT_EQ(added.replaces, old);
  EXPECT_EQ(added.sequence, rows[3].sequence);
  EXPECT_EQ(added.station, rows[3].station);
  EXPECT_TRUE(is_person_code(added.code));
  EXPECT_EQ(rows.size(), 9U);
  extend_roster("r.csv", study, 9, 2, rows);
  EXPECT_EQ(rows.back().sequence, 8);
}

TEST(ReplacePerson, RefusesThoseWhoCameAndThoseWhoWereReplaced) {
  const Study study = study_of(2);
  std::vector<RosterRow> rows = roster(study, 2, 1);
  rows[0].state = Attendance::done;
  EXPECT_NE(refusal([&] { replace_person("r.csv", study, rows[0].code, rows); }), "");
  EXPECT_NE(refusal([&] { mark_no_show("r.csv", rows[0].code, rows); }), "");
  const std::string code = rows[1].code;
  replace_person("r.csv", study, code, rows);
  EXPECT_NE(refusal([&] { replace_person("r.csv", study, code, rows); }), "");
}

TEST(FindPerson, TakesACodeAsItIsTypedAndTellsWhichWasMeant) {
  std::vector<RosterRow> rows = roster(study_of(2), 4, 1);
  rows[1].code = "K7QX3";  // whether its check holds is the reader's business
  EXPECT_EQ(find_person("--participant", "k7q-x3", rows).sequence, 1);
  EXPECT_EQ(refusal([&] { find_person("--participant", "K7QX4", rows); }),
            "--participant: error: \"K7QX4\" is not a code of this roster; did you mean "
            "\"K7QX3\"?");
}

TEST(FindPerson, NamesWhoReplacedSomebody) {
  const Study study = study_of(2);
  std::vector<RosterRow> rows = roster(study, 2, 1);
  const std::string old = rows[0].code;
  const std::string added = replace_person("r.csv", study, old, rows).code;
  EXPECT_EQ(refusal([&] { find_person("x", old, rows); }),
            "x: error: " + old + " was replaced by " + added);
  rows[1].state = Attendance::no_show;  // came after all
  EXPECT_EQ(find_person("x", rows[1].code, rows).sequence, 1);
}

TEST(RosterCsv, ComesBackAsItWas) {
  const Study study = study_of(3);
  std::vector<RosterRow> rows = roster(study, 7, 2);
  mark_no_show("r.csv", rows[2].code, rows);
  replace_person("r.csv", study, rows[2].code, rows);
  const std::string text = roster_csv(rows);
  EXPECT_EQ(roster_csv(read_roster("r.csv", text)), text);
  EXPECT_EQ(text.substr(0, text.find('\n')), "code,station,sequence,state,replaces");
}

std::string problems_of(const std::string& row) {
  const std::string head = "code,station,sequence,state,replaces\n";
  return refusal([&] { read_roster("r.csv", head + row + "\n"); });
}

TEST(ReadRoster, NamesEveryProblemWithItsPlace) {
  const std::string code = roster(study_of(2), 1, 1)[0].code;
  EXPECT_EQ(problems_of("AAAAA,1,0,booked,"),
            "r.csv:2:1: error: \"AAAAA\" is not a code: its "
            "check fails");
  EXPECT_EQ(problems_of(code + ",,x,boked,"),
            "r.csv:2:7: error: the station is empty\n"
            "r.csv:2:8: error: the sequence \"x\" is not a whole number from 0\n"
            "r.csv:2:10: error: the state \"boked\" must be one of \"booked\", \"done\", "
            "\"no_show\", \"replaced\"; did you mean \"booked\"?");
  EXPECT_EQ(problems_of(code + ",1,0,booked,BBBBB"),
            "r.csv:2:18: error: there is no code \"BBBBB\" that could be replaced");
  EXPECT_NE(problems_of(code + ",1,0,booked,\n" + code + ",1,1,booked,").find("twice"),
            std::string::npos);
  EXPECT_EQ(refusal([] { read_roster("r.csv", "codes,station,sequence,state,replaces\n"); }),
            "r.csv:1:1: error: there is no column \"code\"; is it \"codes\"?");
  EXPECT_EQ(problems_of(code + ",1,0,booked"), "");  // as spreadsheets save it
}

TEST(MarkDone, KnowsWhoFinishedBeforeTheRowWasWritten) {
  Database database(":memory:", Database::Mode::create);
  create_tables(database);
  std::vector<RosterRow> rows = roster(study_of(2), 2, 1);
  database.exec("PRAGMA foreign_keys = OFF");
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string number = std::to_string(i);
    database.exec("INSERT INTO participant VALUES ('p" + number + "', '" + rows[i].code + "')");
    database.exec(
        "INSERT INTO session(uuid, study, participant, station, seed, sequence, language, "
        "started_utc, outcome, simulated, pilot, machine) VALUES ('s" +
        number + "', 'x', 'p" + number + "', '1', 0, " + number + ", 'en', '', 'finished', 0, " +
        number + ", '{}')");
  }
  EXPECT_EQ(mark_done(database, rows), 1) << "the second is a pilot";
  EXPECT_EQ(rows[0].state, Attendance::done);
}

TEST(StoreRow, KeepsOneRowForEachCode) {
  Database database(":memory:", Database::Mode::create);
  create_tables(database);
  std::vector<RosterRow> rows = roster(study_of(2), 2, 1);
  store_row(database, rows[0], "2026-11-22T16:00:00Z");
  RosterRow done = rows[0];
  done.state = Attendance::done;
  store_row(database, done, "2026-11-22T17:00:00Z");
  Statement all(database, "SELECT count(*), max(state) FROM roster");
  ASSERT_TRUE(all.step());
  EXPECT_EQ(all.integer(0), 1);
  EXPECT_EQ(all.text(1), "done");
  EXPECT_EQ(mark_done(database, rows), 1);
  EXPECT_EQ(rows[0].state, Attendance::done);
  EXPECT_NE(refusal([&] { refuse_taken_place("x", database, rows[0], false); }), "");
  EXPECT_EQ(refusal([&] { refuse_taken_place("x", database, rows[1], false); }), "");
}

}  // namespace
}  // namespace promenade::study
