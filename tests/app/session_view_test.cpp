// Whole sessions through the real pages.
#include "app/session_view.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "study/sqlite.h"
#include "tests/app/session_bench.h"

namespace promenade::app {
namespace {

using bench::SessionBench;
using study::PageKind;

std::int64_t count(const SessionBench& bench, const std::string& rows) {
  study::Database database(bench.file().string(), study::Database::Mode::read_only);
  study::Statement statement(database, "SELECT count(*) FROM " + rows);
  statement.step();
  return statement.integer(0);
}

class EveryLanguage : public testing::TestWithParam<const char*> {};

TEST_P(EveryLanguage, TheAutopilotFinishesTheDemoWithTheMouse) {
  SessionBench bench(GetParam(), 5);
  ASSERT_TRUE(bench.play(30));
  EXPECT_EQ(bench.session().outcome(), study::Outcome::finished);
  const auto trials = static_cast<std::int64_t>(bench.session().plan().trials.size());
  EXPECT_EQ(count(bench, "trial WHERE outcome IS NOT NULL"), trials);
  EXPECT_EQ(count(bench, "session WHERE outcome = 'finished' AND simulated = 1"), 1);
  EXPECT_GT(count(bench, "event WHERE actor = 'participant' AND kind = 'slide'"), 0);
  EXPECT_GT(count(bench, "event WHERE actor = 'participant' AND kind = 'pick'"), 0);
  EXPECT_GE(count(bench, "event WHERE kind = 'press'"), trials);
}

INSTANTIATE_TEST_SUITE_P(Texts, EveryLanguage, testing::Values("en", "ja"));

TEST(SessionView, WithoutACodeNothingBegins) {
  SessionBench bench;
  bench.click("continue");
  EXPECT_EQ(bench.session().page().kind, PageKind::welcome);
}

TEST(SessionView, ATypedCodeLeadsToTheConsent) {
  SessionBench bench;
  bench.type("P07");
  bench.click("continue");
  EXPECT_EQ(bench.session().page().kind, PageKind::consent);
  EXPECT_EQ(count(bench, "participant WHERE code = 'P07'"), 1);
}

// A roster with one code that is free and one that is not.
RosterAnswer toy_roster(const std::string& typed) {
  if (typed == "k7q4s") {
    return {RosterAnswer::Kind::welcome, {"K7Q4S", "1", 5, study::Attendance::booked, ""}};
  }
  return {typed == "gone" ? RosterAnswer::Kind::taken : RosterAnswer::Kind::unknown};
}

TEST(WelcomeWithARoster, TakesItsCodesWithTheirOrder) {
  SessionBench bench("en", 1, "", toy_roster);
  bench.type("k7q4s");
  bench.click("continue");
  EXPECT_EQ(bench.session().page().kind, PageKind::consent);
  EXPECT_EQ(count(bench,
                  "session JOIN participant ON participant.uuid = session.participant "
                  "WHERE code = 'K7Q4S' AND sequence = 5"),
            1);
}

TEST(WelcomeWithARoster, BeginsNothingWithACodeThatIsUnknownOrTaken) {
  for (const char* code : {"other", "gone"}) {
    SessionBench bench("en", 1, "", toy_roster);
    bench.type(code);
    bench.click("continue");
    EXPECT_EQ(bench.session().page().kind, PageKind::welcome) << code;
    EXPECT_EQ(count(bench, "session"), 0) << code;
  }
}

TEST(WelcomeWithARoster, EndsWithAMessageWhenItCannotBeRead) {
  SessionBench bench("en", 1, "", [](const std::string&) -> RosterAnswer {
    throw OutsideError("the stick is gone");
  });
  bench.type("k7q4s");
  bench.click("continue");
  EXPECT_EQ(bench.session().page().kind, PageKind::welcome);
  bench.click("continue");
  EXPECT_TRUE(bench.view().ended());
}

TEST(SessionView, DecliningEndsItPolitely) {
  SessionBench bench;
  bench.type("P07");
  bench.click("continue");
  bench.click("decline");
  EXPECT_EQ(bench.session().page().kind, PageKind::declined);
  bench.click("continue");
  EXPECT_TRUE(bench.view().ended());
  EXPECT_EQ(bench.session().outcome(), study::Outcome::declined);
}

TEST(SessionView, ClosingTheWindowInATrialAbortsItAndIsLogged) {
  SessionBench bench;
  ASSERT_TRUE(bench.play(5, [&] { return bench.session().trial() != nullptr; }));
  bench.stop();
  EXPECT_EQ(bench.session().outcome(), study::Outcome::stopped);
  EXPECT_EQ(count(bench, "trial WHERE outcome = 'aborted'"), 1);
}

TEST(SessionView, ClosingTheWindowIsAPauseThatCanBeLeft) {
  SessionBench bench;
  ASSERT_TRUE(bench.play(5, [&] { return bench.session().trial() != nullptr; }));
  bench.close_window();
  EXPECT_TRUE(bench.session().paused());
  EXPECT_FALSE(bench.view().ended());
  bench.click("resume");
  EXPECT_FALSE(bench.session().paused());
  bench.key(GLFW_KEY_ESCAPE);
  bench.frame();
  EXPECT_EQ(bench.view().widgets().find("press", "end"), nullptr) << "nobody wants to close it now";
  bench.close_window();
  EXPECT_FALSE(bench.view().ended());
}

TEST(SessionView, ClosingItTwiceOrSayingSoEndsTheSession) {
  for (const bool by_button : {false, true}) {
    SessionBench bench;
    ASSERT_TRUE(bench.play(5, [&] { return bench.session().trial() != nullptr; }));
    bench.close_window();
    if (by_button) {
      bench.click("end");
    } else {
      bench.close_window();
    }
    EXPECT_TRUE(bench.view().ended());
    EXPECT_EQ(bench.session().outcome(), study::Outcome::stopped);
    EXPECT_EQ(count(bench, "event WHERE kind = 'stop' AND actor = 'participant'"), 1);
  }
}

class FastClicks : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(bench_.play(5, [&] { return bench_.session().trial() != nullptr; }));
    for (int k = 0; k < 60; ++k) bench_.frame();  // the autopilot's hand rests
    before_ = presses();
  }
  std::int64_t presses() const { return count(bench_, "event WHERE kind = 'press'"); }

  SessionBench bench_;
  std::int64_t before_ = 0;
};

TEST_F(FastClicks, AreAllTakenInOneFrame) {
  bench_.click_fast(10);
  bench_.frame();
  EXPECT_TRUE(bench_.queue().empty());
  bench_.frame();
  EXPECT_EQ(presses() - before_, 10);
}

TEST_F(FastClicks, AreAllStoredBeforeAStop) {
  bench_.click_fast(50);
  bench_.stop();
  EXPECT_EQ(presses() - before_, 50);
  EXPECT_EQ(bench_.session().outcome(), study::Outcome::stopped);
}

TEST_F(FastClicks, AreAllStoredBeforeThePauseOfAWindowThatCloses) {
  bench_.click_fast(50);
  bench_.close_window();
  bench_.stop();
  EXPECT_EQ(presses() - before_, 50);
}

TEST_F(FastClicks, KeepTheirTimeBesideALateFrame) {
  bench_.click_fast(1);
  bench_.show_late();
  bench_.stop();
  EXPECT_EQ(count(bench_, "event WHERE kind = 'late_frame'"), 1);
  EXPECT_EQ(count(bench_,
                  "event WHERE kind = 'press' AND t_us <= (SELECT t_us - 100000 FROM event WHERE "
                  "kind = 'late_frame')") -
                before_,
            1);
}

TEST_F(FastClicks, NeverReachAPageThatNobodyHasSeen) {
  bench_.key(GLFW_KEY_ESCAPE);
  bench_.frame();
  bench_.click("resume");
  bench_.key(GLFW_KEY_ESCAPE);
  const Widget* resume = bench_.view().widgets().find("press", "resume");
  ASSERT_NE(resume, nullptr);
  bench_.queue().push(
      {.kind = UiEvent::Kind::move, .x = resume->box.middle_x(), .y = resume->box.middle_y()});
  for (int k = 0; k < 8; ++k) {
    bench_.queue().push({.kind = UiEvent::Kind::button, .code = 0, .down = k % 2 == 0});
  }
  bench_.frame();
  EXPECT_FALSE(bench_.session().paused());
  EXPECT_FALSE(bench_.queue().empty());
}

TEST(SessionView, BeforeItBeganTheWindowClosesAtOnce) {
  SessionBench bench;
  bench.frame();
  bench.close_window();
  EXPECT_TRUE(bench.view().ended());
}

TEST(SessionView, WhoStoppedTheSessionIsLogged) {
  for (const study::Actor actor : {study::Actor::participant, study::Actor::experimenter}) {
    SessionBench bench;
    bench.type("P07");
    bench.click("continue");
    bench.stop(actor);
    const std::string name(study::to_text(actor));
    EXPECT_EQ(count(bench, "event WHERE kind = 'stop' AND actor = '" + name + "'"), 1) << name;
  }
}

TEST(SessionView, ATypedCodeOfMoreThanFortyCharactersDoesNotStart) {
  SessionBench bench;
  bench.type(std::string(41, 'x'));
  bench.click("continue");
  EXPECT_EQ(bench.session().page().kind, PageKind::welcome);
}

TEST(SessionView, TimesNeverGoBackAndFramesComeBeforeTheirEvents) {
  SessionBench bench;
  ASSERT_TRUE(bench.play(30));
  EXPECT_EQ(count(bench,
                  "event a JOIN event b ON b.seq = a.seq + 1 AND a.session = b.session "
                  "WHERE b.t_us < a.t_us"),
            0);
  EXPECT_EQ(count(bench, "event WHERE frame_us > t_us"), 0);
}

// Plays until a trial with a list is open.
const Widget* first_row(SessionBench& bench) {
  const auto row = [&] { return bench.view().widgets().find("pick", "sad"); };
  return bench.play(10, [&] { return row() != nullptr; }) ? row() : nullptr;
}

TEST(SessionView, AMouseEventChangesTheWeightsInItsOwnFrame) {
  SessionBench bench;
  const Widget* row = first_row(bench);
  ASSERT_NE(row, nullptr);
  bench.queue().push(
      {.kind = UiEvent::Kind::move, .x = row->box.middle_x(), .y = row->box.middle_y()});
  bench.frame();
  const Eigen::VectorXd before = bench.session().trial()->weights;
  bench.queue().push({.kind = UiEvent::Kind::button, .code = 0, .down = true});
  bench.frame();
  EXPECT_NE(bench.session().trial()->weights, before);
}

// What is outside the panel, as rectangles in the order drawn.
std::vector<std::array<float, 4>> outside(SessionBench& bench) {
  std::vector<std::array<float, 4>> boxes;
  for (const char* name : {"start_over", "done"}) {
    const Box box = bench.view().widgets().find("press", name)->box;
    boxes.push_back({box.x, box.y, box.width, box.height});
  }
  const Box stage = bench.view().widgets().find("stage", "stage")->box;
  boxes.push_back({stage.x, stage.y, stage.width, stage.height});
  return boxes;
}

TEST(SessionView, NothingOutsideThePanelDependsOnTheInterface) {
  std::vector<std::vector<std::array<float, 4>>> seen;
  for (const std::uint64_t order : {0U, 1U}) {
    SessionBench bench("en", order);
    ASSERT_TRUE(bench.play(5, [&] { return bench.session().trial() != nullptr; }));
    bench.frame();
    seen.push_back(outside(bench));
  }
  EXPECT_EQ(seen[0], seen[1]);
}

// Two interfaces with a break of two seconds between them.
std::string study_with_break() {
  return "[study]\nname = 'break'\nlanguages = ['en', 'ja']\norder = 'fixed'\n"
         "[breaks]\nafter = 'block'\nleast_s = 2\n"
         "[[interface]]\nname = 'labels'\n[[interface]]\nname = 'weights'\n"
         "[[task]]\nname = 'match'\nkind = 'match'\nlimit_s = 5\n"
         "targets = [{example = 'proud'}]\n";
}

TEST(SessionView, TheAutopilotChoosesALanguageAndWaitsInBreaks) {
  SessionBench bench("", 3, study_with_break());
  ASSERT_EQ(bench.session().page().kind, PageKind::language);
  ASSERT_TRUE(bench.play(10));
  EXPECT_EQ(bench.session().outcome(), study::Outcome::finished);
  EXPECT_EQ(count(bench, "event WHERE kind = 'page' AND target = 'break'"), 1);
}

TEST(SessionView, TheChosenLanguageIsStored) {
  SessionBench bench("", 1, study_with_break());
  bench.click("language:ja");
  EXPECT_EQ(bench.view().language(), "ja");
  bench.type("P07");
  bench.click("continue");
  EXPECT_EQ(count(bench, "session WHERE language = 'ja'"), 1);
  EXPECT_EQ(count(bench, "event WHERE kind = 'language' AND target = 'ja'"), 1);
}

TEST(SessionView, APausedTrialIsCoveredAndStands) {
  SessionBench bench;
  ASSERT_TRUE(bench.play(5, [&] { return bench.session().trial() != nullptr; }));
  bench.key(GLFW_KEY_ESCAPE);
  ASSERT_TRUE(bench.session().paused());
  ASSERT_EQ(bench.view().widgets().size(), 1U);
  EXPECT_EQ(bench.view().widgets()[0].target, "resume");
  bench.walk();
  const double phase = bench.view().stage().phase();
  for (int k = 0; k < 20; ++k) bench.walk();
  EXPECT_EQ(bench.view().stage().phase(), phase);
  bench.click("resume");
  EXPECT_FALSE(bench.session().paused());
  for (int k = 0; k < 20; ++k) bench.walk();
  EXPECT_NE(bench.view().stage().phase(), phase);
  EXPECT_EQ(count(bench, "event WHERE kind = 'pause' AND actor = 'participant'"), 1);
}

TEST(SessionView, ThePictureOfTheControlsCannotBeTouched) {
  SessionBench bench;
  ASSERT_TRUE(bench.play(5, [&] { return bench.session().page().kind == PageKind::instructions; }));
  bench.frame();
  const WidgetMap& widgets = bench.view().widgets();
  for (std::size_t i = 0; i < widgets.size(); ++i) {
    const bool ours = widgets[i].target == "continue" || widgets[i].target == "pause" ||
                      widgets[i].target == "stage" || widgets[i].target == "reset_view";
    EXPECT_TRUE(ours) << widgets[i].kind << " " << widgets[i].target;
  }
}

}  // namespace
}  // namespace promenade::app
