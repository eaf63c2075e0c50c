// Where an interface draws: a rectangle of the screen, what it needs to draw, and
// where it says what was done to it. study/ knows the name only.
#pragma once

#include <string>
#include <vector>

#include "app/captions.h"
#include "app/small_figures.h"
#include "app/widgets.h"
#include "study/interface.h"

namespace promenade::study {

class InterfacePanel {
 public:
  struct Content {
    const motion::MotionSpace& space;
    const app::Captions& captions;
    app::SmallFigures* figures = nullptr;  // null: there is no stage to walk on
  };

  // `now_us`: as InterfaceState::weights takes it.
  InterfacePanel(const app::Ui& ui, const app::Box& box, const Content& content,
                 std::int64_t now_us, std::vector<ControlInput>& changes)
      : ui_(ui), box_(box), content_(content), now_us_(now_us), changes_(changes) {}

  const app::Ui& ui() const { return ui_; }
  const app::Look& look() const { return ui_.look; }
  const app::Box& box() const { return box_; }  // pixels
  float size(float at_720) const { return ui_.layout.size(at_720); }
  const Content& content() const { return content_; }
  std::int64_t now_us() const { return now_us_; }
  const std::string& text(std::string_view key) const { return content_.captions.texts(key); }

  // A row of a list under the name `target`; reports {kind, target} when pressed.
  void row(std::string_view kind, std::string_view target, const app::Box& box,
           std::string_view label, bool marked);
  // A slider from 0 to 1; reports {kind, target, value} while it moves.
  void slide(std::string_view target, const app::Box& box, double value, double start,
             std::string_view kind = "slide");
  // A small button; reports {kind, target} when pressed.
  void press(std::string_view kind, std::string_view target, const app::Box& box,
             std::string_view label);
  // The same with a sign.
  void press(std::string_view kind, std::string_view target, const app::Box& box, app::Icon icon,
             bool enabled = true);
  // A line of at most `most` characters to write in; reports {kind, target, text} when it
  // changes.
  void write(std::string_view kind, std::string_view target, const app::Box& box,
             const std::string& text, const std::string& hint, int most);
  // A frame around what is drawn there; reports {kind, target} when pressed.
  void tile(std::string_view kind, std::string_view target, const app::Box& box);
  // A figure that walks by these N weights, and does nothing else.
  void figure(const app::Box& box, const Eigen::VectorXd& weights, const app::Rgb& colour);
  // A line of text; what is too long for the box loses its middle.
  void line(ImFont* font, const app::Box& box, const app::Rgb& colour, std::string_view text,
            app::Align align = app::Align::left);
  void report(ControlInput change) { changes_.push_back(std::move(change)); }

  // A region that scrolls when its rows need more room. `rows_height` in pixels;
  // returns the width that is left for a row.
  float begin_scroll(const app::Box& box, float rows_height);
  void end_scroll();

 private:
  const app::Ui& ui_;
  app::Box box_;
  const Content& content_;
  std::int64_t now_us_;
  std::vector<ControlInput>& changes_;
};

}  // namespace promenade::study
