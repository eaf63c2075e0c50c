#include "study/study_draft.h"

#include <gtest/gtest.h>

#include "motion/files.h"
#include "tests/test_folder.h"

namespace promenade::study {
namespace {

using Disk = StudyDraft::Disk;

constexpr const char* before = "# head\n[study]\nname = \"a\"   # name\nseed = 1\n";

class Draft : public testing::Test {
 protected:
  Draft() { write_file(file_, before); }
  void set(const char* path, const TomlValue& value, std::string_view gesture = {}) {
    ASSERT_TRUE(draft().change(set_value(toml_path(path), value), gesture)) << draft().refusal();
  }
  StudyDraft& draft() {
    if (!draft_) draft_.emplace(file_.string());
    return *draft_;
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_.path() / "study.toml";
  std::optional<StudyDraft> draft_;
};

TEST_F(Draft, GoesBackToTheVeryBytes) {
  set("study.name", toml_text("b"));
  set("study.order", toml_text("latin"));
  draft().undo();
  draft().undo();
  EXPECT_EQ(draft().text(), before);
  EXPECT_FALSE(draft().can_undo());
  draft().redo();
  EXPECT_EQ(value_at(draft().root(), toml_path("study.name"))->text, "b");
}

TEST_F(Draft, TakesWhatIsTypedInOneFieldAsOneStep) {
  set("study.name", toml_text("ab"), "name");
  set("study.name", toml_text("abc"), "name");
  draft().end_gesture();
  set("study.name", toml_text("abcd"), "name");
  draft().undo();
  EXPECT_EQ(value_at(draft().root(), toml_path("study.name"))->text, "abc");
  draft().undo();
  EXPECT_EQ(draft().text(), before);
}

TEST_F(Draft, LeavesTheTextAloneWhenAChangeIsRefused) {
  EXPECT_FALSE(draft().change(
      {set_value(toml_path("study.seed"), toml_integer(2)), remove_value(toml_path("study.x"))}));
  EXPECT_EQ(draft().text(), before);
  EXPECT_EQ(draft().refusal(), "there is no \"study.x\" in the file");
}

TEST_F(Draft, SavesTheWholeFile) {
  set("study.seed", toml_integer(22));
  EXPECT_FALSE(draft().saved());
  EXPECT_TRUE(draft().save());
  EXPECT_TRUE(draft().saved());
  EXPECT_EQ(read_file(file_), "# head\n[study]\nname = \"a\"   # name\nseed = 22\n");
  EXPECT_FALSE(draft().look());
}

TEST_F(Draft, ReadsAFileAgainThatWasChangedOutside) {
  draft();
  write_file(file_, "[study]\nname = \"theirs\"\n");
  EXPECT_TRUE(draft().look());
  EXPECT_EQ(draft().disk(), Disk::reread);
  EXPECT_EQ(value_at(draft().root(), toml_path("study.name"))->text, "theirs");
  draft().undo();
  EXPECT_EQ(draft().text(), before);
}

TEST_F(Draft, WritesOverNothingThatSomebodyElseWrote) {
  set("study.seed", toml_integer(22));
  write_file(file_, "[study]\nname = \"theirs\"\n");
  EXPECT_FALSE(draft().save());
  EXPECT_EQ(draft().disk(), Disk::both);
  EXPECT_EQ(read_file(file_), "[study]\nname = \"theirs\"\n");
}

TEST_F(Draft, KeepsBothTextsWhicheverIsTaken) {
  set("study.seed", toml_integer(22));
  const std::string mine = draft().text();
  write_file(file_, "[study]\nname = \"theirs\"\n");
  draft().look();
  draft().take_the_files();
  EXPECT_TRUE(draft().saved());
  EXPECT_EQ(draft().text(), "[study]\nname = \"theirs\"\n");
  draft().undo();
  EXPECT_EQ(draft().text(), mine);
}

TEST_F(Draft, WritesOverAnotherTextOnceThatWasAskedFor) {
  set("study.seed", toml_integer(22));
  const std::string mine = draft().text();
  write_file(file_, "[study]\nname = \"theirs\"\n");
  draft().look();
  draft().keep_mine();
  EXPECT_TRUE(draft().save());
  EXPECT_EQ(read_file(file_), mine);
  draft().undo();
  EXPECT_EQ(draft().text(), "[study]\nname = \"theirs\"\n");
}

TEST_F(Draft, WritesAFileAgainThatIsGone) {
  draft();
  std::filesystem::remove(file_);
  EXPECT_TRUE(draft().look());
  EXPECT_EQ(draft().disk(), Disk::gone);
  EXPECT_FALSE(draft().saved());
  EXPECT_TRUE(draft().save());
  EXPECT_EQ(read_file(file_), before);
}

TEST_F(Draft, HoldsATextThatIsNoToml) {
  draft().write("[study]\nname = = 1\n");
  EXPECT_FALSE(draft().is_toml());
  EXPECT_FALSE(draft().change(set_value(toml_path("study.seed"), toml_integer(2))));
  draft().undo();
  EXPECT_TRUE(draft().is_toml());
}

}  // namespace
}  // namespace promenade::study
