// What is beside the form: the walks, a preview of an interface, and the table of distances.
#include <poll.h>

#include "tests/app/desk/edit/edit_bench.h"

namespace promenade::app {
namespace {

using study::toml_path;

class EditMotions : public bench::EditBench {
 protected:
  explicit EditMotions(const std::string& set = "A")
      : EditBench(
            std::string(bench::edit_study)
                .replace(std::string(bench::edit_study).find("builtin:A"), 9, "builtin:" + set)) {
    check();
  }
  bool walks(const std::string& name) {
    const std::vector<std::string>& walking = edit_->walks().walking();
    return std::find(walking.begin(), walking.end(), name) != walking.end();
  }
  // Somebody wrote that into the file.
  void reread(const std::string& text) {
    write_file(file_, text);
    now_us_ += 1'000'000;
    frames(1);
    check();
  }
};

std::string with_error(std::string text) {
  return text.replace(text.find("kind = \"find\""), 13, "kind = \"findd\"");
}

class EditManyMotions : public EditMotions {
 protected:
  EditManyMotions() : EditMotions("N") {}
};

TEST_F(EditMotions, MakesAWalkATargetOfATask) {
  press("side/1");
  press("walk/happy");
  EXPECT_EQ(edit_->walks().chosen(), "happy");
  press("use_walk");
  EXPECT_EQ(text(), with("old = 0.5 } },\n", "old = 0.5 } },\n  { example = \"happy\" },\n"));
}

TEST_F(EditMotions, LetsAWalkWalkUnderTheHandAndTheKeyboard) {
  press("side/1");
  EXPECT_FALSE(walks("sad"));
  const Box box = widget("press", "walk/sad").box;
  push({.kind = UiEvent::Kind::move, .x = box.middle_x(), .y = box.middle_y()});
  EXPECT_TRUE(walks("sad"));
  tab_to("press", "walk/happy");
  EXPECT_TRUE(walks("happy"));
  key(GLFW_KEY_RIGHT);
  EXPECT_FALSE(walks("happy"));
  key(GLFW_KEY_LEFT);
  EXPECT_TRUE(walks("happy"));
}

TEST_F(EditMotions, PreviewsAnInterfaceWithItsControls) {
  press("side/2");
  frames(2);
  const Eigen::VectorXd before = edit_->preview().weights();
  click("pick", "happy");
  frames(60);
  EXPECT_FALSE(edit_->preview().weights().isApprox(before));
}

TEST_F(EditMotions, PreviewsNothingWhileTheFiguresAreOfAnotherSet) {
  press("side/2");
  ASSERT_TRUE(has("open", "preview"));
  const std::string other = with("builtin:A", "builtin:N");
  reread(with_error(other));
  ASSERT_TRUE(edit_->check()->has_errors());
  EXPECT_FALSE(has("open", "preview"));
  reread(other);
  EXPECT_TRUE(has("open", "preview"));
}

TEST_F(EditMotions, ShowsWhichFeaturesGoTogether) {
  press("side/2");
  choose("preview", 2);
  for (int k = 0; k < 1000 && edit_->preview().tree() == nullptr; ++k) {
    frames(1);
    ::poll(nullptr, 0, 5);
  }
  frames(2);
  ASSERT_NE(edit_->preview().tree(), nullptr);
  EXPECT_EQ(edit_->preview().tree()->names().size(), 4U);
  EXPECT_TRUE(has("slide", "cut"));
}

TEST_F(EditMotions, TellsHowNearEachInterfaceComes) {
  press("side/3");
  for (int k = 0; k < 4000 && edit_->distances().reports().size() < 2; ++k) {
    frames(1);
    ::poll(nullptr, 0, 5);
  }
  const std::vector<TargetReport>& reports = edit_->distances().reports();
  ASSERT_EQ(reports.size(), 2);
  EXPECT_EQ(reports.front().target, "proud");
  ASSERT_EQ(reports.front().reaches.size(), 2);
  EXPECT_EQ(reports.front().reaches.front().interface, "labels");
  EXPECT_NEAR(reports.front().reaches.front().reach.best, 0, 1e-9);
}

TEST_F(EditMotions, KeepsTheWalksOfAStudyWithErrors) {
  write("study.participants", "0.5");
  write("study.version", "2");
  write("study.name", "a/b");
  check();
  ASSERT_TRUE(edit_->check()->has_errors());
  press("side/1");
  EXPECT_TRUE(has("press", "walk/happy"));
}

TEST_F(EditManyMotions, ShowsFiftyFiveWalksAndReachesTheLast) {
  press("side/1");
  int walks = 0;
  for (std::size_t i = 0; i < page_.widgets().size(); ++i) {
    walks += page_.widgets()[i].target.starts_with("walk/") ? 1 : 0;
  }
  EXPECT_EQ(walks, 55);
  click("press", "walk/wrestler");
  EXPECT_EQ(edit_->walks().chosen(), "wrestler");
}

}  // namespace
}  // namespace promenade::app
