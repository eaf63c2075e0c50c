// The list of studies, by mouse and by keyboard.
#include "tests/app/desk/desk_bench.h"

namespace promenade::app {
namespace {

class StudiesDesk : public bench::DeskBench {
 protected:
  std::filesystem::path folder(const std::string& name) {
    return folder_.path() / "studies" / name / "study.toml";
  }
};

TEST_F(StudiesDesk, MakesAStudyOfATemplate) {
  click("open", "template");
  click("choose", "template/5");
  write("new_name", "Walks of spring");
  press("make");
  EXPECT_TRUE(std::filesystem::exists(folder("Walks of spring")));
  EXPECT_TRUE(has("study", "Walks of spring"));
}

TEST_F(StudiesDesk, NamesAStudyThatNobodyNamed) {
  press("make");
  press("make");
  EXPECT_TRUE(has("study", "Demo"));
  EXPECT_TRUE(has("study", "Demo 2"));
}

TEST_F(StudiesDesk, OpensTheChosenStudyByASecondPress) {
  press("make");
  click("study", "Demo");
  EXPECT_EQ(desk_.place(), DeskPlace::edit);
  EXPECT_TRUE(has("go", "results"));
}

TEST_F(StudiesDesk, DuplicatesAndRenames) {
  press("make");
  write("other_name", "Pilot");
  press("duplicate");
  EXPECT_TRUE(std::filesystem::exists(folder("Pilot")));
  write("other_name", "Second");
  press("rename");
  EXPECT_FALSE(std::filesystem::exists(folder("Pilot")));
  EXPECT_TRUE(has("study", "Second"));
  EXPECT_TRUE(has("study", "Demo"));
}

TEST_F(StudiesDesk, CopiesAStudyFileThatIsDropped) {
  press("make");
  desk_.dropped({folder("Demo").string(), "/nowhere/picture.png"});
  frames(2);
  EXPECT_TRUE(has("study", "study"));
}

TEST_F(StudiesDesk, IsWorkedByTheKeyboardAlone) {
  tab_to("type", "new_name");
  type("By hand");
  key(GLFW_KEY_ENTER);
  ASSERT_TRUE(has("study", "By hand"));
  tab_to("study", "By hand");
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(desk_.place(), DeskPlace::edit);
  chord(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_1);
  EXPECT_EQ(desk_.place(), DeskPlace::studies);
}

TEST_F(StudiesDesk, ChoosesATemplateByTheArrowKeys) {
  tab_to("open", "template");
  key(GLFW_KEY_DOWN);
  tab_to("press", "make");
  key(GLFW_KEY_SPACE);
  EXPECT_TRUE(has("study", "Tour"));
}

TEST_F(StudiesDesk, KeepsControlsInsideTheWindowWithALongName) {
  write("new_name", std::string(60, 'W'));
  press("make");
  press("language");
  for (std::size_t i = 0; i < desk_.widgets().size(); ++i) {
    const Widget& one = desk_.widgets()[i];
    EXPECT_LE(one.box.right(), 1280) << one.kind << " " << one.target;
    EXPECT_LE(one.box.bottom(), 720) << one.kind << " " << one.target;
  }
}

}  // namespace
}  // namespace promenade::app
