// Our own few widgets: large, calm, square. Each is a function that draws itself,
// enters itself into the map, and says what was done to it.
#pragma once

#include <optional>
#include <string_view>

#include "app/focus.h"
#include "app/layout.h"
#include "app/look.h"
#include "app/widget_map.h"

namespace promenade::app {

struct Ui {
  const Look& look;
  const Layout& layout;
  WidgetMap& widgets;
  Focus& focus;
  bool inert = false;  // drawn to be looked at: nothing reacts (a picture in the instructions)
};

enum class Align { left, centre, right };

// One line, its middle at the height of the box's.
void draw_text(ImFont* font, const Box& box, const Rgb& colour, std::string_view text,
               Align align = Align::left);
float text_width(ImFont* font, std::string_view text);

// One line that fits: what is too long loses its middle, since many names of a set
// differ at their ends only. No allocation.
void draw_line(ImFont* font, const Box& box, const Rgb& colour, std::string_view text,
               Align align = Align::left);
inline constexpr std::string_view ellipsis = "…";
struct Gap {
  std::size_t head = 0, tail = 0;  // bytes that stay in front, and where the rest goes on
};
Gap fitting_gap(ImFont* font, std::string_view text, float width);

// Paragraphs broken into lines, Japanese too; returns the height in pixels.
float draw_paragraphs(ImFont* font, float x, float y, float width, const Rgb& colour,
                      std::string_view text);
float paragraphs_height(ImFont* font, float width, std::string_view text);

void fill(const Box& box, const Rgb& colour);
void frame(const Box& box, const Rgb& colour, float thickness);

enum class ButtonKind { quiet, outlined, filled };

// True: pressed and released on it.
bool button(const Ui& ui, std::string_view target, const Box& box, std::string_view label,
            ButtonKind kind, bool enabled = true);

// One of the answers to a question; true: pressed and released on it. The Tab key passes by
// what does not `stop` it. `ground`: of a chosen one; null: the colour of what was made.
bool answer_button(const Ui& ui, std::string_view target, const Box& box, std::string_view label,
                   bool chosen, bool stop = true, const Rgb* ground = nullptr);

// The same where the answer is drawn elsewhere.
bool answer_area(const Ui& ui, std::string_view target, const Box& box, bool chosen);

// A quiet button within a row; true: pressed.
bool small_button(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                  std::string_view label);

// A frame around something that is drawn elsewhere; true: pressed and released on it.
bool tile(const Ui& ui, std::string_view kind, std::string_view target, const Box& box);

// A row of a list; true: pressed. `marked` in the colour of the created figure.
bool list_row(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
              std::string_view label, bool marked);

enum class Icon { undo, redo, play, pause, plus, close, pen, back, minus, check };

// A square button with a sign instead of words; true: pressed and released on it.
bool icon_button(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                 Icon icon, bool enabled = true, bool stop = true);
void draw_icon(const Box& box, Icon icon, const Rgb& colour, float thickness);

struct FieldOptions {
  const char* hint = "";    // stands in the empty field
  int most = 60;            // characters that can be written, 60 or fewer
  bool* entered = nullptr;  // out: Enter was pressed in it
};

// One line of text to write; true: it was changed. `text` keeps its memory.
bool text_field(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                std::string& text, const FieldOptions& options);

// A plane to press and drag in. `zero` is the pixel of (0, 0), `unit` how many pixels 1
// is to the right and up.
struct PlaneTouch {
  bool hovered = false, pressed = false, held = false;
  bool pan = false;                                 // dragged with another button
  Eigen::Vector2f moved = Eigen::Vector2f::Zero();  // since the frame before, pixels
  float wheel = 0;                                  // notches
  bool focused = false;                             // the arrow keys are meant for it
};
PlaneTouch plane(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                 const Eigen::Vector2f& zero, const Eigen::Vector2f& unit);

// A slider from 0 to 1 with a tick at `start`; the new value while it is dragged.
// `kind` is what it reports under. Arrow keys move it by a hundredth, with Shift by a
// tenth; Home and End to the ends.
std::optional<double> slider(const Ui& ui, std::string_view kind, std::string_view target,
                             const Box& box, double value, double start);

// Something drawn elsewhere that reacts to a press; true: pressed, on the way down. The Tab key
// passes by what does not `stop` it.
bool pressed_area(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                  bool stop = true);

// Enters something else that can be touched into the map; is the keyboard on it? The Tab
// key passes by what does not `stop` it.
bool place(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
           bool stop = true);

// Where a bar from 0 to 1 that fills `box` is pressed or dragged; the arrow keys move it
// as a slider. Draws nothing.
std::optional<double> drag_bar(const Ui& ui, std::string_view kind, std::string_view target,
                               const Box& box, double value);

// The part of the window that is drawn to now.
Box visible_box();

}  // namespace promenade::app
