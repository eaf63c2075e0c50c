// Things below each other in a box: each takes what it needs from the top of what is left.
#pragma once

#include "app/widgets.h"

namespace promenade::app {

class Column {
 public:
  Column(const Ui& ui, const Box& box) : ui_(ui), left_(box) {}

  // Heights and gaps are at 1280 x 720.
  Box take(float height, float gap = 8) {
    const Box box{left_.x, left_.y, left_.width, ui_.layout.size(height)};
    skip(height + gap);
    return box;
  }
  void skip(float height) {
    const float high = ui_.layout.size(height);
    left_.y += high;
    left_.height -= high;
  }
  // Paragraphs, as high as they are.
  void words(ImFont* font, const Rgb& colour, std::string_view text, float gap = 12) {
    const float high = draw_paragraphs(font, left_.x, left_.y, left_.width, colour, text);
    left_.y += high;
    left_.height -= high;
    skip(gap);
  }
  const Box& left() const { return left_; }

 private:
  const Ui& ui_;
  Box left_;
};

// The box without an edge of so many pixels at 1280 x 720.
inline Box inside(const Ui& ui, const Box& box, float edge) {
  const float in = ui.layout.size(edge);
  return {box.x + in, box.y + in, box.width - 2 * in, box.height - 2 * in};
}

// Of a row of `count` equal boxes, the one at `index`.
inline Box part_of_row(const Ui& ui, const Box& row, int index, int count, float gap = 8) {
  const float between = ui.layout.size(gap);
  const auto n = static_cast<float>(count);
  const float width = (row.width - between * (n - 1)) / n;
  return {row.x + static_cast<float>(index) * (width + between), row.y, width, row.height};
}

}  // namespace promenade::app
