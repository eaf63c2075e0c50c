// The desk without a window, with a folder of studies of its own.
#pragma once

#include "app/desk/desk.h"
#include "motion/files.h"
#include "motion/problem.h"
#include "tests/app/hands.h"
#include "tests/test_folder.h"

namespace promenade::app::bench {

class DeskBench : public HandsTest {
 protected:
  explicit DeskBench(int width = 1280, int height = 720)
      : gui_(make_palette(false), {"日本語", "あ"}),
        desk_({.studies = folder_.path() / "studies",
               .language = "en",
               .program = stand_in(),
               .displays = {"1: DP-1, 1920 x 1080", "2: HDMI-1, 1280 x 720"},
               .show =
                   [this](const std::string& path) {
                     if (!opener_) throw OutsideError("nothing is installed that opens " + path);
                     shown_.push_back(path);
                   }},
              queue_) {
    fit_without_card(gui_, width, height);
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

  void draw_frame() override {
    desk_.advance(now_us_);
    desk_.frame(gui_);
  }
  const WidgetMap& widgets() const override { return desk_.widgets(); }
  const Focus& focus() const override { return desk_.focus(); }
  // Behind what stands in the field.
  void write(const std::string& target, const std::string& text) {
    click("type", target);
    type(text);
  }

  TestFolder folder_;
  std::string answer_;
  bool opener_ = true;  // something can show files
  Gui gui_;
  std::vector<std::string> shown_;
  Desk desk_;
};

}  // namespace promenade::app::bench
