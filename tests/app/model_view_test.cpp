// The window of a model, without a window: the tree is cut, thresholds move, clusters are named,
// and what was made is saved.
#include "app/model_view.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/model_file.h"
#include "motion/problem.h"
#include "study/adjective_model_file.h"
#include "study/study.h"

namespace promenade::app {
namespace {

class ModelWindow : public testing::Test {
 protected:
  explicit ModelWindow(ModelEditor editor = ModelEditor(*study::builtin_adjective_model("A")),
                       int width = 1280, int height = 720)
      : editor_(std::move(editor)),
        gui_(make_palette(false), shown_words(editor_)),
        view_(editor_, gui_, queue_, [this](const study::AdjectiveModel& model) {
          if (disk_full_) throw OutsideError("the disk is full");
          saved_ = model_file(model);
        }) {
    gui_.fit(width, height);
    unsigned char* pixels = nullptr;
    int wide = 0;
    int high = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &wide, &high);
    view_.frame();
    view_.frame();
  }

  void push(UiEvent event) {
    queue_.push(event);
    view_.frame();
    view_.frame();
  }
  void move_to(float x, float y) { push({.kind = UiEvent::Kind::move, .x = x, .y = y}); }
  void press() { push({.kind = UiEvent::Kind::button, .code = 0, .down = true}); }
  void release() { push({.kind = UiEvent::Kind::button, .code = 0, .down = false}); }
  const Widget& widget(const char* kind, const char* target) {
    const Widget* found = view_.widgets().find(kind, target);
    if (found == nullptr) throw std::logic_error(std::string("there is no ") + target);
    return *found;
  }
  void click(const char* kind, const char* target) {
    const Box box = widget(kind, target).box;
    move_to(box.middle_x(), box.middle_y());
    press();
    release();
  }
  void drag(const char* target, double value) {
    const Widget bar = widget("slide", target);
    move_to(std::min(bar.knob, bar.box.right() - 1), bar.box.middle_y());
    press();
    move_to(bar.at_zero + static_cast<float>(value) * (bar.at_one - bar.at_zero),
            bar.box.middle_y());
    release();
  }
  void key(int code) {
    push({.kind = UiEvent::Kind::key, .code = code, .down = true});
    push({.kind = UiEvent::Kind::key, .code = code, .down = false});
  }
  void type(const std::string& ascii) {
    for (const char c : ascii) push({.kind = UiEvent::Kind::character, .code = c});
  }

  ModelEditor editor_;
  Gui gui_;
  InputQueue queue_;
  ModelView view_;
  std::string saved_;
  bool disk_full_ = false;
};

TEST_F(ModelWindow, CutsWhereTheLineIsDragged) {
  EXPECT_EQ(editor_.names().size(), 4U);
  drag("cut", motion::cut_height(editor_.tree(), 2) / editor_.top());
  EXPECT_EQ(editor_.names().size(), 2U);
  EXPECT_EQ(editor_.cluster(), motion::cut(editor_.tree(), 2)) << "the colours follow";
  drag("cut", 1);
  EXPECT_EQ(editor_.names().size(), 1U);
  drag("cut", 0);
  EXPECT_EQ(editor_.names().size(), editor_.leaves().size());
}

TEST_F(ModelWindow, CutsByTheArrowKeysToo) {
  const double before = editor_.cut();
  drag("cut", before / editor_.top());
  key(GLFW_KEY_RIGHT);
  EXPECT_GT(editor_.cut(), before);
  key(GLFW_KEY_END);
  EXPECT_EQ(editor_.names().size(), 1U);
}

TEST_F(ModelWindow, GivesAClusterTheNameThatIsWritten) {
  const std::vector<int> cluster = editor_.cluster();
  click("rename", "1");
  for (int i = 0; i < 20; ++i) key(GLFW_KEY_BACKSPACE);
  type("poise");
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(editor_.names()[1], "poise");
  EXPECT_EQ(editor_.cluster(), cluster);
  drag("cut", 1);
  drag("cut", motion::cut_height(editor_.tree(), 4) / editor_.top());
  EXPECT_EQ(editor_.names()[1], "poise") << "it comes back with its pairs";
}

TEST_F(ModelWindow, KeepsTheNameWhenEscapeIsPressed) {
  const std::string before = editor_.names()[0];
  click("rename", "0");
  type("x");
  key(GLFW_KEY_ESCAPE);
  EXPECT_EQ(editor_.names()[0], before);
  EXPECT_EQ(view_.widgets().find("write", "name"), nullptr);
}

TEST_F(ModelWindow, DropsPairsByItsTwoThresholds) {
  const std::size_t kept = editor_.leaves().size();
  drag("sigma", 0.25);  // 0.5 of 2
  EXPECT_LT(editor_.leaves().size(), kept);
  EXPECT_NEAR(editor_.model()->options.most_deviation, 0.5, 0.03);
  drag("sigma", 0);
  EXPECT_TRUE(editor_.leaves().empty()) << "and nothing breaks";
  drag("sigma", 0.425);
  EXPECT_EQ(editor_.leaves().size(), kept);
}

TEST_F(ModelWindow, SavesWhatItShows) {
  drag("cut", motion::cut_height(editor_.tree(), 3) / editor_.top());
  click("press", "save");
  ASSERT_FALSE(saved_.empty()) << view_.said();
  EXPECT_EQ(view_.said(), "Saved");
  const study::AdjectiveModel model = study::read_adjective_model("m.toml", saved_);
  EXPECT_EQ(model.names.size(), 3U);
  EXPECT_EQ(model.options.clusters, 3);
  EXPECT_TRUE(model.simulated());
  drag("sigma", 0.4);
  EXPECT_EQ(view_.said(), "") << "it is not what was saved any more";
}

TEST_F(ModelWindow, SavesNothingOfRatingsThatDoNotAgree) {
  drag("sigma", 0);
  click("press", "save");
  EXPECT_TRUE(saved_.empty());
}

TEST_F(ModelWindow, SaysWhyItCannotSave) {
  disk_full_ = true;
  click("press", "save");
  EXPECT_EQ(view_.said(), "the disk is full");
  disk_full_ = false;
  editor_.rename(0, editor_.names()[1]);
  view_.frame();
  click("press", "save");
  EXPECT_NE(view_.said().find("another slider"), std::string::npos) << view_.said();
}

class FeatureWindow : public ModelWindow {
 protected:
  FeatureWindow()
      : ModelWindow(ModelEditor(study::load_motion_set("builtin:B", ""), 4), 2560, 1440) {}
};

TEST_F(FeatureWindow, ShowsTheFeaturesByTheSameCode) {
  EXPECT_EQ(editor_.leaves().size(), 51U);
  EXPECT_EQ(editor_.names().size(), 4U);
  drag("cut", motion::cut_height(editor_.tree(), 6) / editor_.top());
  EXPECT_EQ(editor_.names().size(), 6U);
  EXPECT_EQ(view_.widgets().find("slide", "mu_star"), nullptr);
  EXPECT_EQ(view_.widgets().find("rename", "0"), nullptr);
}

}  // namespace
}  // namespace promenade::app
