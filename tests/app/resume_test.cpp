// A session that died is offered at the next start and goes on by one press.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "app/autopilot.h"
#include "app/registry.h"
#include "app/session_view.h"
#include "study/load_study.h"
#include "study/sqlite.h"
#include "tests/test_folder.h"

namespace promenade::app {
namespace {

constexpr const char* text =
    "[study]\nname = 'resumed'\n[[interface]]\nname = 'labels'\n[[task]]\nname = 'copy'\n"
    "kind = 'match'\ntargets = [{example = 'proud'}]\n";

// One start of the program on the same file.
class Start {
 public:
  Start(const study::StudyBundle& bundle, const std::string& file, const std::string& code = "S001")
      : store_(file, bundle),
        gui_(make_palette(false), shown_words(bundle)),
        live_(study::Session(bundle, interfaces(), study::make_plan(bundle.study, 0)), store_,
              header(), now_us_),
        view_((gui_.fit(1280, 720), bundle), interfaces(), gui_, live_, queue_,
              {"en", "", false, true, store_.interrupted_sessions(true, false)}),
        autopilot_(study::SimulatedParticipant(bundle, interfaces(), 1), code) {
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  }

  template <typename Done>
  bool play(const Done& done) {
    for (int frame = 0; frame < 60 * 120 && !done(*this); ++frame) {
      now_us_ += 16'667;
      autopilot_.act(now_us_, live_.session(), view_.widgets(), queue_);
      view_.frame(now_us_);
      view_.shown({.shown_us = now_us_ + 8000, .interval_us = 16'667});
    }
    return done(*this);
  }

  void leave() {
    live_.take(study::Leave{}, {.t_us = now_us_});
    live_.save();
  }
  const LiveSession& live() const { return live_; }
  LiveSession& live() { return live_; }

 private:
  static study::SessionHeader header() {
    study::SessionHeader header;
    header.simulated = true;
    header.started_utc = "2026-11-22T16:00:00Z";
    return header;
  }

  std::int64_t now_us_ = 1'000'000;
  study::Store store_;
  Gui gui_;
  InputQueue queue_;
  LiveSession live_;
  SessionView view_;
  Autopilot autopilot_;
};

TEST(ResumeOffer, IsTakenByOnePressAndTheSessionGoesOnWhereItStood) {
  const study::StudyBundle bundle =
      study::read_study("resumed.toml", text, interfaces(), study::load_motion_set);
  const std::string file =
      (std::filesystem::temp_directory_path() / ("promenade_resumed_" + std::to_string(getpid())))
          .string() +
      ".db";
  {
    Start first(bundle, file);
    ASSERT_TRUE(first.play([](const Start& start) {
      const study::TrialState* trial = start.live().session().trial();
      return trial != nullptr && trial->touched;
    }));
    first.live().save();
  }
  study::Database(file, study::Database::Mode::read_write)
      .exec("UPDATE session SET process_start = 'another boot:1'");
  Start again(bundle, file);
  ASSERT_TRUE(again.play([](const Start& start) { return start.live().resumed(); }));
  EXPECT_TRUE(again.live().session().paused());
  EXPECT_EQ(again.live().participant(), "S001");
  EXPECT_TRUE(again.live().session().trial()->touched);
  EXPECT_TRUE(again.play([](const Start& start) { return start.live().session().ended(); }));
  EXPECT_EQ(again.live().session().outcome(), study::Outcome::finished);
  for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(file + end);
}

// Two people left: each is offered the session of the code that is typed, and no other.
TEST(ResumeOffer, OfWhoLeftGoesByTheCode) {
  const TestFolder folder;
  const study::StudyBundle bundle =
      study::read_study("left.toml", std::string(text) + "[safety]\nleave = true\n", interfaces(),
                        study::load_motion_set);
  const std::string file = folder.file("left.db");
  for (const char* code : {"S001", "S002"}) {
    Start start(bundle, file, code);
    ASSERT_TRUE(start.play([](const Start& now) { return now.live().session().can_leave(); }));
    start.leave();
    study::Database(file, study::Database::Mode::read_write)
        .exec("UPDATE session SET process_start = 'another boot:1'");
  }
  Start again(bundle, file, "S001");
  ASSERT_TRUE(again.play([](const Start& now) { return now.live().resumed(); }));
  EXPECT_EQ(again.live().participant(), "S001");
  EXPECT_FALSE(again.live().session().left());
  EXPECT_FALSE(again.live().session().paused());
  EXPECT_TRUE(again.play([](const Start& now) { return now.live().session().ended(); }));
  again.live().save();
  study::Database database(file, study::Database::Mode::read_only);
  study::Statement row(database,
                       "SELECT outcome, resumed, (SELECT count(*) FROM event WHERE session = "
                       "session.uuid AND kind = 'return') FROM session JOIN participant ON "
                       "participant.uuid = participant ORDER BY code");
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.text(0), "finished");
  EXPECT_EQ(row.integer(1), 0) << "that was no interruption";
  EXPECT_EQ(row.integer(2), 1);
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.text(0), "running");
}

}  // namespace
}  // namespace promenade::app
