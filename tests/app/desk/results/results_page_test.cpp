// Reports, data, exclusions, withdrawals and the roster at the desk.
#include "app/registry.h"
#include "study/store.h"
#include "tests/app/desk/desk_bench.h"

namespace promenade::app {
namespace {

class ResultsDesk : public bench::DeskBench {
 protected:
  ResultsDesk() : study_(make_study("Walks")) {
    const study::StudyBundle bundle = study::load_study(study_.file(), interfaces());
    study::Store store(study_.sessions(), bundle);
    for (const char* code : {"P1", "P2"}) {
      study::SessionHeader header;
      header.participant = code;
      header.started_utc = "2026-11-29T12:00:00Z";
      store.begin_session(header,
                          study::make_plan(bundle.study, store.next_sequence(false, false)));
      store.end_session("2026-11-29T12:10:00Z");
    }
    bench::DeskBench::open(study_, DeskPlace::results);
  }
  study::StudyPlace study_;
};

TEST_F(ResultsDesk, MakesAReportAndOpensIt) {
  press("report");
  EXPECT_EQ(asked(), "report Walks/sessions.db --out Walks/report\n");
  ASSERT_TRUE(wait_until([this] { return !shown_.empty(); }));
  EXPECT_EQ(shown_.front(), (study_.report() / "report.html").string());
}

TEST_F(ResultsDesk, LeavesPeopleOutWithTheirReason) {
  click("person", "P2");
  write("exclude.reason", "fell asleep, twice");
  press("exclude");
  const std::string csv = read_file(study_.exclusions());
  EXPECT_EQ(csv.rfind("code,reason,rule,date\nP2,\"fell asleep, twice\",,20", 0), 0U) << csv;
  click("tick", "pilots");
  press("report");
  EXPECT_EQ(asked(),
            "report Walks/sessions.db --out Walks/report --include-pilot --exclude "
            "Walks/exclusions.csv\n");
  press("include");
  EXPECT_EQ(read_file(study_.exclusions()), "code,reason,rule,date\n");
}

TEST_F(ResultsDesk, WritesNothingOverExclusionsThatItCannotRead) {
  const std::string odd = "code,reason,rule,date\nP1,late,,2026-11-3\n";
  write_file(study_.exclusions(), odd);
  click("person", "P2");
  if (has("press", "exclude")) {
    write("exclude.reason", "x");
    press("exclude");
  }
  EXPECT_EQ(read_file(study_.exclusions()), odd);
}

TEST_F(ResultsDesk, WithdrawsOnlyWhoseCodeIsWrittenOnceMore) {
  click("person", "P1");
  write("withdraw.code", "P");
  press("withdraw");
  EXPECT_EQ(asked(), "");
  write("withdraw.code", "1");
  press("withdraw");
  EXPECT_EQ(asked(), "withdraw Walks/sessions.db P1\n");
}

TEST_F(ResultsDesk, ReportsOfAllStationsOnceTheyWereJoined) {
  write("station", "/media/usb/b.db");
  press("merge");
  EXPECT_EQ(asked(), "merge Walks/merged.db Walks/sessions.db /media/usb/b.db\n");
  write_file(study_.merged(), "joined");
  press("export");
  ASSERT_TRUE(wait_until([this] { return !shown_.empty(); }));
  EXPECT_EQ(asked(),
            "merge Walks/merged.db Walks/sessions.db /media/usb/b.db\n"
            "merge Walks/merged.db Walks/sessions.db\n"
            "export Walks/merged.db --out Walks/data\n");
}

TEST_F(ResultsDesk, ReportsWhereOnlyOtherStationsHaveSessions) {
  std::filesystem::rename(study_.sessions(), study_.merged());
  ASSERT_TRUE(wait_until([this] { return has("person", "P1"); }));
  press("report");
  EXPECT_EQ(asked(), "report Walks/merged.db --out Walks/report\n");
}

TEST_F(ResultsDesk, ExportsForThePublicApart) {
  press("publish");
  EXPECT_EQ(asked(), "export Walks/sessions.db --out Walks/public-data --public\n");
}

TEST_F(ResultsDesk, KeepsTheRoster) {
  press("list/1");
  click("more", "roster.stations");
  press("deal");
  EXPECT_EQ(asked(),
            "roster Walks/study.toml --out Walks/roster.csv --participants 12 --stations 2\n");
  write_file(study_.roster(), "code,station,sequence,state,replaces\nNM9YL,1,0,booked,\n");
  press("deal");  // anything: afterwards it is read again
  asked();
  frames(2);
  click("booked", "NM9YL");
  press("no_show");
  EXPECT_NE(asked().find("--no-show NM9YL"), std::string::npos);
}

TEST_F(ResultsDesk, IsWorkedByTheKeyboardAlone) {
  tab_to("person", "P1");
  key(GLFW_KEY_ENTER);
  tab_to("type", "exclude.reason");
  type("late");
  key(GLFW_KEY_ENTER);
  EXPECT_NE(read_file(study_.exclusions()).find("P1,late"), std::string::npos);
}

}  // namespace
}  // namespace promenade::app
