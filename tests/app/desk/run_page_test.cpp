// What is told before a session, and how one is started.
#include "app/desk/readiness.h"
#include "app/desk/words.h"
#include "app/registry.h"
#include "study/store.h"
#include "tests/app/desk/desk_bench.h"

namespace promenade::app {
namespace {

class RunDesk : public bench::DeskBench {
 protected:
  RunDesk() : study_(make_study("Walks")) { open(study_, DeskPlace::run); }
  // Leaves a database behind, of the study as it is now, in which one session ended.
  void hold_a_session(bool pilot) {
    const study::StudyBundle bundle = study::load_study(study_.file(), interfaces());
    study::Store store(study_.sessions(), bundle);
    study::SessionHeader header;
    header.participant = "P1";
    header.pilot = pilot;
    header.started_utc = "2026-11-29T12:00:00Z";
    store.begin_session(header, study::make_plan(bundle.study, 0));
    store.end_session("2026-11-29T12:10:00Z");
  }
  study::StudyPlace study_;
};

TEST_F(RunDesk, StartsASessionOnTheSecondDisplayAndGoesToWatch) {
  press("start");
  EXPECT_EQ(asked(), "run Walks/study.toml --db Walks/sessions.db --screen 2\n");
  EXPECT_EQ(desk_.place(), DeskPlace::watch);
}

TEST_F(RunDesk, HandsOverDisplayLanguageCodeAndStation) {
  click("open", "display");
  click("choose", "display/2");
  click("open", "language_of_study");
  click("choose", "language_of_study/2");
  write("code", "P07");
  write("station", "B");
  press("start");
  EXPECT_EQ(
      asked(),
      "run Walks/study.toml --db Walks/sessions.db --windowed --language ja --participant P07 "
      "--station B\n");
}

TEST_F(RunDesk, GoesByTheRosterWhenThereIsOne) {
  write_file(study_.roster(), "code,station,sequence,state,replaces\n");
  press("start");
  EXPECT_NE(asked().find("--roster Walks/roster.csv"), std::string::npos);
}

TEST_F(RunDesk, TriesTheMachineOnTheDisplayOfTheParticipant) {
  let_it(R"(echo '{"fit": false, "checks": [{"name": "disk", "verdict": "failure", "says": "x"}]}')"
         "\nexit 1\n");
  press("doctor");
  EXPECT_EQ(asked(), "doctor --json --db Walks/sessions.db --screen 2\n");
}

TEST_F(RunDesk, AsksWhyAStudyWasChangedBeforeItsNextSession) {
  hold_a_session(false);
  write_file(study_.file(), read_file(study_.file()) + "# changed\n");
  ASSERT_TRUE(wait_until([this] { return desk_.study()->reading()->amendment_due; }));
  frames(2);
  press("start");
  EXPECT_EQ(asked(), "");
  write("amend.reason", "a typing error");
  press("amend");
  EXPECT_EQ(asked(), "amend Walks/sessions.db Walks/study.toml --reason a typing error\n");
}

TEST_F(RunDesk, KnowsAReasonAfterPilots) {
  hold_a_session(true);
  write_file(study_.file(), read_file(study_.file()) + "# changed\n");
  ASSERT_TRUE(wait_until([this] { return desk_.study()->reading()->amendment_due; }));
  frames(2);
  press("amend");
  EXPECT_NE(asked().find("--reason changed after a pilot"), std::string::npos);
}

TEST_F(RunDesk, IsWorkedByTheKeyboardAlone) {
  tab_to("type", "code");
  type("P1");
  tab_to("press", "start");
  key(GLFW_KEY_ENTER);
  EXPECT_NE(asked().find("--participant P1"), std::string::npos);
}

TEST(Readiness, ReadsWhatTheDoctorFound) {
  const auto lines = read_doctor(R"({"checks": [{"name": "disk", "verdict": "ok", "says": "a"},
                                               {"name": "new", "verdict": "warning", "says": "b"}]})");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].title, "disk");
  EXPECT_EQ(lines[1].says, "b");
  EXPECT_EQ(worst(lines), Light::amber);
  for (const char* odd : {"killed", "", "[]", "{}"}) EXPECT_TRUE(read_doctor(odd).empty()) << odd;
}

TEST(Readiness, NamesWhatIsWrongWithTheStudy) {
  const study::Texts words = desk_texts("en");
  EXPECT_EQ(lines_of_study(nullptr, words).front().light, Light::unknown);
  StudyReading reading;
  reading.problems = {{.file = "study.toml", .line = 3, .column = 1, .message = "is odd"}};
  EXPECT_EQ(worst(lines_of_study(&reading, words)), Light::red);
  reading.bundle = std::make_shared<const study::StudyBundle>();
  EXPECT_EQ(worst(lines_of_study(&reading, words)), Light::amber);
  reading.problems.clear();
  EXPECT_EQ(worst(lines_of_study(&reading, words)), Light::green);
  reading.amendment_due = true;
  EXPECT_EQ(worst(lines_of_study(&reading, words)), Light::red);
}

}  // namespace
}  // namespace promenade::app
