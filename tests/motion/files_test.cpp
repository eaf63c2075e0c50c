#include "motion/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "motion/problem.h"

namespace promenade {
namespace {

class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("files_test." + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(Files, ComeBackByteForByte) {
  const std::string bytes("a\0b\r\n\xff", 6);
  write_file(folder_ / "deep" / "down", bytes);
  EXPECT_EQ(read_file(folder_ / "deep" / "down"), bytes);
}

TEST_F(Files, AreReplacedWholeAndLeaveNothingBeside) {
  write_file(folder_ / "f", "old");
  write_file(folder_ / "f", "new");
  EXPECT_EQ(read_file(folder_ / "f"), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(Files, ThatAreMissingOrFoldersAreInputErrors) {
  EXPECT_THROW(read_file(folder_ / "none"), InputError);
  EXPECT_THROW(read_file(folder_), InputError);
}

// Both would never be read to an end.
TEST_F(Files, ThatArePipesOrDevicesAreInputErrors) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(read_file(folder_ / "pipe"), InputError);
  EXPECT_THROW(read_file("/dev/zero"), InputError);
}

TEST_F(Files, ThatCannotBeWrittenSayWhereAndLeaveNothing) {
  std::filesystem::create_directories(folder_ / "taken" / "inside");
  try {
    write_file(folder_ / "taken", "x");
    FAIL() << "a folder was replaced by a file";
  } catch (const OutsideError& error) {
    EXPECT_NE(std::string(error.what()).find("taken"), std::string::npos);
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST(AProblem, NamesItsPlaceAsCompilersDo) {
  EXPECT_EQ(to_text({"a.toml", 3, 7, "no such key", {}}), "a.toml:3:7: error: no such key");
  EXPECT_EQ(to_text({"a.toml", 3, 0, "odd", Severity::warning}), "a.toml:3: warning: odd");
  EXPECT_EQ(to_text({"a.toml", 0, 0, "is empty", {}}), "a.toml: error: is empty");
}

TEST(AnInputError, SaysAllItsProblems) {
  const InputError error({{"a", 1, 1, "x", {}}, {"b", 2, 2, "y", {}}});
  EXPECT_STREQ(error.what(), "a:1:1: error: x\nb:2:2: error: y");
}

TEST_F(Files, ThatCannotBeWrittenLeaveNoFolderBehind) {
  const std::string too_long(300, 'x');
  EXPECT_THROW(write_file(folder_ / "new" / "deep" / too_long, "a"), OutsideError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "new"));
}

TEST_F(Files, OfOneFolderAreWrittenAllOrNone) {
  write_file(folder_ / "old", "1");
  EXPECT_THROW(write_files(folder_ / "new", {{"a", "1"}, {std::string(300, 'x'), "2"}}),
               OutsideError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "new"));
  EXPECT_THROW(write_files(folder_, {{"b", "1"}, {std::string(300, 'x'), "2"}}), OutsideError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "b"));
  EXPECT_EQ(read_file(folder_ / "old"), "1");
  write_files(folder_ / "new", {{"a", "1"}, {"b", "2"}});
  EXPECT_EQ(read_file(folder_ / "new" / "b"), "2");
}

}  // namespace
}  // namespace promenade
