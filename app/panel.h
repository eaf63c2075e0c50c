// Where an interface draws: a rectangle of the screen, what it needs to draw, and
// where it says what was done to it. study/ knows the name only.
#pragma once

#include <string>
#include <vector>

#include "app/widgets.h"
#include "study/interface.h"
#include "study/texts.h"

namespace promenade::study {

class InterfacePanel {
 public:
  struct Content {
    const motion::MotionSpace& space;
    const Texts& texts;
    const std::vector<std::string>& names;  // N, of the cycles as people read them
    const std::vector<int>& by_name;        // the cycles in the order of their names
  };

  InterfacePanel(const app::Ui& ui, const app::Box& box, const Content& content,
                 std::vector<ControlInput>& changes)
      : ui_(ui), box_(box), content_(content), changes_(changes) {}

  const app::Ui& ui() const { return ui_; }
  const app::Look& look() const { return ui_.look; }
  const app::Box& box() const { return box_; }  // pixels
  float size(float at_720) const { return ui_.layout.size(at_720); }
  const Content& content() const { return content_; }

  // A row of a list under the name `target`; reports {kind, target} when pressed.
  void row(std::string_view kind, std::string_view target, const app::Box& box,
           std::string_view label, bool marked);
  // A slider from 0 to 1; reports {"slide", target, value} while it moves.
  void slide(std::string_view target, const app::Box& box, double value, double start);
  // A small button; reports {kind, target} when pressed.
  void press(std::string_view kind, std::string_view target, const app::Box& box,
             std::string_view label);
  void report(ControlInput change) { changes_.push_back(std::move(change)); }

  // A region that scrolls when its rows need more room. `rows_height` in pixels;
  // returns the width that is left for a row.
  float begin_scroll(const app::Box& box, float rows_height);
  void end_scroll();

 private:
  const app::Ui& ui_;
  app::Box box_;
  const Content& content_;
  std::vector<ControlInput>& changes_;
};

}  // namespace promenade::study
