#include "app/screens/items.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace promenade::app {

using study::ItemKind;

Box Pen::take(float height) {
  const Box box{x, y, width, height};
  y += height;
  return box;
}

void Pen::write(ImFont* font, const Rgb& colour, std::string_view text) {
  y += draws ? draw_paragraphs(font, x, y, width, colour, text)
             : paragraphs_height(font, width, text);
}

std::string_view Pen::in_language(const study::LocalText& text) const {
  return study::text_in(text, screen.language);
}

void Pen::answer(study::SetAnswer set) const { screen.actions.emplace_back(std::move(set)); }

Sheet sheet_of(const Screen& screen) {
  return {*screen.session.questions(), screen.session.answers(), screen.session.item_order()};
}

std::string name_of(const Screen& screen, const study::Item& item) {
  const std::string_view question = study::text_in(item.question, screen.language);
  if (item.pair) {
    return study::text_in(item.choices[0].text, screen.language) + " / " +
           study::text_in(item.choices[1].text, screen.language);
  }
  if (!question.empty()) return std::string(question);
  return study::text_in(item.low, screen.language) + " – " +
         study::text_in(item.high, screen.language);
}

namespace {

const study::Item& item_at(const Sheet& sheet, int index) {
  return sheet.instrument.items[static_cast<std::size_t>(index)];
}
const study::ItemAnswer& answer_at(const Sheet& sheet, int index) {
  return sheet.answers[static_cast<std::size_t>(index)];
}
bool is_open(const Sheet& sheet, int index) {
  return item_at(sheet, index).needed && !answer_at(sheet, index).given();
}

}  // namespace

const study::Item* first_open(const Sheet& sheet, int& count) {
  const study::Item* first = nullptr;
  count = 0;
  for (const int index : sheet.order) {
    if (!is_open(sheet, index)) continue;
    ++count;
    if (first == nullptr) first = &item_at(sheet, index);
  }
  return first;
}

namespace {

void put_answers(Pen& pen, const study::Item& item, const study::ItemAnswer& answer) {
  switch (item.kind) {
    case ItemKind::scale:
      return put_scale(pen, item, answer);
    case ItemKind::choice:
      return put_choice(pen, item, answer);
    case ItemKind::number:
      return put_number(pen, item, answer);
    case ItemKind::text:
      return put_text(pen, item, answer);
    case ItemKind::ranking:
      return put_ranking(pen, item, answer);
    case ItemKind::agree:
      return put_agree(pen, item, answer);
  }
}

void put_decline(Pen& pen, const study::Item& item, const study::ItemAnswer& answer) {
  const std::string& label = pen.screen.texts("items.decline");
  pen.skip(4);
  const Box row = pen.take(pen.size(36));
  if (!pen.draws) return;
  const float width = std::round(text_width(pen.ui.look.fonts.bold, label) + pen.size(24));
  // The letters stand under those of the question.
  const float left = answer.declined ? row.x : row.x - pen.size(12);
  const Box box{left, row.y, width, row.height};
  const std::string target = decline_target(item.name);
  const bool pressed = answer.declined ? answer_button(pen.ui, target, box, label, true)
                                       : small_button(pen.ui, "press", target, box, label);
  if (!pressed) return;
  pen.answer({.item = item.name, .declined = !answer.declined});
}

// The same question over and over is asked once.
bool asked_before(const Sheet& sheet, std::size_t place) {
  const study::Item& item = item_at(sheet, sheet.order[place]);
  return place > 0 && item.pair && item_at(sheet, sheet.order[place - 1]).pair;
}

void put_question(Pen& pen, const study::Item& item) {
  if (item.kind == ItemKind::agree || item.question.empty()) return;
  pen.write(pen.style.font, pen.ui.look.palette.text, pen.in_language(item.question));
  pen.skip(pen.style.above);
}

float gap_before(const Pen& pen, const Sheet& sheet, std::size_t place) {
  const study::Item& item = item_at(sheet, sheet.order[place]);
  const bool row = asked_before(sheet, place) || item.kind == ItemKind::agree ||
                   (item.kind == ItemKind::scale && item.question.empty());
  return row && place > 0 ? 0.5f * pen.style.between : pen.style.between;
}

void mark(const Pen& pen, float top, const Rgb& colour) {
  fill({pen.x - pen.size(12), top, pen.size(4), pen.y - top}, colour);
}

// In the panel of a rate trial the row that comes next is marked, and all that are missing once
// somebody wanted to go on too early.
void mark_open(const Pen& pen, const Sheet& sheet, std::size_t place, bool next, float top) {
  if (!pen.draws || pen.ui.inert || !is_open(sheet, sheet.order[place])) return;
  const Palette& palette = pen.ui.look.palette;
  if (pen.screen.memory.too_early) return mark(pen, top, palette.pilot);
  if (next && pen.screen.session.trial() != nullptr) mark(pen, top, palette.created);
}

void put_item(Pen& pen, const Sheet& sheet, std::size_t place, bool next) {
  const int index = sheet.order[place];
  const study::Item& item = item_at(sheet, index);
  pen.skip(gap_before(pen, sheet, place));
  const float top = pen.y;
  if (!asked_before(sheet, place)) put_question(pen, item);
  put_answers(pen, item, answer_at(sheet, index));
  if (item.can_decline) put_decline(pen, item, answer_at(sheet, index));
  mark_open(pen, sheet, place, next, top);
}

void bring_into_sight(const Pen& pen, float top) {
  if (ImGui::GetScrollMaxY() <= 0) return;
  ImGui::SetScrollFromPosY(top - ImGui::GetWindowPos().y, 0);
  pen.screen.memory.refused = false;
}

bool was_answered(const Sheet& sheet, const std::string& item) {
  for (const int index : sheet.order) {
    if (item_at(sheet, index).name == item) return !is_open(sheet, index);
  }
  return false;
}

// The row that was next has been answered, and the one that is next now is not all in sight. Who
// answers in another order is left alone.
bool leads_on(const Pen& pen, const Sheet& sheet, const study::Item* next) {
  const std::string& before = pen.screen.memory.next_open;
  if (!pen.draws || pen.ui.inert || next == nullptr || pen.screen.session.trial() == nullptr) {
    return false;
  }
  return !before.empty() && before != next->name && was_answered(sheet, before);
}

void follow(const Pen& pen, float top) {
  const float row = pen.size(pen.style.cell + pen.style.between);
  const float view = ImGui::GetWindowPos().y;
  const bool seen = top >= view && top + row <= view + ImGui::GetWindowHeight();
  if (!seen && ImGui::GetScrollMaxY() > 0) ImGui::SetScrollFromPosY(top - view, 0.25f);
}

void put_sheet(Pen& pen, const Sheet& sheet) {
  const std::string_view text = pen.in_language(sheet.instrument.text);
  ImFont* const font = pen.style.beside ? pen.ui.look.fonts.text : pen.ui.look.fonts.reading;
  pen.write(font, pen.ui.look.palette.text, text);
  int open = 0;
  const study::Item* first = first_open(sheet, open);
  for (std::size_t place = 0; place < sheet.order.size(); ++place) {
    const bool wanted =
        pen.draws && pen.screen.memory.refused && first == &item_at(sheet, sheet.order[place]);
    const bool next = first == &item_at(sheet, sheet.order[place]);
    if (wanted) bring_into_sight(pen, pen.y);
    if (next && leads_on(pen, sheet, first)) follow(pen, pen.y);
    put_item(pen, sheet, place, next);
  }
  if (!pen.draws || pen.ui.inert) return;
  std::string& known = pen.screen.memory.next_open;  // keeps its memory
  if (first == nullptr) {
    known.clear();
  } else if (known != first->name) {
    known = first->name;
  }
}

float height_with(const Pen& pen, const Sheet& sheet) {
  Pen measure = pen;
  measure.y = 0;
  put_sheet(measure, sheet);
  return measure.y;
}

float widest_pole(const Pen& pen, const study::Instrument& instrument) {
  ImFont* const font = pen.ui.look.fonts.text;
  float widest = 0;
  for (const study::Item& item : instrument.items) {
    if (item.kind != ItemKind::scale || points_of(item) > most_numbers) continue;
    widest = std::max({widest, text_width(font, pen.in_language(item.low)),
                       text_width(font, pen.in_language(item.high))});
  }
  return widest;
}

ItemStyle roomy(const Fonts& fonts) { return {.font = fonts.reading}; }
ItemStyle tight(const Fonts& fonts) {
  return {.font = fonts.reading, .between = 16, .above = 8, .cell = 44, .row = 40};
}
ItemStyle compact(const Fonts& fonts) {
  return {.font = fonts.text, .between = 16, .above = 6, .cell = 36, .row = 36, .beside = true};
}

// Closer together when there are many; what still does not fit scrolls.
Pen fitting_pen(const Screen& screen, const Ui& ui, const Sheet& sheet, const Box& box,
                bool narrow) {
  const Fonts& fonts = ui.look.fonts;
  Pen pen{screen, ui, compact(fonts), box.x, box.y, box.width};
  pen.pole = widest_pole(pen, sheet.instrument);
  if (narrow) return pen;
  for (const ItemStyle& style : {roomy(fonts), tight(fonts)}) {
    Pen larger = pen;
    larger.style = style;
    if (height_with(larger, sheet) <= box.height) return larger;
  }
  return pen;
}

// The marks stand left of the items.
constexpr float margin = 14;

void draw_with(Pen& pen, const Sheet& sheet, const Box& box) {
  const float height = height_with(pen, sheet) + pen.size(8);
  const float left = pen.size(margin);
  const Box body{box.x - left, box.y, box.width + left, box.height};
  pen.y = begin_body(pen.screen, body, height);
  pen.draws = true;
  put_sheet(pen, sheet);
  pen.skip(8);
  end_body(pen.screen, body, pen.y);
}

}  // namespace

void draw_sheet(const Screen& screen, const Sheet& sheet, const Box& box, bool narrow) {
  Pen pen = fitting_pen(screen, screen.ui, sheet, box, narrow);
  draw_with(pen, sheet, box);
  screen.memory.refused = false;
}

void draw_sheet_picture(const Screen& screen, const study::Instrument& instrument, const Box& box) {
  Ui ui = screen.ui;
  ui.inert = true;
  const std::vector<study::ItemAnswer> answers(instrument.items.size());
  std::vector<int> order(instrument.items.size());
  std::iota(order.begin(), order.end(), 0);
  const Sheet sheet{instrument, answers, order};
  Pen pen = fitting_pen(screen, ui, sheet, box, true);
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::BeginChild("sheet", {box.width, box.height}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoInputs);
  pen.draws = true;
  put_sheet(pen, sheet);
  ImGui::EndChild();
}

namespace {

// How many digits mean something: 0 for an item that takes none.
int digits_of(const study::Item& item) {
  const auto choices = static_cast<int>(item.choices.size());
  const bool scale = item.kind == ItemKind::scale && points_of(item) <= most_numbers;
  if (scale) return points_of(item);
  const bool pressed = item.kind == ItemKind::choice || item.kind == ItemKind::ranking;
  return pressed && choices <= 9 ? choices : 0;
}

// A number that is shown is typed as it is, 0 for 10 where there is no 0; what has no
// number is counted from 1.
std::optional<double> scale_value(const study::Item& item, int digit) {
  double value = digit;
  if (has_poles(item)) value = value_at(item, digit - 1);
  if (digit == 0 && item.least > 0) value = 10;
  if (has_poles(item) && digit == 0) return std::nullopt;
  const double steps = (value - item.least) / item.step;
  const bool fits = value >= item.least && value <= item.most && steps == std::round(steps);
  return fits ? std::optional(value) : std::nullopt;
}

bool type_digit(const Screen& screen, const study::Item& item, const study::ItemAnswer& answer,
                int digit) {
  if (item.kind == ItemKind::scale) {
    const std::optional<double> value = scale_value(item, digit);
    if (value) screen.actions.emplace_back(study::SetAnswer{item.name, *value});
    return value.has_value();
  }
  if (digit == 0 || digit > static_cast<int>(item.choices.size())) return false;
  const std::string& name = item.choices[static_cast<std::size_t>(digit) - 1].name;
  if (item.kind == ItemKind::ranking) {
    rank(screen, item, answer, name);
    return false;  // more may follow
  }
  screen.actions.emplace_back(study::SetAnswer{item.name, static_cast<double>(digit), name});
  return true;
}

// Does the ring stand on an answer to this item? What the mouse pressed has no ring.
bool has_keyboard(const Screen& screen, const study::Item& item) {
  const Focus& focus = screen.ui.focus;
  if (!focus.ring()) return false;
  for (const char* kind : {"answer:", "rank:"}) {
    if (focus.on_first("press", kind + item.name + ":")) return true;
  }
  return false;
}

}  // namespace

void take_digits(const Screen& screen, const Sheet& sheet) {
  if (ImGui::GetIO().WantTextInput) return;
  std::size_t open = 0;
  const auto takes = [&](std::size_t place) {
    return digits_of(item_at(sheet, sheet.order[place])) > 0;
  };
  const auto focused = std::find_if(sheet.order.begin(), sheet.order.end(), [&](int index) {
    return has_keyboard(screen, item_at(sheet, index));
  });
  for (const ImWchar letter : ImGui::GetIO().InputQueueCharacters) {
    while (open < sheet.order.size() &&
           (answer_at(sheet, sheet.order[open]).given() || !takes(open))) {
      ++open;
    }
    const bool at_focus = focused != sheet.order.end();
    if (letter < '0' || letter > '9' || (!at_focus && open == sheet.order.size())) continue;
    const int index = at_focus ? *focused : sheet.order[open];
    const study::Item& item = item_at(sheet, index);
    if (digits_of(item) == 0) continue;
    if (type_digit(screen, item, answer_at(sheet, index), letter - '0')) ++open;
  }
}

}  // namespace promenade::app
