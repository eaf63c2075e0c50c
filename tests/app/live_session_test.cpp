#include "app/live_session.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "app/registry.h"
#include "study/load_study.h"
#include "study/sqlite.h"

namespace promenade::app {
namespace {

study::SessionHeader header() {
  study::SessionHeader header;
  header.started_utc = "2026-01-02T03:04:05Z";
  return header;
}

// A session that began at one second on the monotonic clock, and its file as
// another process sees it.
struct Fixture {
  std::filesystem::path file = std::filesystem::temp_directory_path() /
                               ("promenade_live_" + std::to_string(getpid()) + ".db");
  study::StudyBundle bundle = study::load_study("configs/demo.toml", interfaces());
  study::Store store{file, bundle};
  LiveSession live{study::Session(bundle, interfaces(), study::make_plan(bundle.study, 0)), store,
                   header(), 1'000'000};

  ~Fixture() {
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(file.string() + end);
  }
  std::string ask(const std::string& query) const {
    study::Database database(file.string(), study::Database::Mode::read_only);
    study::Statement statement(database, query);
    return statement.step() ? statement.text(0) : "nothing";
  }
  std::string presses() const { return ask("SELECT count(*) FROM event WHERE kind = 'press'"); }
};

TEST(LiveSession, TheSessionStartsWhenItsTimeBeginsNotWhenItIsRecorded) {
  Fixture session;
  session.live.tick(31'000'000);
  session.live.record_as("P1", true);
  session.live.flush(31'000'000);
  EXPECT_EQ(session.ask("SELECT started_utc FROM session"), "2026-01-02T03:04:05Z");
}

TEST(LiveSession, WhatHappensIsOnTheDiskOneFrameLater) {
  Fixture session;
  session.live.record_as("P1", true);
  session.live.flush(2'000'000);
  for (std::int64_t k = 1; k <= 3; ++k) {
    const std::int64_t t_us = 2'000'000 + k * 16'667;
    session.live.take(study::Press{}, {.t_us = t_us});
    session.live.flush(t_us);
    EXPECT_EQ(session.presses(), std::to_string(k));
  }
}

TEST(LiveSession, AFasterDisplayGathersFifteenMilliseconds) {
  Fixture session;
  session.live.record_as("P1", true);
  session.live.take(study::Press{}, {.t_us = 2'000'000});
  session.live.flush(2'000'000);
  session.live.take(study::Press{}, {.t_us = 2'007'000});
  session.live.flush(2'007'000);
  EXPECT_EQ(session.presses(), "1");
  session.live.flush(2'015'000);
  EXPECT_EQ(session.presses(), "2");
}

// The frames that were handed over, by trial.
struct Kept {
  std::vector<std::pair<int, std::int64_t>> frames;

  void follow(LiveSession& live) {
    live.keep_frames([this](int trial, const study::FrameHistogram& histogram) {
      frames.emplace_back(trial, histogram.work.count());
    });
  }
};

TEST(LiveSession, FramesAreKeptForEachTrialAndForAllOtherPages) {
  Fixture session;
  Kept kept;
  kept.follow(session.live);
  session.live.record_as("P1", true);
  int before = 0;
  for (; session.live.session().trial() == nullptr; ++before) {
    session.live.count({.work_us = 9000});
    session.live.take(study::Continue{}, {.t_us = 2'000'000});
  }
  for (int k = 0; k < 5; ++k) session.live.count({.work_us = 9000});
  session.live.take(study::Stop{"test"}, {.t_us = 3'000'000});
  EXPECT_EQ(kept.frames, (std::vector<std::pair<int, std::int64_t>>{{0, 5}, {-1, before}}));
}

TEST(LiveSession, FramesThatCannotBeKeptEndItAsAFullDiskDoes) {
  Fixture session;
  session.live.keep_frames(
      [](int, const study::FrameHistogram&) { throw OutsideError("the disk is full"); });
  session.live.record_as("P1", true);
  session.live.take(study::Stop{"test"}, {.t_us = 2'000'000});
  EXPECT_EQ(session.live.failure(), "the disk is full");
}

}  // namespace
}  // namespace promenade::app
