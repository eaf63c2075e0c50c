// The Edit page without a window: a study in a folder of its own.
#pragma once

#include "app/desk/edit/edit_page.h"
#include "app/desk/words.h"
#include "motion/files.h"
#include "tests/app/hands.h"
#include "tests/test_folder.h"

namespace promenade::app::bench {

inline constexpr const char* edit_study = R"(# A study to edit.
[study]
name = "walks"      # of the study
set = "builtin:A"
languages = ["en", "ja"]

[[interface]]
name = "labels"

[[interface]]
name = "map"

[[task]]
name = "match"
kind = "match"      # make it
limit_s = 45
targets = [
  { example = "proud" },  # the first
  { name = "weary", weights = { sad = 0.5, old = 0.5 } },
]

[[task]]
name = "find"
kind = "find"
qualities = [{ name = "tired", en = "tired", ja = "疲れた" }]

# The end.
)";

class EditBench : public HandsTest {
 protected:
  explicit EditBench(std::string text = edit_study, int width = 1280, int height = 720,
                     const char* language = "en")
      : text_(std::move(text)),
        gui_(make_palette(false), {"日本語", "あ"}),
        page_(queue_),
        words_(desk_texts(language)) {
    write_file(file_, text_);
    edit_ = std::make_unique<EditPage>(file_.string());
    fit_without_card(gui_, width, height);
    frames(2);
  }

  void draw_frame() override {
    edit_->advance(now_us_);
    page_.frame(gui_, [this](const Ui& ui) {
      const ImVec2 size = ImGui::GetIO().DisplaySize;
      const float head = ui.layout.size(56);
      edit_->draw(ui, words_, {0, head, size.x, size.y - head});
    });
  }
  const WidgetMap& widgets() const override { return page_.widgets(); }
  const Focus& focus() const override { return page_.focus(); }
  // Until what stands in the text now has been checked.
  void check() {
    now_us_ += 1'000'000;
    frames(1);
    edit_->checker().wait();
    frames(2);
  }
  // What stood in the field is replaced.
  void write(const std::string& target, const std::string& text) {
    click("type", target);
    control(GLFW_KEY_A);
    key(GLFW_KEY_BACKSPACE);
    type(text);
  }
  void choose(const std::string& target, int index) {
    click("open", target);
    click("choose", target + "/" + std::to_string(index));
  }
  const std::string& text() const { return edit_->draft()->text(); }
  // The text of the study with one piece of it replaced.
  std::string with(const std::string& from, const std::string& to) const {
    std::string text = text_;
    return text.replace(text.find(from), from.size(), to);
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_.path() / "study.toml";
  std::string text_;
  Gui gui_;
  ToolPage page_;
  study::Texts words_;
  std::unique_ptr<EditPage> edit_;
};

}  // namespace promenade::app::bench
