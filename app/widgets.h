// Our own few widgets: large, calm, square. Each is a function that draws itself,
// enters itself into the map, and says what was done to it.
#pragma once

#include <optional>
#include <string_view>

#include "app/layout.h"
#include "app/look.h"
#include "app/widget_map.h"

namespace promenade::app {

struct Ui {
  const Look& look;
  const Layout& layout;
  WidgetMap& widgets;
};

enum class Align { left, centre, right };

// One line, its middle at the height of the box's.
void draw_text(ImFont* font, const Box& box, const Rgb& colour, std::string_view text,
               Align align = Align::left);
float text_width(ImFont* font, std::string_view text);

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

// A quiet button within a row; true: pressed.
bool small_button(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                  std::string_view label);

// A row of a list; true: pressed. `marked` in the colour of the created figure.
bool list_row(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
              std::string_view label, bool marked);

// A slider from 0 to 1 with a tick at `start`; the new value while it is dragged.
std::optional<double> slider(const Ui& ui, std::string_view target, const Box& box, double value,
                             double start);

// The part of the window that is drawn to now.
Box visible_box();

}  // namespace promenade::app
