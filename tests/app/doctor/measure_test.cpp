#include "app/doctor/measure.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace promenade::app {
namespace {

namespace fs = std::filesystem;

class Folder {
 public:
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  fs::path path = fs::temp_directory_path() / ("promenade_doctor_" + std::to_string(getpid()));
};

TEST(MeasureDisk, CommitsAreTimedAndNothingIsLeft) {
  const Folder folder;
  const DiskFinding disk = measure_disk(folder.path / "study.db", 7);
  EXPECT_EQ(disk.folder, folder.path.string());
  EXPECT_EQ(disk.problem, "");
  EXPECT_EQ(disk.commit_us.size(), 7U);
  EXPECT_GT(disk.free_bytes, 0);
  EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST(MeasureDisk, AFolderThatIsNotThereIsNotMade) {
  const Folder folder;
  const DiskFinding disk = measure_disk(folder.path / "later" / "deep" / "study.db", 1);
  EXPECT_EQ(disk.folder, folder.path.string());
  EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST(MeasureDisk, WhereNothingCanBeWrittenItSaysSo) {
  const DiskFinding disk = measure_disk("/proc/study.db", 1);
  EXPECT_NE(disk.problem.find("nothing can be stored in /proc"), std::string::npos);
  EXPECT_NE(disk.problem.find("--db"), std::string::npos);
}

TEST(MeasureFonts, EveryCharacterThatIsLoadedIsThere) {
  EXPECT_TRUE(measure_fonts({"Straße, naïve\n", "歩き方"}).missing.empty());
}

TEST(MeasureFonts, WhatNoFontHasIsMissingOnce) {
  // A letter of the private area, and one beyond the basic plane.
  const FontFinding fonts = measure_fonts({"a\uE123", "\uE123", "😀b"});
  EXPECT_EQ(fonts.missing, (std::vector<std::string>{"\uE123", "😀"}));
}

TEST(MeasureClock, ItGoesForwardInSmallSteps) {
  const ClockFinding clock = measure_clock();
  EXPECT_FALSE(clock.ran_back);
  EXPECT_GT(clock.step_ns, 0);
  EXPECT_LT(clock.step_ns, 1'000'000);
}

}  // namespace
}  // namespace promenade::app
