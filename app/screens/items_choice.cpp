// Answers that are pressed: one of several choices, an order of them, a box to tick.
#include <algorithm>
#include <cmath>

#include "app/line_breaks.h"
#include "app/screens/items.h"
#include "study/lines.h"

namespace promenade::app {
namespace {

float inset_of(const Pen& pen) { return pen.size(14); }

// How many choices stand side by side: as many as have room for the longest.
int columns_for(const Pen& pen, const study::Item& item, float gap) {
  const auto count = static_cast<int>(item.choices.size());
  float longest = 0;
  for (const study::Choice& choice : item.choices) {
    longest = std::max(longest, text_width(pen.ui.look.fonts.bold, pen.in_language(choice.text)));
  }
  if (item.pair) return 2;
  for (int columns = std::min(count, 4); columns > 1; --columns) {
    // No single one in the last row.
    if (columns < count && count % columns == 1 && columns > 2) continue;
    const auto n = static_cast<float>(columns);
    if ((pen.width - gap * (n - 1)) / n >= longest + 2 * inset_of(pen)) return columns;
  }
  return 1;
}

float lines_height(const Pen& pen, std::string_view text, float width) {
  return paragraphs_height(pen.ui.look.fonts.bold, width - 2 * inset_of(pen), text);
}

// In the middle of the box, or from its left edge.
void draw_label(const Pen& pen, const Box& box, std::string_view text, bool chosen, bool centred) {
  const Palette& palette = pen.ui.look.palette;
  ImFont* const font = chosen ? pen.ui.look.fonts.bold : pen.ui.look.fonts.text;
  const float width = box.width - 2 * inset_of(pen);
  const auto lines =
      break_lines(text, width, [font](std::string_view part) { return text_width(font, part); });
  const float step = paragraphs_height(font, width, "x");
  float y = box.middle_y() - 0.5f * step * static_cast<float>(lines.size());
  for (const std::string_view line : lines) {
    draw_line(font, {box.x + inset_of(pen), y, width, step},
              chosen ? palette.on_colour : palette.text, line,
              centred ? Align::centre : Align::left);
    y += step;
  }
}

bool is_chosen(const study::ItemAnswer& answer, std::size_t index) {
  return answer.value && std::lround(*answer.value) == static_cast<long>(index) + 1;
}

void draw_choice(const Pen& pen, const study::Item& item, const study::ItemAnswer& answer,
                 std::size_t index, const Box& box, bool centred) {
  const study::Choice& choice = item.choices[index];
  const bool chosen = is_chosen(answer, index);
  const double place = static_cast<double>(index) + 1;
  if (answer_button(pen.ui, answer_target(item.name, place), box, "", chosen)) {
    const bool back = chosen && !item.needed;
    pen.answer(back ? study::SetAnswer{item.name}
                    : study::SetAnswer{item.name, place, choice.name});
    if (choice.free && !chosen) pen.screen.memory.writes_next = own_target(item.name);
  }
  draw_label(pen, box, pen.in_language(choice.text), chosen, centred);
}

void put_row(Pen& pen, const study::Item& item, const study::ItemAnswer& answer, std::size_t first,
             int columns, float gap) {
  const auto n = static_cast<float>(columns);
  const float width = std::floor((pen.width - gap * (n - 1)) / n);
  const std::size_t end = std::min(item.choices.size(), first + static_cast<std::size_t>(columns));
  float height = pen.size(pen.style.row);
  for (std::size_t i = first; i < end; ++i) {
    height = std::max(
        height, lines_height(pen, pen.in_language(item.choices[i].text), width) + pen.size(14));
  }
  const Box row = pen.take(height);
  for (std::size_t i = first; i < end && pen.draws; ++i) {
    const float x = row.x + static_cast<float>(i - first) * (width + gap);
    draw_choice(pen, item, answer, i, {x, row.y, width, height}, columns > 1);
  }
}

}  // namespace

void put_choice(Pen& pen, const study::Item& item, const study::ItemAnswer& answer) {
  const float gap = pen.size(8);
  const int columns = columns_for(pen, item, gap);
  for (std::size_t i = 0; i < item.choices.size(); i += static_cast<std::size_t>(columns)) {
    if (i > 0) pen.y += gap;
    put_row(pen, item, answer, i, columns, gap);
  }
  for (std::size_t i = 0; i < item.choices.size(); ++i) {
    if (item.choices[i].free && is_chosen(answer, i)) put_own_words(pen, item, answer);
  }
}

namespace {

// The order so far; one that is not complete is no answer yet.
std::vector<std::string>& order_of(const Screen& screen, const study::Item& item,
                                   const study::ItemAnswer& answer) {
  std::vector<std::string>& order = screen.memory.orders[item.name];
  if (!answer.text.empty()) order = study::lines_of(answer.text);
  if (answer.declined) order.clear();
  return order;
}

void draw_badge(const Pen& pen, const Box& row, std::ptrdiff_t rank) {
  const float side = pen.size(28);
  const Box badge{row.x + pen.size(8), std::round(row.middle_y() - 0.5f * side), side, side};
  const Palette& palette = pen.ui.look.palette;
  frame(badge, rank > 0 ? palette.on_colour : palette.line, pen.size(1));
  if (rank == 0) return;
  draw_text(pen.ui.look.fonts.bold, badge, palette.on_colour, std::to_string(rank), Align::centre);
}

}  // namespace

void rank(const Screen& screen, const study::Item& item, const study::ItemAnswer& answer,
          const std::string& option) {
  std::vector<std::string>& order = order_of(screen, item, answer);
  const auto found = std::find(order.begin(), order.end(), option);
  if (found == order.end()) {
    order.push_back(option);
  } else {
    order.erase(found);
  }
  const bool complete = order.size() == item.choices.size();
  if (!complete && !answer.given()) return;
  study::SetAnswer set{item.name};
  for (std::size_t i = 0; complete && i < order.size(); ++i) {
    set.text += (i == 0 ? "" : "\n") + order[i];
  }
  screen.actions.emplace_back(std::move(set));
}

void put_ranking(Pen& pen, const study::Item& item, const study::ItemAnswer& answer) {
  const std::vector<std::string> order = order_of(pen.screen, item, answer);
  const float room = pen.width - pen.size(56);
  for (std::size_t i = 0; i < item.choices.size(); ++i) {
    const study::Choice& choice = item.choices[i];
    const std::string_view text = pen.in_language(choice.text);
    if (i > 0) pen.skip(6);
    const Box row =
        pen.take(std::max(pen.size(pen.style.row), lines_height(pen, text, room) + pen.size(14)));
    if (!pen.draws) continue;
    const auto found = std::find(order.begin(), order.end(), choice.name);
    const std::ptrdiff_t place = found == order.end() ? 0 : found - order.begin() + 1;
    if (answer_button(pen.ui, rank_target(item.name, choice.name), row, "", place > 0)) {
      rank(pen.screen, item, answer, choice.name);
    }
    draw_badge(pen, row, place);
    draw_label(pen, {row.x + pen.size(36), row.y, row.width - pen.size(36), row.height}, text,
               place > 0, false);
  }
}

void put_agree(Pen& pen, const study::Item& item, const study::ItemAnswer& answer) {
  const std::string_view text = pen.in_language(item.question);
  const float indent = pen.size(44);
  const float height = paragraphs_height(pen.style.font, pen.width - indent, text);
  const Box row = pen.take(std::max(height, pen.size(28)));
  if (!pen.draws) return;
  const bool agreed = answer.value.has_value();
  const Palette& palette = pen.ui.look.palette;
  const Box box{row.x, row.y, pen.size(28), pen.size(28)};
  if (answer_area(pen.ui, agree_target(item.name), row, agreed)) {
    pen.answer(agreed ? study::SetAnswer{item.name} : study::SetAnswer{item.name, 1.0});
  }
  fill(box, agreed ? palette.created : palette.on_colour);
  if (agreed) draw_icon(box, Icon::check, palette.on_colour, pen.size(3));
  if (!agreed) frame(box, palette.quiet, pen.size(1));
  const float line = paragraphs_height(pen.style.font, row.width, "x");
  const float down = std::max(0.0f, 0.5f * (box.height - line));
  draw_paragraphs(pen.style.font, row.x + indent, row.y + std::round(down), pen.width - indent,
                  palette.text, text);
}

}  // namespace promenade::app
