// Which control is where in the picture: drawn widgets enter themselves, and the
// autopilot and the tests find them by name.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "app/box.h"

namespace promenade::app {

struct Widget {
  std::string kind;    // what it does: "pick", "slide", "press", ...
  std::string target;  // of what: "happy", "done", ...
  Box box;             // pixels
  Box view;            // the part of the window that shows it; outside it must be scrolled
  // Sliders: where the knob is, and where it is at the values 0 and 1.
  float knob = 0, at_zero = 0, at_one = 0;
  bool slides = false;
  // Planes: the pixel of (0, 0), and how many pixels 1 is to the right and up.
  float zero_x = 0, zero_y = 0, unit_x = 0, unit_y = 0;
  bool plane = false;
  bool stop = true;  // the Tab key stops here
  bool on = false;   // it is the answer that was chosen

  bool visible() const {
    return view.holds(box.middle_x(), box.y + 1) && view.holds(box.middle_x(), box.bottom() - 1);
  }
};

class WidgetMap {
 public:
  void clear() { used_ = 0; }
  // Keeps the memory of frames before.
  void add(std::string_view kind, std::string_view target, const Widget& widget) {
    if (used_ == widgets_.size()) widgets_.emplace_back();
    Widget& slot = widgets_[used_++];
    slot.kind.assign(kind);
    slot.target.assign(target);
    slot.box = widget.box;
    slot.view = widget.view;
    slot.knob = widget.knob;
    slot.at_zero = widget.at_zero;
    slot.at_one = widget.at_one;
    slot.slides = widget.slides;
    slot.zero_x = widget.zero_x;
    slot.zero_y = widget.zero_y;
    slot.unit_x = widget.unit_x;
    slot.unit_y = widget.unit_y;
    slot.plane = widget.plane;
    slot.stop = widget.stop;
    slot.on = widget.on;
  }
  const Widget* find(std::string_view kind, std::string_view target) const {
    for (std::size_t i = 0; i < used_; ++i) {
      if (widgets_[i].kind == kind && widgets_[i].target == target) return &widgets_[i];
    }
    return nullptr;
  }
  // The first whose target begins so.
  const Widget* find_first(std::string_view kind, std::string_view beginning) const {
    for (std::size_t i = 0; i < used_; ++i) {
      if (widgets_[i].kind == kind && widgets_[i].target.rfind(beginning, 0) == 0) {
        return &widgets_[i];
      }
    }
    return nullptr;
  }
  std::size_t size() const { return used_; }
  const Widget& operator[](std::size_t i) const { return widgets_[i]; }  // in the order drawn

 private:
  std::vector<Widget> widgets_;
  std::size_t used_ = 0;
};

}  // namespace promenade::app
