#include "app/screens/screen.h"

namespace promenade::app {
namespace {

const std::vector<study::Item>& items(const Screen& screen) {
  return screen.session.questions()->items;
}

int points_of(const study::Item& item) { return static_cast<int>(item.most); }

std::string answer_target(const study::Item& item, int point) {
  return "answer:" + item.name + ":" + std::to_string(point);
}

// At 1280 x 720.
struct Spacing {
  float between, above_numbers, number, words;
};
constexpr Spacing roomy{28, 14, 52, 28};
constexpr Spacing tight{16, 8, 44, 24};

std::string_view question_of(const Screen& screen, const study::Item& item) {
  return study::text_in(item.question, screen.language);
}

float question_height(const Screen& screen, const study::Item& item, const Spacing& spacing) {
  const Ui& ui = screen.ui;
  return ui.layout.size(spacing.between) +
         paragraphs_height(ui.look.fonts.reading, ui.layout.column().width,
                           question_of(screen, item)) +
         ui.layout.size(spacing.above_numbers) + ui.layout.size(spacing.number) +
         ui.layout.size(4) + ui.layout.size(spacing.words);
}

float questions_height(const Screen& screen, const Spacing& spacing) {
  float height = 0;
  for (const study::Item& item : items(screen)) {
    height += question_height(screen, item, spacing);
  }
  return height;
}

// A row of numbers between two words. Returns its width.
float draw_numbers(const Screen& screen, const study::Item& item,
                   const study::ItemAnswer& answer, const Box& column, float side) {
  const Ui& ui = screen.ui;
  const float gap =
      std::min(ui.layout.size(16), (column.width - side * static_cast<float>(points_of(item))) /
                                       static_cast<float>(std::max(1, points_of(item) - 1)));
  for (int point = 1; point <= points_of(item); ++point) {
    const Box box{column.x + static_cast<float>(point - 1) * (side + gap), column.y, side, side};
    const bool chosen = answer.value && *answer.value == point;
    const std::string number = std::to_string(point);
    if (button(ui, answer_target(item, point), box, number,
               chosen ? ButtonKind::filled : ButtonKind::outlined)) {
      screen.actions.emplace_back(study::SetAnswer{item.name, static_cast<double>(point)});
    }
  }
  return static_cast<float>(points_of(item)) * (side + gap) - gap;
}

void draw_question(const Screen& screen, const study::Item& item,
                   const study::ItemAnswer& answer, const Spacing& spacing, float y) {
  const Ui& ui = screen.ui;
  const Palette& palette = ui.look.palette;
  Box row = ui.layout.column();
  row.y = y + ui.layout.size(spacing.between);
  row.y += draw_paragraphs(ui.look.fonts.reading, row.x, row.y, row.width, palette.text,
                           question_of(screen, item));
  row.y += ui.layout.size(spacing.above_numbers);
  const float side = ui.layout.size(spacing.number);
  const float width = draw_numbers(screen, item, answer, row, side);
  const Box words{row.x, row.y + side + ui.layout.size(4), width, ui.layout.size(spacing.words)};
  draw_text(ui.look.fonts.text, words, palette.quiet, study::text_in(item.low, screen.language));
  draw_text(ui.look.fonts.text, words, palette.quiet, study::text_in(item.high, screen.language),
            Align::right);
}

// The question that the ring is on; null: none. What the mouse pressed has no ring.
const study::Item* focused_question(const Screen& screen) {
  if (!screen.ui.focus.ring()) return nullptr;
  for (const study::Item& item : items(screen)) {
    for (int point = 1; point <= points_of(item); ++point) {
      if (screen.ui.focus.on("press", answer_target(item, point))) return &item;
    }
  }
  return nullptr;
}

// A typed number answers the question that has the keyboard, else the first one without
// an answer. 0 stands for 10.
void take_digits(const Screen& screen) {
  const std::vector<study::Item>& asked = items(screen);
  const std::vector<study::ItemAnswer>& answers = screen.session.answers();
  const study::Item* focused = focused_question(screen);
  std::size_t open = 0;
  for (const ImWchar letter : ImGui::GetIO().InputQueueCharacters) {
    while (open < answers.size() && answers[open].given()) ++open;
    const study::Item* item = focused != nullptr    ? focused
                              : open < asked.size() ? &asked[open]
                                                    : nullptr;
    if (item == nullptr || letter < '0' || letter > '9') continue;
    const int point = letter == '0' ? 10 : letter - '0';
    if (point > points_of(*item)) continue;
    screen.actions.emplace_back(study::SetAnswer{item->name, static_cast<double>(point)});
    ++open;
  }
}

// Closer together when there are many; what still does not fit scrolls.
void draw_questions(const Screen& screen, float top) {
  const Box column = screen.ui.layout.column();
  const Box box{column.x, top, column.width, column.bottom() - top};
  const Spacing& spacing = questions_height(screen, roomy) <= box.height ? roomy : tight;
  float y = begin_body(screen, box, questions_height(screen, spacing));
  const std::vector<study::ItemAnswer>& answers = screen.session.answers();
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const study::Item& item = items(screen)[i];
    draw_question(screen, item, answers[i], spacing, y);
    y += question_height(screen, item, spacing);
  }
  end_body(screen, box, y);
}

}  // namespace

void draw_questionnaire(const Screen& screen) {
  bool pressed = false;
  const bool complete = screen.session.can_continue();
  take_digits(screen);
  const float top = draw_text_page(screen,
                                   {.title = screen.texts("item.title"),
                                    .text = screen.texts("item.hint"),
                                    .button = screen.texts("button.continue"),
                                    .missing = screen.texts("item.missing")},
                                   complete, pressed);
  draw_questions(screen, top);
  if (pressed) screen.actions.emplace_back(study::Continue{});
}

}  // namespace promenade::app
