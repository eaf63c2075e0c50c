// Scales: buttons with numbers, cells between two opposite words, and from 12 points on a
// row of narrow cells.
#include <algorithm>
#include <cmath>

#include "app/screens/items.h"

namespace promenade::app {

int points_of(const study::Item& item) {
  return 1 + static_cast<int>(std::lround((item.most - item.least) / item.step));
}

double value_at(const study::Item& item, int point) { return item.least + item.step * point; }

int point_of(const study::Item& item, const study::ItemAnswer& answer) {
  if (!answer.value) return -1;
  return static_cast<int>(std::lround((*answer.value - item.least) / item.step));
}

bool has_poles(const study::Item& item) { return item.question.empty() || item.least < 0; }

namespace {

struct Row {
  Box box;  // of all cells
  float side = 0, gap = 0;

  Box cell(int point) const {
    const float x = std::round(box.x + static_cast<float>(point) * (side + gap));
    return {x, box.y, std::round(side), box.height};
  }
};

struct Words {
  std::string_view low, high;
  float low_width = 0, high_width = 0;
};

Words words_of(const Pen& pen, const study::Item& item) {
  ImFont* const font = pen.ui.look.fonts.text;
  Words words{pen.in_language(item.low), pen.in_language(item.high)};
  words.low_width = text_width(font, words.low);
  words.high_width = text_width(font, words.high);
  return words;
}

// The point that has the keyboard; -1: none.
int focused_point(const Pen& pen, const study::Item& item) {
  if (!pen.ui.focus.on_first("press", "answer:" + item.name + ":")) return -1;
  for (int point = 0; point < points_of(item); ++point) {
    const double value = value_at(item, point);
    if (pen.ui.focus.on("press", answer_target(item.name, value))) return point;
  }
  return -1;
}

// The arrow keys answer with the neighbour of the value that has the keyboard.
void move_by_keys(const Pen& pen, const study::Item& item) {
  Focus& focus = pen.ui.focus;
  const int point = pen.ui.inert ? -1 : focused_point(pen, item);
  if (point < 0) return;
  int to = point;
  if (key_pressed(ImGuiKey_LeftArrow)) --to;
  if (key_pressed(ImGuiKey_RightArrow)) ++to;
  if (key_pressed(ImGuiKey_Home)) to = 0;
  if (key_pressed(ImGuiKey_End)) to = points_of(item) - 1;
  to = std::clamp(to, 0, points_of(item) - 1);
  if (to == point) return;
  pen.answer({item.name, value_at(item, to)});
  focus.go_on("press", answer_target(item.name, value_at(item, to)));
}

// Returns the point under the mouse; -1: none. `tab`: the only one where the Tab key stops;
// -1: at all.
int draw_cells(const Pen& pen, const study::Item& item, const study::ItemAnswer& answer,
               const Row& row, bool numbers, int tab) {
  const int chosen = point_of(item, answer);
  const float share = static_cast<float>(chosen) / static_cast<float>(points_of(item) - 1);
  const Rgb colour = step_colour(pen.ui.look.palette, share);
  const Rgb* ground = has_poles(item) ? &colour : nullptr;
  int hovered = -1;
  for (int point = 0; point < points_of(item); ++point) {
    const double value = value_at(item, point);
    if (answer_button(pen.ui, answer_target(item.name, value), row.cell(point),
                      numbers ? value_text(value) : "", point == chosen, tab < 0 || tab == point,
                      ground)) {
      const bool back = point == chosen && !item.needed;
      pen.answer(back ? study::SetAnswer{item.name} : study::SetAnswer{item.name, value});
    }
    if (!pen.ui.inert && ImGui::IsItemHovered()) hovered = point;
  }
  move_by_keys(pen, item);
  return hovered;
}

// Under the cells, or over the room of them; two long ones are broken into lines.
void put_words_below(Pen& pen, const Words& words, float width) {
  ImFont* const font = pen.ui.look.fonts.text;
  const Rgb& colour = pen.ui.look.palette.quiet;
  pen.skip(4);
  if (words.low_width + words.high_width + pen.size(16) <= width) {
    const Box box = pen.take(pen.size(24));
    const Box under{box.x, box.y, width, box.height};
    if (!pen.draws) return;
    draw_text(font, under, colour, words.low);
    return draw_text(font, under, colour, words.high, Align::right);
  }
  const float half = 0.5f * (pen.width - pen.size(24));
  const float low = paragraphs_height(font, half, words.low);
  const float high = paragraphs_height(font, half, words.high);
  const Box box = pen.take(std::max(low, high));
  if (!pen.draws) return;
  draw_paragraphs(font, box.x, box.y, half, colour, words.low);
  const float narrow = std::min(half, words.high_width);
  draw_paragraphs(font, box.right() - narrow, box.y, half, colour, words.high);
}

void put_long(Pen& pen, const study::Item& item, const study::ItemAnswer& answer) {
  const auto count = static_cast<float>(points_of(item));
  const float pitch = std::min(pen.size(28), pen.width / count);
  const float gap = pitch >= pen.size(10) ? pen.size(2) : 0;
  Row row{pen.take(pen.size(32)), pitch - gap, gap};
  const float width = count * pitch - gap;
  const Words words = words_of(pen, item);
  const float below = pen.y;
  put_words_below(pen, words, width);
  if (!pen.draws) return;
  const int chosen = point_of(item, answer);
  const int hovered = draw_cells(pen, item, answer, row, false, std::max(0, chosen));
  const int point = hovered >= 0 ? hovered : chosen;
  if (point < 0) return;
  const Fonts& fonts = pen.ui.look.fonts;
  const Palette& palette = pen.ui.look.palette;
  draw_text(point == chosen ? fonts.bold : fonts.text,
            {row.box.x, below + pen.size(4), width, pen.size(24)},
            point == chosen ? palette.text : palette.quiet, value_text(value_at(item, point)),
            Align::centre);
}

// The words at both sides, so that the cells of all items stand in columns: in the middle
// between two opposite words, else below the beginning of the question.
void put_beside(Pen& pen, const study::Item& item, const study::ItemAnswer& answer, float side,
                float gap) {
  const auto count = static_cast<float>(points_of(item));
  const float width = count * (side + gap) - gap;
  const Box box = pen.take(side);
  if (!pen.draws) return;
  const bool poles = has_poles(item);
  const float space = pen.size(12);
  const float x = poles ? box.middle_x() - 0.5f * width : box.x + pen.pole + space;
  const Row row{{std::round(x), box.y, width, side}, side, gap};
  const Words words = words_of(pen, item);
  const Fonts& fonts = pen.ui.look.fonts;
  const Rgb& colour = poles ? pen.ui.look.palette.text : pen.ui.look.palette.quiet;
  // The word that was chosen stands out, for whoever does not see the colours.
  const int chosen = point_of(item, answer);
  const bool leans_low = poles && chosen >= 0 && 2 * chosen < points_of(item) - 1;
  const bool leans_high = poles && 2 * chosen > points_of(item) - 1;
  draw_text(leans_low ? fonts.bold : fonts.text,
            {row.box.x - space - pen.pole, box.y, pen.pole, side}, colour, words.low,
            poles ? Align::right : Align::left);
  draw_text(leans_high ? fonts.bold : fonts.text, {row.box.right() + space, box.y, pen.pole, side},
            colour, words.high);
  draw_cells(pen, item, answer, row, !poles, -1);
}

// As wide as the words below need, if there is room.
void put_above_words(Pen& pen, const study::Item& item, const study::ItemAnswer& answer,
                     float side) {
  const int count = points_of(item);
  const Words words = words_of(pen, item);
  const float wanted = words.low_width + words.high_width + pen.size(24);
  const float cells = side * static_cast<float>(count);
  const float most = (pen.width - cells) / static_cast<float>(count - 1);
  const float gap = std::clamp((wanted - cells) / static_cast<float>(count - 1),
                               std::min(pen.size(16), most), most);
  const Box box = pen.take(side);
  const float width = cells + gap * static_cast<float>(count - 1);
  put_words_below(pen, words, width);
  if (pen.draws) draw_cells(pen, item, answer, {box, side, gap}, !has_poles(item), -1);
}

}  // namespace

void put_scale(Pen& pen, const study::Item& item, const study::ItemAnswer& answer) {
  const int count = points_of(item);
  if (count > most_numbers) return put_long(pen, item, answer);
  const auto cells = static_cast<float>(count);
  const float gap = pen.size(pen.style.beside ? 4 : 8);
  const float wanted = pen.size(pen.style.cell);
  if (pen.style.beside || has_poles(item)) {
    const float room = pen.width - 2 * (pen.pole + pen.size(12));
    const float side = std::min(wanted, std::floor((room + gap) / cells - gap));
    if (side >= pen.size(26)) return put_beside(pen, item, answer, side, gap);
  }
  const float least = pen.size(4);
  put_above_words(pen, item, answer,
                  std::min(wanted, std::floor((pen.width + least) / cells - least)));
}

}  // namespace promenade::app
