// Going on another day: where people may leave, and that nothing happens while they are away.
#include <gtest/gtest.h>

#include "play.h"
#include "study/replay.h"
#include "study/simulate.h"
#include "study/sqlite.h"
#include "study/store.h"
#include "tests/test_folder.h"
#include "toy.h"

namespace promenade::study {
namespace {

using toy::Player;

std::string text_with(const std::string& leave) {
  return toy::study_text() + "[breaks]\nafter = 'block'\nleast_s = 10\n[safety]\nleave = " + leave +
         "\n";
}

TEST(Leave, IsOfferedOnlyWhereTheStudyAllowsIt) {
  const StudyBundle strict = toy::bundle(text_with("false"));
  Player stays(strict);
  while (stays.session.page().kind != PageKind::instructions) stays.at(1, Continue{});
  EXPECT_FALSE(stays.session.can_leave());
  EXPECT_TRUE(stays.at(2, Leave{}).empty());
  EXPECT_FALSE(stays.session.left());
}

TEST(Leave, IsOfferedBetweenTasksAlone) {
  const StudyBundle bundle = toy::bundle(text_with("true"));
  Player player(bundle);
  std::set<PageKind> offered, others;
  for (std::int64_t t = 1'000'000; !player.session.ended(); t += 20'000'000) {
    player.at(t, Tick{});
    (player.session.can_leave() ? offered : others).insert(player.session.page().kind);
    if (player.session.trial()) {
      player.at(t, Done{});
    } else if (player.session.can_continue()) {
      player.at(t, Continue{});
    } else {
      player.at(t, SetAnswer{"liked", 7});
    }
  }
  EXPECT_EQ(offered,
            (std::set<PageKind>{PageKind::instructions, PageKind::intro, PageKind::break_}));
  EXPECT_EQ(others.count(PageKind::trial), 1U);
}

TEST(Leave, LetsNothingHappenUntilTheReturn) {
  const StudyBundle bundle = toy::bundle(text_with("true"));
  Player player(bundle);
  while (player.session.page().kind != PageKind::instructions) player.at(1, Continue{});
  player.at(10, Leave{});
  EXPECT_TRUE(player.session.left());
  for (const auto& action : {decltype(Input::action)(Continue{}),
                             {Resume{}},
                             {Pause{}},
                             {Stop{"closed"}},
                             {Skip{"why"}},
                             {Repeat{}},
                             {Tick{}}}) {
    EXPECT_TRUE(player.at(20, action).empty()) << action.index();
  }
  EXPECT_FALSE(player.session.ended());
  player.at(30, Return{86'400'000'000});
  EXPECT_FALSE(player.session.left());
  EXPECT_EQ(player.session.page().kind, PageKind::instructions);
  EXPECT_EQ(player.all<Event>().back().kind, "return");
  EXPECT_EQ(player.all<Event>().back().value, 86'400);
  player.at(31, Continue{});
  EXPECT_NE(player.session.trial(), nullptr);
}

TEST(Leave, LetsABreakStand) {
  const StudyBundle bundle = toy::bundle(text_with("true"));
  Player player(bundle);
  std::int64_t t = 0;
  while (player.session.page().kind != PageKind::break_) {
    player.at(++t, Continue{});
    if (player.session.trial()) player.at(++t, Done{});
    if (player.session.questions()) player.at(++t, SetAnswer{"liked", 7});
  }
  player.at(t + 4'000'000, Leave{});
  player.at(t + 9'000'000, Return{1});
  EXPECT_EQ(player.session.break_left_us(), 6'000'000);
}

TEST(Leave, IsKeptInTheDatabaseWithoutAnInterruption) {
  const TestFolder folder;
  const StudyBundle bundle = toy::bundle(text_with("true"));
  Store store(folder.file("left.db"), bundle);
  Player player(bundle);
  SessionHeader header;
  header.participant = "P1";
  store.begin_session(header, player.session.plan());
  while (player.session.page().kind != PageKind::instructions) player.at(1, Continue{});
  player.at(10, Leave{});
  store.write(player.records);
  store.flush();
  store.database().exec("UPDATE session SET process_start = 'another boot:1'");
  const auto waiting = store.interrupted_sessions(false, false);
  ASSERT_EQ(waiting.size(), 1U);
  EXPECT_TRUE(waiting[0].left);
  const LoggedSession log = store.read_session(waiting[0].uuid);
  EXPECT_TRUE(replay(bundle, toy::registry(), log).left());
  Audit found;
  audit(bundle, toy::registry(), log, found);
  EXPECT_TRUE(found.differences.empty());
}

TEST(Leave, IsDoneBySimulatedPeopleWhoTendToIt) {
  const StudyBundle bundle = toy::bundle(text_with("true"));
  Tendencies restless;
  restless.leaving = 0.5;
  int left = 0;
  int back = 0;
  for (const auto& step :
       simulate_steps(bundle, toy::registry(), make_plan(bundle.study, 0), 1, restless)) {
    for (const Record& record : step) {
      const auto* event = std::get_if<Event>(&record);
      left += event && event->kind == "leave" ? 1 : 0;
      back += event && event->kind == "return" ? 1 : 0;
    }
  }
  EXPECT_GT(left, 0);
  EXPECT_EQ(back, left);
}

}  // namespace
}  // namespace promenade::study
