// What the desk asks for when a study is rehearsed, and what it does with the answer.
#include "tests/app/desk/desk_bench.h"

namespace promenade::app {
namespace {

class RehearseDesk : public bench::DeskBench {
 protected:
  RehearseDesk() : study_(make_study("Walks")) { open(study_, DeskPlace::rehearse); }
  study::StudyPlace study_;
};

TEST_F(RehearseDesk, StartsAPilotInAWindow) {
  press("pilot");
  EXPECT_EQ(asked(), "run Walks/study.toml --db Walks/sessions.db --pilot --windowed\n");
}

TEST_F(RehearseDesk, LetsASimulatedPersonTakeTheMouse) {
  write_file(study_.rehearsal(), "of an earlier study");
  press("one");
  EXPECT_EQ(asked(), "run Walks/study.toml --db Walks/rehearsal.db --windowed --autopilot 1\n");
  EXPECT_FALSE(std::filesystem::exists(study_.rehearsal())) << "each rehearsal begins afresh";
}

TEST_F(RehearseDesk, SimulatesTheStudyAndOpensItsReport) {
  click("less", "people");
  press("many");
  ASSERT_TRUE(wait_until([this] { return !shown_.empty(); }));
  EXPECT_EQ(
      asked(),
      "simulate Walks/study.toml --participants 19 --seed 1 --jobs 2 --db Walks/rehearsal.db\n"
      "report Walks/rehearsal.db --include-simulated --out Walks/rehearsal-report\n");
  EXPECT_EQ(shown_.front(), (study_.rehearsal_report() / "report.html").string());
}

TEST_F(RehearseDesk, MakesNoReportOfASimulationThatFailed) {
  let_it("echo 'promenade: the disk is full' >&2; exit 1\n");
  press("many");
  EXPECT_EQ(asked().find("report "), std::string::npos);
  EXPECT_TRUE(shown_.empty());
  EXPECT_TRUE(has("press", "job.close")) << "the foot says why";
  press("job.close");
  EXPECT_FALSE(has("press", "job.close"));
}

TEST_F(RehearseDesk, StopsASimulation) {
  let_it("trap 'exit 1' INT; while :; do sleep 0.01; done\n");
  press("many");
  ASSERT_TRUE(has("press", "job.stop"));
  press("job.stop");
  ASSERT_TRUE(wait_until([this] { return !desk_.jobs().busy(); }));
  EXPECT_TRUE(has("press", "job.close"));
}

TEST_F(RehearseDesk, BeginsNothingWithAStudyThatCannotBeRun) {
  write_file(study_.file(), "[study\n");
  ASSERT_TRUE(wait_until([this] { return !desk_.study()->bundle(); }));
  for (const char* what : {"pilot", "one", "many"}) press(what);
  EXPECT_EQ(asked(), "");
}

}  // namespace
}  // namespace promenade::app
