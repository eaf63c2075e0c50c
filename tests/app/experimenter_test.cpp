// The experimenter's panel, and the pages that wait for it.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "study/sqlite.h"
#include "tests/app/session_bench.h"

namespace promenade::app {
namespace {

using bench::SessionBench;
using study::PageKind;

std::string study_text(const std::string& more = "") {
  return "[study]\nname = 'panel'\n" + more +
         "[[interface]]\nname = 'labels'\n"
         "[[task]]\nname = 'match'\nkind = 'match'\nlimit_s = 60\n"
         "targets = [{example = 'proud'}, {example = 'sad'}]\npractice = [{example = 'happy'}]\n"
         "[[rating]]\nitem = 'one'\nquestion = 'One?'\n";
}

std::int64_t count(const SessionBench& bench, const std::string& rows) {
  study::Database database(bench.file().string(), study::Database::Mode::read_only);
  study::Statement statement(database, "SELECT count(*) FROM " + rows);
  statement.step();
  return statement.integer(0);
}

class Panel : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(bench_.play(5, [&] {
      return bench_.session().trial() != nullptr && bench_.session().trial()->index == 1;
    }));
  }
  bool is_open() const {
    return bench_.view().widgets().find("press", "experimenter:back") != nullptr;
  }

  SessionBench bench_{"en", 1, study_text()};
};

TEST_F(Panel, OpensByItsKeysOverACoveredSession) {
  bench_.key(GLFW_KEY_E);
  EXPECT_FALSE(is_open());
  bench_.chord();
  ASSERT_TRUE(is_open());
  EXPECT_TRUE(bench_.session().paused());
  EXPECT_EQ(count(bench_, "event WHERE kind = 'pause' AND actor = 'experimenter'"), 1);
  EXPECT_EQ(bench_.view().widgets().find("press", "done"), nullptr);
  bench_.click("experimenter:back");
  EXPECT_FALSE(is_open());
  EXPECT_FALSE(bench_.session().paused());
  EXPECT_EQ(count(bench_, "event WHERE kind = 'resume' AND actor = 'experimenter'"), 1);
}

TEST_F(Panel, NotesWhatIsWrittenAndGoesOnStandingStill) {
  bench_.chord();
  bench_.type("fire alarm");
  bench_.click("experimenter:note");
  EXPECT_TRUE(is_open());
  EXPECT_EQ(count(bench_,
                  "event WHERE kind = 'note' AND actor = 'experimenter' AND "
                  "detail LIKE '%fire alarm%'"),
            1);
  bench_.click("experimenter:note");
  EXPECT_EQ(count(bench_, "event WHERE kind = 'note'"), 1) << "an empty note is none";
}

TEST_F(Panel, SkipsATrialOnlyWithAReason) {
  bench_.chord();
  bench_.click("experimenter:skip");
  EXPECT_TRUE(is_open());
  EXPECT_EQ(bench_.session().trial()->index, 1);
  ASSERT_TRUE(bench_.view().widgets().find("type", "experimenter:words"));
  bench_.click_on("type", "experimenter:words");
  bench_.type("the phone rang");
  bench_.click("experimenter:skip");
  EXPECT_FALSE(is_open());
  EXPECT_FALSE(bench_.session().paused());
  EXPECT_EQ(count(bench_, "trial WHERE outcome = 'skipped'"), 1);
}

TEST_F(Panel, RepeatsATrialAndAWholeBlock) {
  for (const std::string what : {"trial", "block"}) {
    bench_.chord();
    bench_.type("again");
    bench_.click("experimenter:repeat_" + what);
    EXPECT_FALSE(is_open());
    EXPECT_EQ(count(bench_, "event WHERE kind = 'repeat' AND target = '" + what + "'"), 1);
  }
  EXPECT_EQ(bench_.session().page().kind, PageKind::instructions);
}

TEST_F(Panel, BeginsARepeatedTrialWithTheViewOfANewOne) {
  bench_.frame();
  bench_.view().stage().orbit().yaw = 1;
  bench_.frame();
  EXPECT_EQ(bench_.view().stage().orbit().yaw, 1);
  bench_.chord();
  bench_.type("again");
  bench_.click("experimenter:repeat_trial");
  bench_.click("continue");
  ASSERT_NE(bench_.session().trial(), nullptr);
  EXPECT_EQ(bench_.session().trial()->attempt, 2);
  EXPECT_EQ(bench_.view().stage().orbit(), Orbit{});
}

TEST_F(Panel, EndsTheSession) {
  bench_.chord();
  bench_.type("unwell");
  bench_.click("experimenter:stop");
  EXPECT_TRUE(bench_.view().ended());
  EXPECT_EQ(bench_.session().outcome(), study::Outcome::stopped);
  EXPECT_EQ(count(bench_, "event WHERE kind = 'stop' AND actor = 'experimenter'"), 1);
}

TEST_F(Panel, WorksByKeyboardAlone) {
  bench_.chord();
  bench_.type("by key");
  for (int k = 0; k < 20 && !bench_.view().focus().on("press", "experimenter:skip"); ++k) {
    bench_.key(GLFW_KEY_TAB);
  }
  bench_.key(GLFW_KEY_ENTER);
  EXPECT_EQ(count(bench_, "trial WHERE outcome = 'skipped'"), 1);
}

TEST_F(Panel, OverAPauseOfTheParticipantLeavesItOnTheWayBack) {
  bench_.key(GLFW_KEY_ESCAPE);
  bench_.chord();
  ASSERT_TRUE(is_open());
  bench_.click("experimenter:back");
  EXPECT_FALSE(is_open());
  EXPECT_TRUE(bench_.session().paused());
  EXPECT_EQ(count(bench_, "event WHERE kind = 'pause'"), 1);
}

TEST_F(Panel, OpensWhileSomebodyWrites) {
  bench_.type("sa");  // the list is searched
  bench_.chord();
  EXPECT_TRUE(is_open());
}

TEST(Release, IsUpToTheExperimenterAlone) {
  SessionBench bench("en", 1, study_text("[practice]\nuntil = 'released'\n"));
  ASSERT_TRUE(bench.play(5, [&] { return bench.session().page().kind == PageKind::release; }));
  for (const int key : {GLFW_KEY_ENTER, GLFW_KEY_SPACE}) bench.key(key);
  EXPECT_EQ(bench.session().page().kind, PageKind::release);
  EXPECT_EQ(bench.view().widgets().find("press", "continue"), nullptr);
  bench.chord();
  bench.click("experimenter:release");
  EXPECT_EQ(bench.session().page().kind, PageKind::intro);
  EXPECT_EQ(count(bench, "event WHERE kind = 'release' AND actor = 'experimenter'"), 1);
}

}  // namespace
}  // namespace promenade::app
