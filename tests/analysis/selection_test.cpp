#include "analysis/selection.h"

#include <gtest/gtest.h>

#include "motion/files.h"
#include "motion/problem.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

LoggedSession session(const std::string& code, const std::string& outcome,
                      const std::string& uuid = "") {
  LoggedSession result;
  result.uuid = uuid.empty() ? code + outcome : uuid;
  result.participant = code;
  result.code = code;
  result.outcome = outcome;
  return result;
}

std::string fates(const Selection& selection) {
  std::string text;
  for (const Person& person : selection.people) {
    text += person.code + ":" + std::to_string(static_cast<int>(person.disposition)) + " ";
  }
  return text;
}

TEST(Selection, GivesEveryoneOneDisposition) {
  Log log;
  log.sessions = {session("P1", "declined"), session("P2", "withdrawn"), session("P3", "stopped"),
                  session("P4", "running"), session("P5", "finished")};
  const Selection selection = select(log, {});
  EXPECT_EQ(fates(selection), "P1:0 P2:1 P3:2 P4:2 P5:4 ");
  EXPECT_EQ(selection.count(Disposition::unfinished), 2);
}

TEST(Selection, TakesTheFirstFinishedSessionOfAPerson) {
  Log log;
  log.sessions = {session("P1", "stopped"), session("P1", "finished", "x"),
                  session("P1", "finished", "y")};
  const Selection selection = select(log, {});
  ASSERT_EQ(selection.people.size(), 1u);
  EXPECT_EQ(selection.people[0].disposition, Disposition::analysed);
  EXPECT_EQ(selection.people[0].session, 1);
}

TEST(Selection, LeavesWhoWithdrewOutWhateverTheyFinished) {
  Log log;
  log.sessions = {session("P1", "finished"), session("P1", "withdrawn")};
  EXPECT_EQ(fates(select(log, {})), "P1:1 ");
}

TEST(Selection, LeavesOutSimulatedAndPilotUnlessAsked) {
  Log log;
  log.sessions = {session("P1", "finished"), session("S1", "finished"), session("T1", "finished")};
  log.sessions[1].simulated = true;
  log.sessions[2].pilot = true;
  const Selection strict = select(log, {});
  EXPECT_EQ(fates(strict), "P1:4 ");
  EXPECT_EQ(strict.left_out_simulated, 1);
  EXPECT_EQ(strict.left_out_pilot, 1);
  const Selection all = select(log, {true, true, ""});
  EXPECT_EQ(all.count(Disposition::analysed), 3);
  EXPECT_TRUE(all.any_simulated() && all.any_pilot());
}

TEST(Selection, PrefersTheRealSessionOfAPersonToAnEarlierPilot) {
  Log log;
  log.sessions = {session("P1", "finished", "pilot"), session("P1", "finished", "real"),
                  session("P2", "finished", "alone")};
  log.sessions[0].pilot = log.sessions[2].pilot = true;
  const Selection selection = select(log, {false, true, ""});
  EXPECT_EQ(selection.people[0].session, 1);
  EXPECT_FALSE(selection.people[0].pilot);
  EXPECT_EQ(selection.people[1].session, 2);
  EXPECT_TRUE(selection.people[1].pilot);
}

TEST(Selection, KeepsTheReasonOfEveryoneExcludedUnderASharedCode) {
  const TestFolder folder;
  write_file(folder.file("x.csv"), "P1,spoke\n");
  Log log;
  log.sessions = {session("P1", "finished"), session("P1", "finished", "x")};
  log.sessions[1].participant = "another";
  const Selection selection = select(log, {false, false, folder.file("x.csv")});
  EXPECT_EQ(fates(selection), "P1/1:3 P1/2:3 ");
  EXPECT_EQ(selection.people[0].reason, "spoke");
  EXPECT_EQ(selection.people[1].reason, "spoke");
}

TEST(Selection, TellsPeopleWithOneCodeInDifferentFilesApart) {
  Log log;
  log.sessions = {session("P1", "finished"), session("P1", "finished", "x")};
  log.sessions[1].participant = "another";
  const Selection selection = select(log, {});
  EXPECT_EQ(fates(selection), "P1/1:4 P1/2:4 ");
  EXPECT_EQ(selection.shared_codes, std::vector<std::string>{"P1"});
}

TEST(Selection, ExcludesWhoFinishedAndLeavesOthersWhatTheyAre) {
  const TestFolder folder;
  write_file(folder.file("x.csv"), "code,reason\nP1,\"spoke, slept\"\nP2,late\n");
  Log log;
  log.sessions = {session("P1", "finished"), session("P2", "declined"), session("P3", "finished")};
  const Selection selection = select(log, {false, false, folder.file("x.csv")});
  EXPECT_EQ(fates(selection), "P1:3 P2:0 P3:4 ");
  EXPECT_EQ(selection.exclusions[0].reason, "spoke, slept");
}

TEST(Selection, NamesTheLineOfACodeThatNobodyHas) {
  const TestFolder folder;
  write_file(folder.file("x.csv"), "P1\n\nP9,late\n");
  Log log;
  log.sessions = {session("P1", "finished")};
  try {
    select(log, {false, false, folder.file("x.csv")});
    FAIL() << "P9 does not exist";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 1u);
    EXPECT_EQ(error.problems()[0].line, 3);
  }
}

TEST(Exclusions, MayHaveAHeaderInCapitals) {
  EXPECT_EQ(parse_exclusions("x.csv", "CODE,REASON\nP1,\"slept,\nthen left\"\n").size(), 1u);
}

TEST(Exclusions, AreReadAsSpreadsheetsWriteThem) {
  const auto list = parse_exclusions("x.csv",
                                     "\xEF\xBB\xBF"
                                     "code,reason\r\n P1 , tired \r\n\r\nP2\r\n");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].code, "P1");
  EXPECT_EQ(list[0].reason, "tired");
  EXPECT_EQ(list[1].line, 4);
}

TEST(Exclusions, HaveTheColumnsThatAHeadingNames) {
  const auto list =
      parse_exclusions("x.csv",
                       "date,code,rule,reason\n2026-11-29,P1,flagged,\"slept, left\"\n"
                       ",P2\n");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].code, "P1");
  EXPECT_EQ(list[0].reason, "slept, left");
  EXPECT_EQ(list[0].rule, "flagged");
  EXPECT_EQ(list[0].date, "2026-11-29");
  EXPECT_EQ(list[1].code, "P2");
  EXPECT_EQ(list[1].date, "");
}

TEST(Exclusions, NameWhatIsWrongWithAHeadingOrADate) {
  const auto problem = [](const char* text) {
    try {
      parse_exclusions("x.csv", text);
    } catch (const InputError& error) {
      return error.problems().at(0).message;
    }
    return std::string("none");
  };
  EXPECT_EQ(problem("code,reasn\nP1,a\n"), "no such column: \"reasn\"; did you mean \"reason\"?");
  EXPECT_EQ(problem("code,date,code\n"), "the column \"code\" stands here twice");
  EXPECT_EQ(problem("code,date\nP1,29.11.2026\n"), "want a date as 2026-11-29 here");
  EXPECT_EQ(problem("code,date\nP1,2026-11-29,x\n"), "want CODE,DATE here");
  EXPECT_EQ(problem("code,date\n,2026-11-29\n"), "want CODE,DATE here");
}

TEST(Exclusions, NameEveryWrongLine) {
  try {
    parse_exclusions("x.csv", ",reason\nP1,a,b\nP2\n");
    FAIL() << "two lines are wrong";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 2u);
  }
}

TEST(Selection, CountsASimulatedPilotAsWhatWasNotAskedFor) {
  const TestFolder folder;
  ToyLog log(folder.file("a.db"));
  log.session({"P1", "finished", true, true}).trial({});
  const Log read = read_log(log.database());
  EXPECT_EQ(select(read, {}).left_out_simulated, 1);
  const Selection selection = select(read, {true, false, ""});
  EXPECT_EQ(selection.left_out_simulated, 0);
  EXPECT_EQ(selection.left_out_pilot, 1);
}

}  // namespace
}  // namespace promenade::analysis
