// What a watcher asks for through the file beside the database, done by a session on its real
// pages.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <fstream>

#include "study/identity.h"
#include "study/replay.h"
#include "study/sqlite.h"
#include "study/watch.h"
#include "tests/app/session_bench.h"

namespace promenade::app {
namespace {

using bench::SessionBench;
using study::PageKind;

constexpr const char* study_text =
    "[study]\nname = 'asked'\n[[interface]]\nname = 'labels'\n"
    "[[task]]\nname = 'match'\nkind = 'match'\nlimit_s = 60\n"
    "targets = [{example = 'proud'}, {example = 'sad'}]\npractice = [{example = 'happy'}]\n"
    "[[rating]]\nitem = 'one'\nquestion = 'One?'\n";

study::Request to(const std::string& what, const std::string& words = "") {
  study::Request request;
  request.what = what;
  request.words = words;
  return request;
}

class Asked : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(bench_.play(5, [&] {
      return bench_.session().trial() != nullptr && bench_.session().trial()->index == 1;
    }));
  }
  std::int64_t count(const std::string& rows) const {
    study::Database database(bench_.file().string(), study::Database::Mode::read_only);
    study::Statement statement(database, "SELECT count(*) FROM " + rows);
    statement.step();
    return statement.integer(0);
  }
  std::int64_t logged(const std::string& kind, const study::Request& request) const {
    return count("event WHERE actor = 'experimenter' AND kind = '" + kind +
                 "' AND json_extract(detail, '$.request') = '" + request.id + "'");
  }
  std::string refusal(const study::Request& request) const {
    study::Watch watch(bench_.file().string(), interfaces());
    for (const auto& answer : watch.look(study::utc_now()).sessions.at(0).answers) {
      if (answer.request == request.id) return answer.done ? "done" : answer.why;
    }
    return "no answer";
  }
  void expect_that_a_replay_agrees() const {
    study::Database database(bench_.file().string(), study::Database::Mode::read_only);
    const study::StudyBundle bundle =
        study::read_study("test.toml", study_text, interfaces(), study::load_motion_set);
    study::Audit audit;
    study::audit(bundle, interfaces(),
                 study::read_session(database, study::session_uuids(database).at(0)), audit);
    EXPECT_TRUE(audit.differences.empty()) << audit.differences[0].what;
  }

  SessionBench bench_{"en", 1, study_text};
};

TEST_F(Asked, PausesAndGoesOn) {
  const study::Request pause = bench_.ask(to("pause"));
  EXPECT_TRUE(bench_.session().paused());
  EXPECT_EQ(logged("pause", pause), 1);
  const study::Request resume = bench_.ask(to("resume"));
  EXPECT_FALSE(bench_.session().paused());
  EXPECT_EQ(logged("resume", resume), 1);
  expect_that_a_replay_agrees();
}

TEST_F(Asked, NotesSkipsAndRepeats) {
  EXPECT_EQ(refusal(bench_.ask(to("note", "the phone rang"))), "done");
  EXPECT_EQ(refusal(bench_.ask(to("skip", "the phone rang"))), "done");
  EXPECT_EQ(count("trial WHERE outcome = 'skipped'"), 1);
  study::Request block = to("repeat", "from the start");
  EXPECT_EQ(refusal(bench_.ask(block)), "done");
  block.block = true;
  EXPECT_EQ(refusal(bench_.ask(block)), "done");
  EXPECT_EQ(count("event WHERE kind = 'repeat' AND target = 'block'"), 1);
  EXPECT_EQ(bench_.session().page().kind, PageKind::instructions);
  expect_that_a_replay_agrees();
}

TEST_F(Asked, RefusesWhatCannotBeDoneNowAndSaysWhy) {
  EXPECT_EQ(refusal(bench_.ask(to("resume"))), "state");
  EXPECT_EQ(refusal(bench_.ask(to("release"))), "state");
  EXPECT_EQ(refusal(bench_.ask(to("skip"))), "words");
  EXPECT_EQ(refusal(bench_.ask(to("unknown"))), "unknown");
  study::Request elsewhere = to("skip", "why");
  elsewhere.page = bench_.session().page_index() - 1;
  EXPECT_EQ(refusal(bench_.ask(elsewhere)), "page");
  EXPECT_EQ(count("trial WHERE outcome = 'skipped'"), 0);
  bench_.ask(to("pause"));
  EXPECT_EQ(refusal(bench_.ask(to("pause"))), "state");
  EXPECT_TRUE(bench_.session().paused());
  expect_that_a_replay_agrees();
}

TEST_F(Asked, LeavesItToWhoHasThePanelOpen) {
  bench_.chord();
  EXPECT_EQ(refusal(bench_.ask(to("resume"))), "panel");
  EXPECT_TRUE(bench_.session().paused());
  EXPECT_EQ(refusal(bench_.ask(to("note", "somebody asked"))), "done");
  bench_.click("experimenter:back");
  EXPECT_EQ(refusal(bench_.ask(to("pause"))), "done");
}

TEST_F(Asked, TellsOnceThatALineIsBroken) {
  for (int k = 0; k < 3; ++k) {
    std::ofstream(study::requests_file(bench_.file().string()), std::ios::app) << "{ broken\n";
    for (int i = 0; i < 20; ++i) bench_.frame();
  }
  EXPECT_EQ(count("event WHERE kind = 'request_refused' AND actor = 'system'"), 1);
  EXPECT_EQ(refusal(bench_.ask(to("note", "after it"))), "done");
  expect_that_a_replay_agrees();
}

TEST_F(Asked, EndsTheSession) {
  const study::Request stop = bench_.ask(to("stop", "unwell"));
  EXPECT_TRUE(bench_.view().ended());
  EXPECT_EQ(bench_.session().outcome(), study::Outcome::stopped);
  EXPECT_EQ(logged("stop", stop), 1);
  expect_that_a_replay_agrees();
}

TEST_F(Asked, EndsAPauseThatOfferedTheEnd) {
  bench_.close_window();
  bench_.frame();
  ASSERT_TRUE(bench_.session().paused());
  bench_.ask(to("resume"));
  EXPECT_FALSE(bench_.session().paused());
  bench_.ask(to("pause"));
  EXPECT_EQ(bench_.view().widgets().find("press", "end"), nullptr) << "an ordinary pause";
}

}  // namespace
}  // namespace promenade::app
