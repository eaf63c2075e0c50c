// The desk without a window: its own folder of studies, and hands that click, type and press keys.
#pragma once

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <poll.h>

#include "app/desk/desk.h"
#include "motion/files.h"
#include "study/utf8.h"
#include "tests/test_folder.h"

namespace promenade::app::bench {

class DeskBench : public testing::Test {
 protected:
  explicit DeskBench(int width = 1280, int height = 720)
      : gui_(make_palette(false), {"日本語", "あ"}),
        desk_({.studies = folder_.path() / "studies",
               .language = "en",
               .program = stand_in(),
               .displays = {"1: DP-1, 1920 x 1080", "2: HDMI-1, 1280 x 720"},
               .show = [this](const std::string& path) { shown_.push_back(path); }},
              queue_) {
    gui_.fit(width, height);
    unsigned char* pixels = nullptr;
    int wide = 0;
    int high = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &wide, &high);
    frames(2);
  }

  // What stands in for promenade where a command would run: it notes what it was asked for, one
  // line for each, and does nothing.
  std::string stand_in() {
    const std::filesystem::path script = folder_.path() / "stand_in";
    write_file(script, "#!/bin/sh\nprintf '%s\\n' \"$*\" >> '" + log() + "'\n" + answer_);
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    return script;
  }
  // What it does besides, from now on: lines of a shell.
  void let_it(const std::string& lines) {
    answer_ = lines;
    stand_in();
  }
  std::string log() { return folder_.file("asked"); }
  // What was asked so far, once the last of it has ended. Paths are those of the study's folder.
  std::string asked() {
    wait_until([this] { return desk_.jobs().shown() == nullptr || desk_.jobs().shown()->told; });
    std::string text = std::filesystem::exists(log()) ? read_file(log()) : "";
    const std::string studies = (folder_.path() / "studies").string() + "/";
    for (std::size_t at = 0; (at = text.find(studies, at)) != std::string::npos;) {
      text.erase(at, studies.size());
    }
    return text;
  }
  study::StudyPlace make_study(const std::string& name, const std::string& from = "demo.toml") {
    study::StudyShelf shelf(folder_.path() / "studies");
    return shelf.add_template(from, name);
  }
  // Opens it there, and waits until it is read.
  void open(const study::StudyPlace& study, DeskPlace place) {
    desk_.open(study);
    desk_.go(place);
    ASSERT_TRUE(wait_until([this] { return desk_.study() && desk_.study()->reading(); }));
    frames(2);
  }

  void frames(int count) {
    for (int k = 0; k < count; ++k) {
      now_us_ += 16'667;
      desk_.advance(now_us_);
      desk_.frame(gui_);
    }
  }
  void push(const UiEvent& event) {
    queue_.push(event);
    frames(2);
  }
  const Widget& widget(const std::string& kind, const std::string& target) {
    const Widget* found = desk_.widgets().find(kind, target);
    if (found == nullptr) throw std::logic_error("there is no " + kind + " " + target);
    return *found;
  }
  bool has(const std::string& kind, const std::string& target) {
    return desk_.widgets().find(kind, target) != nullptr;
  }
  void click(const std::string& kind, const std::string& target) {
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
  void chord(int modifier, int code) {
    push({.kind = UiEvent::Kind::key, .code = modifier, .down = true});
    key(code);
    push({.kind = UiEvent::Kind::key, .code = modifier, .down = false});
  }
  void type(const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
      const study::Character one = study::first_character(std::string_view(text).substr(at));
      push({.kind = UiEvent::Kind::character, .code = static_cast<int>(one.code)});
      at += one.bytes;
    }
  }
  void write(const std::string& target, const std::string& text) {
    click("type", target);
    type(text);
  }
  void tab_to(const std::string& kind, const std::string& target) {
    for (int k = 0; k < 200 && !desk_.focus().on(kind, target); ++k) key(GLFW_KEY_TAB);
    ASSERT_TRUE(desk_.focus().on(kind, target)) << kind << " " << target;
  }
  // Until `done` says so, while threads and processes work; false: it never did.
  template <typename Done>
  bool wait_until(const Done& done) {
    for (int k = 0; k < 2000; ++k) {
      frames(1);
      if (done()) return true;
      ::poll(nullptr, 0, 5);
    }
    return false;
  }

  TestFolder folder_;
  std::string answer_;
  InputQueue queue_;
  Gui gui_;
  std::vector<std::string> shown_;
  Desk desk_;
  std::int64_t now_us_ = 0;
};

}  // namespace promenade::app::bench
