// The Edit page without a window: a study in a folder of its own, and hands that click, type and
// press keys.
#pragma once

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "app/desk/edit_page.h"
#include "app/desk/words.h"
#include "motion/files.h"
#include "study/utf8.h"
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

class EditBench : public testing::Test {
 protected:
  explicit EditBench(std::string text = edit_study, int width = 1280, int height = 720,
                     const char* language = "en")
      : text_(std::move(text)),
        gui_(make_palette(false), {"日本語", "あ"}),
        page_(queue_),
        words_(desk_texts(language)) {
    write_file(file_, text_);
    edit_ = std::make_unique<EditPage>(file_.string());
    gui_.fit(width, height);
    unsigned char* pixels = nullptr;
    int wide = 0;
    int high = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &wide, &high);
    frames(2);
  }

  void frames(int count) {
    for (int k = 0; k < count; ++k) {
      now_us_ += 16'667;
      edit_->advance(now_us_);
      page_.frame(gui_, [this](const Ui& ui) {
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        const float head = ui.layout.size(56);
        edit_->draw(ui, words_, {0, head, size.x, size.y - head});
      });
    }
  }
  // Until what stands in the text now has been checked.
  void check() {
    now_us_ += 1'000'000;
    frames(1);
    edit_->checker().wait();
    frames(2);
  }
  void push(const UiEvent& event) {
    queue_.push(event);
    frames(2);
  }
  const Widget& widget(const std::string& kind, const std::string& target) {
    const Widget* found = page_.widgets().find(kind, target);
    if (found == nullptr) throw std::logic_error("there is no " + kind + " " + target);
    return *found;
  }
  bool has(const std::string& kind, const std::string& target) {
    return page_.widgets().find(kind, target) != nullptr;
  }
  // Scrolls to it, as a hand would.
  void reach(const std::string& kind, const std::string& target) {
    for (int k = 0; k < 100 && !widget(kind, target).visible(); ++k) {
      const Box view = widget(kind, target).view;
      push({.kind = UiEvent::Kind::move, .x = view.middle_x(), .y = view.middle_y()});
      push({.kind = UiEvent::Kind::wheel,
            .y = widget(kind, target).box.y > view.middle_y() ? -1.0 : 1.0});
    }
  }
  void click(const std::string& kind, const std::string& target) {
    reach(kind, target);
    const Box box = widget(kind, target).box;
    push({.kind = UiEvent::Kind::move, .x = box.middle_x(), .y = box.middle_y()});
    push({.kind = UiEvent::Kind::button, .down = true});
    push({.kind = UiEvent::Kind::button, .down = false});
  }
  void press(const std::string& target) { click("press", target); }
  void key(int code) {
    push({.kind = UiEvent::Kind::key, .code = code, .down = true});
    push({.kind = UiEvent::Kind::key, .code = code, .down = false});
  }
  void control(int code) {
    push({.kind = UiEvent::Kind::key, .code = GLFW_KEY_LEFT_CONTROL, .down = true});
    key(code);
    push({.kind = UiEvent::Kind::key, .code = GLFW_KEY_LEFT_CONTROL, .down = false});
  }
  void type(const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
      const study::Character one = study::first_character(std::string_view(text).substr(at));
      push({.kind = UiEvent::Kind::character, .code = static_cast<int>(one.code)});
      at += one.bytes;
    }
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
  void tab_to(const std::string& kind, const std::string& target) {
    for (int k = 0; k < 200 && !page_.focus().on(kind, target); ++k) key(GLFW_KEY_TAB);
    ASSERT_TRUE(page_.focus().on(kind, target)) << kind << " " << target;
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
  InputQueue queue_;
  Gui gui_;
  ToolPage page_;
  study::Texts words_;
  std::unique_ptr<EditPage> edit_;
  std::int64_t now_us_ = 0;
};

}  // namespace promenade::app::bench
