// What a watcher sees, without a window: every session has its place, and what is long fits.
#include "app/monitor_view.h"

#include <gtest/gtest.h>

#include "app/desk/words.h"
#include "app/monitor_words.h"
#include "study/plan.h"
#include "study/session.h"

namespace promenade::app {
namespace {

using study::Watched;
using study::WatchedSession;
using study::WatchedState;

WatchedSession session(const std::string& code, WatchedState state = WatchedState::running) {
  WatchedSession one;
  one.uuid = code;
  one.participant = code;
  one.state = state;
  one.outcome = state == WatchedState::ended ? "finished" : "running";
  one.trials = 24;
  one.trials_done = 6;
  one.minutes = 22.4;
  one.minutes_left = 13.2;
  return one;
}

WatchedSession in_trial(const std::string& code) {
  WatchedSession one = session(code);
  one.page = "trial";
  study::WatchedTrial trial;
  trial.position = 7;
  trial.task = "copy";
  trial.interface = "map";
  trial.target = "proud";
  trial.seconds = 12;
  trial.limit_s = 45;
  trial.threshold_m = 0.02;
  trial.shown = {{0, 0.08}, {3, 0.05}, {3.001, 0.04}, {9, 0.03}};
  trial.d_best = 0.03;
  one.trial = trial;
  return one;
}

class MonitorWindow : public testing::Test {
 protected:
  void show(Watched now, int width = 1280, int height = 720) {
    now_ = std::move(now);
    gui_ = std::make_unique<Gui>(make_palette(false), shown_words(now_));
    gui_->fit(width, height);
    unsigned char* pixels = nullptr;
    int wide = 0;
    int high = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &wide, &high);
    view_.frame(*gui_, now_);
    view_.frame(*gui_, now_);
  }
  const Widget* find(const char* kind, const std::string& code) {
    return view_.widgets().find(kind, code);
  }

  InputQueue queue_;
  Watched now_;
  std::unique_ptr<Gui> gui_;
  MonitorView view_{queue_};
};

Watched with(std::vector<WatchedSession> sessions) {
  Watched now;
  now.study = "Walks";
  now.planned = 24;
  now.finished = 12;
  now.sessions = std::move(sessions);
  return now;
}

TEST_F(MonitorWindow, ShowsACardForEachSessionAndARowForEachThatEnded) {
  show(with({in_trial("P01"), session("P02", WatchedState::interrupted),
             session("P03", WatchedState::ended)}));
  for (const char* code : {"P01", "P02"}) {
    ASSERT_NE(find("session", code), nullptr);
    EXPECT_TRUE(find("session", code)->visible());
  }
  EXPECT_LE(find("session", "P01")->box.bottom(), find("session", "P02")->box.y);
  EXPECT_TRUE(find("ended", "P03")->visible());
  EXPECT_EQ(find("session", "P03"), nullptr);
}

TEST_F(MonitorWindow, ShowsDistanceAndTimeLeftWithinTheCardOfATrial) {
  show(with({in_trial("P01"), session("P02")}), 2560, 1440);
  const Box card = find("session", "P01")->box;
  for (const char* part : {"plot", "ring", "code"}) {
    const Widget* widget = find(part, "P01");
    ASSERT_NE(widget, nullptr) << part;
    EXPECT_TRUE(card.holds(widget->box.x, widget->box.y)) << part;
    EXPECT_LE(widget->box.bottom(), card.bottom()) << part;
  }
  EXPECT_EQ(find("plot", "P02"), nullptr);
}

TEST_F(MonitorWindow, ScrollsToCardsThatHaveNoRoom) {
  std::vector<WatchedSession> many;
  for (int i = 1; i <= 9; ++i) many.push_back(session("P0" + std::to_string(i)));
  show(with(many));
  EXPECT_FALSE(find("session", "P09")->visible());
  queue_.push({.kind = UiEvent::Kind::move, .x = 600, .y = 400});
  for (int i = 0; i < 40; ++i) queue_.push({.kind = UiEvent::Kind::wheel, .y = -3});
  for (int i = 0; i < 10; ++i) view_.frame(*gui_, now_);
  EXPECT_TRUE(find("session", "P09")->visible());
}

TEST_F(MonitorWindow, HasTheCharactersOfEveryCode) {
  show(with({in_trial("参加者ノ長イ名前"), session("P02")}));
  const ImFont* heading = gui_->look().fonts.heading;
  for (const ImWchar character : std::initializer_list<ImWchar>{0x53c2, 0x9577, 0x30ce}) {
    EXPECT_NE(heading->FindGlyphNoFallback(character), nullptr);
  }
}

TEST_F(MonitorWindow, ShowsWhatIsWrongAndAnEmptyDatabase) {
  Watched none;
  none.problem = "results/demo.db is not there yet";
  show(none);
  EXPECT_EQ(find("session", ""), nullptr);
  show(with({}));
}

const study::Texts& english() {
  static const study::Texts texts = desk_texts("en");
  return texts;
}

TEST(MonitorWords, SayWhatSomebodyDoes) {
  WatchedSession one = in_trial("P01");
  EXPECT_EQ(doing_words(english(), one), "trial 7 of 24");
  EXPECT_EQ(trial_words(english(), one), "copy with map, to proud");
  one.trial->practice = true;
  one.trial->attempt = 2;
  EXPECT_EQ(doing_words(english(), one), "trial 7 of 24, practice, attempt 2");
  one.state = WatchedState::paused;
  one.trial.reset();
  one.page = "instructions";
  EXPECT_EQ(doing_words(english(), one), "paused: reads the instructions");
  one.state = WatchedState::interrupted;
  one.silent_s = 40;
  EXPECT_EQ(doing_words(english(), one), "interrupted 40 s ago");
  EXPECT_EQ(advice_words(english(), one), ": start the program again to resume");
}

TEST(MonitorWords, KnowEveryPage) {
  for (int kind = 0; kind <= static_cast<int>(study::PageKind::declined); ++kind) {
    WatchedSession one = session("P01");
    one.page = to_text(static_cast<study::PageKind>(kind));
    for (const std::string& language : desk_languages()) {
      const study::Texts texts = desk_texts(language);
      EXPECT_NE(texts.find("watch.at_" + one.page), nullptr) << one.page;
      EXPECT_EQ(doing_words(texts, one), texts("watch.at_" + one.page));
    }
  }
}

TEST(MonitorWords, KnowEveryEnd) {
  for (const auto outcome : {study::Outcome::finished, study::Outcome::declined,
                             study::Outcome::withdrawn, study::Outcome::stopped}) {
    for (const std::string& language : desk_languages()) {
      const std::string key = "watch.outcome_" + std::string(to_text(outcome));
      EXPECT_NE(desk_texts(language).find(key), nullptr) << key;
    }
  }
}

TEST(MonitorWords, SayWhyNothingCanBeSeen) {
  Watched now;
  EXPECT_EQ(problem_words(english(), now), "");
  now.problem = "x.db: is not a database";
  now.is_input_error = true;
  EXPECT_EQ(problem_words(english(), now).find("This file cannot be watched: x.db: is not a"), 0U);
  now.is_input_error = false;
  now.is_locked = true;
  EXPECT_NE(problem_words(english(), now).find("Another program"), std::string::npos);
  now.is_locked = false;
  now.waits = true;
  EXPECT_EQ(problem_words(english(), now).find("x.db"), std::string::npos);
}

TEST(MonitorWords, SayHowLongAndHowMany) {
  EXPECT_EQ(duration_words(english(), 99.9), "99 s");
  EXPECT_EQ(duration_words(english(), 100), "1 min");
  EXPECT_EQ(duration_words(english(), 7200), "2 h");
  EXPECT_EQ(time_words(english(), session("P01")), "22 min played, about 14 left");
  EXPECT_EQ(finished_words(english(), with({})), "12 of 24 participants have finished");
  WatchedSession silent = session("P01");
  silent.silent_s = 6;
  EXPECT_EQ(life_words(english(), silent), "no sign of life for 6 s");
}

}  // namespace
}  // namespace promenade::app
