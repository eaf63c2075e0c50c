// The Edit page by mouse and keyboard: what is changed in the form is changed in the file.
#include "tests/app/desk/edit/edit_bench.h"

namespace promenade::app {
namespace {

class Edit : public bench::EditBench {
 protected:
  void choose_line(int line) {
    tab_to("press", "file");
    while (edit_->line() != line) key(edit_->line() < line ? GLFW_KEY_DOWN : GLFW_KEY_UP);
  }
};

TEST_F(Edit, ChangesATextWhereItStands) {
  write("study.name", "runs");
  EXPECT_EQ(text(), with("\"walks\"", "\"runs\""));
  control(GLFW_KEY_Z);
  EXPECT_EQ(text(), text_);
  EXPECT_TRUE(has("type", "study.name"));
  control(GLFW_KEY_Y);
  EXPECT_EQ(text(), with("\"walks\"", "\"runs\""));
}

TEST_F(Edit, AddsAKeyThatWasLeftOut) {
  write("study.participants", "24");
  EXPECT_EQ(text(), with("languages = [\"en\", \"ja\"]\n",
                         "languages = [\"en\", \"ja\"]\nparticipants = 24\n"));
  write("study.participants", "");
  EXPECT_EQ(text(), text_);
}

TEST_F(Edit, KeepsANumberThatIsNoneOutOfTheFile) {
  write("study.participants", "many");
  EXPECT_EQ(text(), text_);
}

TEST_F(Edit, ChoosesOneOfSeveral) {
  click("section", "order");
  choose("study.order", 2);
  EXPECT_EQ(text(), with("languages = [\"en\", \"ja\"]\n",
                         "languages = [\"en\", \"ja\"]\norder = \"latin\"\n"));
  choose("study.order", 0);
  EXPECT_EQ(text(), text_);
}

TEST_F(Edit, TicksLanguages) {
  click("section", "texts");
  click("tick", "study.languages/ja");
  EXPECT_EQ(text(), with("[\"en\", \"ja\"]", "[\"en\"]"));
}

TEST_F(Edit, WritesATitleInEachLanguage) {
  click("section", "texts");
  write("study.title/en", "Walks");
  write("study.title/ja", "歩");
  EXPECT_EQ(text(),
            with("languages = [\"en\", \"ja\"]\n",
                 "languages = [\"en\", \"ja\"]\ntitle = { en = \"Walks\", ja = \"歩\" }\n"));
}

TEST_F(Edit, MovesAndRemovesAnInterface) {
  click("section", "interfaces");
  press("down/interface[0]");
  EXPECT_EQ(text(), with("\"labels\"\n\n[[interface]]\nname = \"map\"",
                         "\"map\"\n\n[[interface]]\nname = \"labels\""));
  press("remove/interface[0]");
  EXPECT_EQ(text(), with("[[interface]]\nname = \"labels\"\n\n[[interface]]\nname = \"map\"",
                         "[[interface]]\nname = \"labels\""));
}

TEST_F(Edit, AddsAnInterfaceThatIsNotThereYet) {
  click("section", "interfaces");
  press("add/interface");
  EXPECT_EQ(text(),
            with("name = \"map\"\n", "name = \"map\"\n\n[[interface]]\nname = \"adjectives\"\n"));
}

TEST_F(Edit, ChangesASettingOfAnInterface) {
  click("section", "interfaces");
  press("item/interface[0]");
  click("tick", "interface[0].sorted");
  EXPECT_EQ(text().find("sorted = false"), text().find("\"labels\"\n") + 9);
}

TEST_F(Edit, ChangesATarget) {
  check();
  click("section", "tasks");
  press("item/task[0]");
  press("item/task[0].targets[0]");
  choose("task[0].targets[0].example", 1);
  const std::string walk =
      study::value_at(edit_->draft()->root(), study::toml_path("task[0].targets[0].example"))->text;
  EXPECT_NE(walk, "proud");
  EXPECT_EQ(text(), with("\"proud\"", "\"" + walk + "\""));
}

TEST_F(Edit, ChangesTheSharesOfAMixture) {
  click("section", "tasks");
  press("item/task[0]");
  press("item/task[0].targets[1]");
  write("task[0].targets[1].weights", "sad 0.25, old 0.75");
  EXPECT_EQ(text(), with("sad = 0.5, old = 0.5", "sad = 0.25, old = 0.75"));
}

TEST_F(Edit, ChangesAQualityInEachLanguage) {
  click("section", "tasks");
  press("item/task[1]");
  press("item/task[1].qualities[0]");
  write("task[1].qualities[0]/ja", "元気");
  EXPECT_EQ(text(), with("\"疲れた\"", "\"元気\""));
}

TEST_F(Edit, ShowsAProblemAtItsFieldAndLeadsToIt) {
  click("section", "tasks");
  press("item/task[0]");
  press("item/task[0].targets[0]");
  click("section", "study");
  write("study.name", "a/b");
  check();
  ASSERT_TRUE(edit_->check()->has_errors());
  EXPECT_TRUE(has("problem", "study.name"));
  click("section", "order");
  press("problem/0");
  EXPECT_EQ(page_.focus().on("type", "study.name"), true);
  EXPECT_TRUE(widget("type", "study.name").visible());
}

TEST_F(Edit, SavesByKeyAndSaysSo) {
  write("study.name", "runs");
  EXPECT_FALSE(edit_->draft()->saved());
  control(GLFW_KEY_S);
  EXPECT_TRUE(edit_->draft()->saved());
  EXPECT_EQ(read_file(file_), with("\"walks\"", "\"runs\""));
}

TEST_F(Edit, ReadsAFileAgainThatWasChangedOutside) {
  write_file(file_, with("\"walks\"", "\"theirs\""));
  now_us_ += 1'000'000;
  frames(2);
  EXPECT_EQ(text(), with("\"walks\"", "\"theirs\""));
  press("seen");
  EXPECT_FALSE(has("press", "seen"));
}

TEST_F(Edit, AsksWhichTextToTakeWhenBothWereChanged) {
  write("study.name", "mine");
  write_file(file_, with("\"walks\"", "\"theirs\""));
  control(GLFW_KEY_S);
  EXPECT_EQ(read_file(file_), with("\"walks\"", "\"theirs\""));
  press("keep_mine");
  press("save");
  EXPECT_EQ(read_file(file_), with("\"walks\"", "\"mine\""));
}

TEST_F(Edit, GoesToTheFieldOfALineThatIsPressed) {
  click("section", "display");
  const Box file = widget("press", "file").view;
  push({.kind = UiEvent::Kind::move, .x = file.x + 100, .y = file.y + 3.5 * 22});
  push({.kind = UiEvent::Kind::button, .down = true});
  push({.kind = UiEvent::Kind::button, .down = false});
  EXPECT_EQ(study::to_text(edit_->form().focused()), "study.set");
}

TEST_F(Edit, WritesALineOfTheFileByHand) {
  click("section", "tasks");
  choose_line(3);
  write("file_line", "name = \"by hand\"");
  EXPECT_EQ(text(), text_);
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(text(), with("name = \"walks\"      # of the study", "name = \"by hand\""));
}

TEST_F(Edit, KeepsWhatWasWrittenInALineThatIsLeft) {
  const Box file = widget("press", "file").view;
  write("file_line", "# Another head.");
  push({.kind = UiEvent::Kind::move, .x = file.x + 100, .y = file.y + 3.5 * 22});
  push({.kind = UiEvent::Kind::button, .down = true});
  push({.kind = UiEvent::Kind::button, .down = false});
  EXPECT_EQ(text(), with("# A study to edit.", "# Another head."));
}

TEST_F(Edit, SavesTheLineThatIsBeingWritten) {
  write("file_line", "# Another head.");
  EXPECT_TRUE(edit_->unsaved());
  control(GLFW_KEY_S);
  EXPECT_EQ(read_file(file_), with("# A study to edit.", "# Another head."));
  EXPECT_FALSE(edit_->unsaved());
  type("!");
  EXPECT_TRUE(edit_->unsaved());
  edit_->save();
  EXPECT_EQ(read_file(file_), with("# A study to edit.", "# Another head.!"));
}

TEST_F(Edit, PutsALineThatIsBeingWrittenIntoNoOther) {
  write("file_line", "# Another head.");
  write_file(file_, "# New.\n" + text_);
  now_us_ += 1'000'000;
  edit_->advance(now_us_);
  edit_->save();
  EXPECT_EQ(read_file(file_), "# New.\n" + text_);
}

TEST_F(Edit, RepairsAFileThatCannotBeRead) {
  write_file(file_, with("[study]", "[study"));
  now_us_ += 1'000'000;
  check();
  EXPECT_FALSE(edit_->draft()->is_toml());
  EXPECT_FALSE(has("section", "study"));
  choose_line(2);
  write("file_line", "[study]");
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(text(), text_);
  EXPECT_TRUE(has("section", "study"));
}

// Every control of a section, by the Tab key alone.
TEST_F(Edit, IsReachedByTheKeyboardAlone) {
  tab_to("section", "tasks");
  key(GLFW_KEY_ENTER);
  tab_to("press", "item/task[0]");
  key(GLFW_KEY_ENTER);
  tab_to("type", "task[0].limit_s");
  control(GLFW_KEY_A);
  type("60");
  EXPECT_EQ(text(), with("limit_s = 45", "limit_s = 60"));
  tab_to("open", "task[0].kind");
  key(GLFW_KEY_DOWN);
  EXPECT_EQ(study::value_at(edit_->draft()->root(), study::toml_path("task[0].kind"))->text,
            "guess");
}

}  // namespace
}  // namespace promenade::app
