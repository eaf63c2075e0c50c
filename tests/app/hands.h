// The hands of a test: mouse and keyboard on something that is drawn without a window, one event
// after the other, with frames between them.
#pragma once

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <stdexcept>
#include <string>

#include "app/focus.h"
#include "app/gui.h"
#include "app/window/input_queue.h"
#include "study/utf8.h"

namespace promenade::app::bench {

// Ready to draw at that size, with the fonts that a graphics card would have asked for.
inline void fit_without_card(Gui& gui, int width, int height) {
  gui.fit(width, height);
  unsigned char* pixels = nullptr;
  int wide = 0;
  int high = 0;
  ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &wide, &high);
}

class HandsTest : public testing::Test {
 protected:
  virtual void draw_frame() = 0;  // at now_us_
  virtual const WidgetMap& widgets() const = 0;
  virtual const Focus& focus() const = 0;

  void frames(int count) {
    for (int k = 0; k < count; ++k) {
      now_us_ += 16'667;
      draw_frame();
    }
  }
  void push(const UiEvent& event) {
    queue_.push(event);
    frames(2);
  }
  // Until `done` says so, while threads and processes work; false: it never did.
  template <typename Done>
  bool wait_until(const Done& done) {
    for (int k = 0; k < 4000; ++k) {
      frames(1);
      if (done()) return true;
      ::poll(nullptr, 0, 5);
    }
    return false;
  }

  const Widget& widget(const std::string& kind, const std::string& target) const {
    const Widget* found = widgets().find(kind, target);
    if (found == nullptr) throw std::logic_error("there is no " + kind + " " + target);
    return *found;
  }
  bool has(const std::string& kind, const std::string& target) const {
    return widgets().find(kind, target) != nullptr;
  }

  void move_to(float x, float y) { push({.kind = UiEvent::Kind::move, .x = x, .y = y}); }
  void button(bool down) { push({.kind = UiEvent::Kind::button, .down = down}); }
  // Turns the wheel over it until it is in sight.
  void reach(const std::string& kind, const std::string& target) {
    for (int k = 0; k < 100 && !widget(kind, target).visible(); ++k) {
      const Box view = widget(kind, target).view;
      move_to(view.middle_x(), view.middle_y());
      push({.kind = UiEvent::Kind::wheel,
            .y = widget(kind, target).box.y > view.middle_y() ? -1.0 : 1.0});
    }
  }
  void click(const std::string& kind, const std::string& target) {
    // What is still being worked out can move it meanwhile.
    for (int k = 0; k < 10; ++k) {
      reach(kind, target);
      const Box box = widget(kind, target).box;
      move_to(box.middle_x(), box.middle_y());
      if (widget(kind, target).box.y == box.y) break;
    }
    button(true);
    button(false);
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
  void control(int code) { chord(GLFW_KEY_LEFT_CONTROL, code); }
  void type(const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
      const study::Character one = study::first_character(std::string_view(text).substr(at));
      push({.kind = UiEvent::Kind::character, .code = static_cast<int>(one.code)});
      at += one.bytes;
    }
  }
  void tab_to(const std::string& kind, const std::string& target) {
    for (int k = 0; k < 200 && !focus().on(kind, target); ++k) key(GLFW_KEY_TAB);
    ASSERT_TRUE(focus().on(kind, target)) << kind << " " << target;
  }

  InputQueue queue_;
  std::int64_t now_us_ = 0;
};

}  // namespace promenade::app::bench
