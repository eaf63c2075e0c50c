// Around the pages: places, languages, what is not saved, what a stopped desk leaves.
#include "tests/app/desk/desk_bench.h"

namespace promenade::app {
namespace {

class DeskItself : public bench::DeskBench {
 protected:
  void change_the_name(const study::StudyPlace& study) {
    open(study, DeskPlace::edit);
    ASSERT_TRUE(wait_until([this] { return has("type", "study.name"); }));
    write("study.name", "x");
  }
};

TEST_F(DeskItself, HasNoPlaceOfAStudyBeforeOneIsOpen) {
  EXPECT_FALSE(has("go", "edit"));
  desk_.go(DeskPlace::results);
  EXPECT_EQ(desk_.place(), DeskPlace::studies);
}

TEST_F(DeskItself, GoesToEveryPlaceByClickAndByKey) {
  open(make_study("Walks"), DeskPlace::edit);
  for (std::size_t i = 0; i < desk_places; ++i) {
    click("go", std::string(to_text(static_cast<DeskPlace>(i))));
    EXPECT_EQ(desk_.place(), static_cast<DeskPlace>(i));
  }
  for (std::size_t i = 0; i < desk_places; ++i) {
    chord(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_1 + static_cast<int>(i));
    EXPECT_EQ(desk_.place(), static_cast<DeskPlace>(i));
  }
}

TEST_F(DeskItself, SpeaksBothLanguages) {
  open(make_study("Walks"), DeskPlace::edit);
  const float before = widget("go", "takes").box.width;
  press("language");
  EXPECT_NE(widget("go", "takes").box.width, before);
  press("language");
  EXPECT_EQ(widget("go", "takes").box.width, before);
}

TEST_F(DeskItself, SaysElsewhereThatChangesAreNotSaved) {
  const study::StudyPlace study = make_study("Walks");
  change_the_name(study);
  desk_.go(DeskPlace::rehearse);
  frames(2);
  press("save_study");
  EXPECT_FALSE(has("press", "save_study"));
  EXPECT_NE(read_file(study.file()).find("name = \"Walksx\""), std::string::npos);
}

TEST_F(DeskItself, AsksOnceBeforeChangesAreLost) {
  const study::StudyPlace study = make_study("Walks");
  EXPECT_TRUE(desk_.may_close());
  change_the_name(study);
  desk_.go(DeskPlace::studies);
  EXPECT_FALSE(desk_.may_close());
  EXPECT_EQ(desk_.place(), DeskPlace::edit);
  frames(2);
  EXPECT_TRUE(has("press", "save_study"));
  EXPECT_TRUE(desk_.may_close());
}

TEST_F(DeskItself, AsksAboutEveryStudyWithChanges) {
  change_the_name(make_study("Walks"));
  change_the_name(make_study("Other"));
  EXPECT_FALSE(desk_.may_close());
  const study::StudyPlace first = desk_.study()->place();
  EXPECT_FALSE(desk_.may_close());
  EXPECT_NE(desk_.study()->place().folder, first.folder);
  EXPECT_TRUE(desk_.may_close());
}

TEST_F(DeskItself, AsksAgainAfterSomeTime) {
  change_the_name(make_study("Walks"));
  EXPECT_FALSE(desk_.may_close());
  now_us_ += 30'000'000;
  frames(1);
  EXPECT_FALSE(desk_.may_close());
}

TEST_F(DeskItself, SaysThatNothingShowsAReport) {
  const study::StudyPlace study = make_study("Walks");
  write_file(study.rehearsal_report() / "report.html", "x");
  open(study, DeskPlace::rehearse);
  opener_ = false;
  press("report");
  EXPECT_NE(desk_.jobs().trouble(), "");
  EXPECT_TRUE(has("press", "job.close"));
}

TEST_F(DeskItself, FollowsAStudyThatIsRenamed) {
  const study::StudyPlace study = make_study("Walks");
  open(study, DeskPlace::edit);
  desk_.go(DeskPlace::studies);
  ASSERT_TRUE(wait_until([this] { return has("type", "other_name"); }));
  write("other_name", "Steps");
  press("rename");
  desk_.go(DeskPlace::edit);
  frames(2);
  EXPECT_EQ(desk_.study()->place().name(), "Steps");
}

TEST_F(DeskItself, RenamesNoStudyWithChangesThatAreNotSaved) {
  const study::StudyPlace study = make_study("Walks");
  change_the_name(study);
  desk_.go(DeskPlace::studies);
  ASSERT_TRUE(wait_until([this] { return has("type", "other_name"); }));
  write("other_name", "Steps");
  press("rename");
  EXPECT_TRUE(study::is_there(study.file()));
}

TEST_F(DeskItself, KeepsWhatWasChangedInOneStudyWhileAnotherIsOpen) {
  const study::StudyPlace study = make_study("Walks");
  change_the_name(study);
  open(make_study("Other"), DeskPlace::rehearse);
  EXPECT_FALSE(has("press", "save_study"));
  open(study, DeskPlace::rehearse);
  EXPECT_TRUE(has("press", "save_study"));
}

}  // namespace
}  // namespace promenade::app
