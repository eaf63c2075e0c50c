#include "app/screens/screen.h"

namespace promenade::app {
namespace {

std::string answer_target(const study::Rating& rating, int point) {
  return "answer:" + rating.item + ":" + std::to_string(point);
}

// At 1280 x 720.
struct Spacing {
  float between, above_numbers, number, words;
};
constexpr Spacing roomy{28, 14, 52, 28};
constexpr Spacing tight{16, 8, 44, 24};

std::string_view question_of(const Screen& screen, const study::Rating& rating) {
  return study::text_in(rating.question, screen.language);
}

float question_height(const Screen& screen, const study::Rating& rating, const Spacing& spacing) {
  const Ui& ui = screen.ui;
  return ui.layout.size(spacing.between) +
         paragraphs_height(ui.look.fonts.reading, ui.layout.column().width,
                           question_of(screen, rating)) +
         ui.layout.size(spacing.above_numbers) + ui.layout.size(spacing.number) +
         ui.layout.size(4) + ui.layout.size(spacing.words);
}

float questions_height(const Screen& screen, const Spacing& spacing) {
  float height = 0;
  for (const study::Rating& rating : screen.bundle.study.ratings) {
    height += question_height(screen, rating, spacing);
  }
  return height;
}

// A row of numbers between two words. Returns its width.
float draw_numbers(const Screen& screen, const study::Rating& rating,
                   const std::optional<double>& answer, const Box& column, float side) {
  const Ui& ui = screen.ui;
  const float gap =
      std::min(ui.layout.size(16), (column.width - side * static_cast<float>(rating.points)) /
                                       static_cast<float>(std::max(1, rating.points - 1)));
  for (int point = 1; point <= rating.points; ++point) {
    const Box box{column.x + static_cast<float>(point - 1) * (side + gap), column.y, side, side};
    const bool chosen = answer && *answer == point;
    const std::string number = std::to_string(point);
    if (button(ui, answer_target(rating, point), box, number,
               chosen ? ButtonKind::filled : ButtonKind::outlined)) {
      screen.actions.emplace_back(study::SetAnswer{rating.item, static_cast<double>(point)});
    }
  }
  return static_cast<float>(rating.points) * (side + gap) - gap;
}

void draw_question(const Screen& screen, const study::Rating& rating,
                   const std::optional<double>& answer, const Spacing& spacing, float y) {
  const Ui& ui = screen.ui;
  const Palette& palette = ui.look.palette;
  Box row = ui.layout.column();
  row.y = y + ui.layout.size(spacing.between);
  row.y += draw_paragraphs(ui.look.fonts.reading, row.x, row.y, row.width, palette.text,
                           question_of(screen, rating));
  row.y += ui.layout.size(spacing.above_numbers);
  const float side = ui.layout.size(spacing.number);
  const float width = draw_numbers(screen, rating, answer, row, side);
  const Box words{row.x, row.y + side + ui.layout.size(4), width, ui.layout.size(spacing.words)};
  draw_text(ui.look.fonts.text, words, palette.quiet, study::text_in(rating.low, screen.language));
  draw_text(ui.look.fonts.text, words, palette.quiet, study::text_in(rating.high, screen.language),
            Align::right);
}

// The question that the ring is on; null: none. What the mouse pressed has no ring.
const study::Rating* focused_question(const Screen& screen) {
  if (!screen.ui.focus.ring()) return nullptr;
  for (const study::Rating& rating : screen.bundle.study.ratings) {
    for (int point = 1; point <= rating.points; ++point) {
      if (screen.ui.focus.on("press", answer_target(rating, point))) return &rating;
    }
  }
  return nullptr;
}

// A typed number answers the question that has the keyboard, else the first one without
// an answer. 0 stands for 10.
void take_digits(const Screen& screen) {
  const std::vector<study::Rating>& ratings = screen.bundle.study.ratings;
  const std::vector<std::optional<double>>& answers = screen.session.answers();
  const study::Rating* focused = focused_question(screen);
  std::size_t open = 0;
  for (const ImWchar letter : ImGui::GetIO().InputQueueCharacters) {
    while (open < answers.size() && answers[open]) ++open;
    const study::Rating* asked = focused != nullptr      ? focused
                                 : open < ratings.size() ? &ratings[open]
                                                         : nullptr;
    if (asked == nullptr || letter < '0' || letter > '9') continue;
    const int point = letter == '0' ? 10 : letter - '0';
    if (point > asked->points) continue;
    screen.actions.emplace_back(study::SetAnswer{asked->item, static_cast<double>(point)});
    ++open;
  }
}

// Closer together when there are many; what still does not fit scrolls.
void draw_questions(const Screen& screen, float top) {
  const Box column = screen.ui.layout.column();
  const Box box{column.x, top, column.width, column.bottom() - top};
  const Spacing& spacing = questions_height(screen, roomy) <= box.height ? roomy : tight;
  float y = begin_body(screen, box, questions_height(screen, spacing));
  const std::vector<std::optional<double>>& answers = screen.session.answers();
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const study::Rating& rating = screen.bundle.study.ratings[i];
    draw_question(screen, rating, answers[i], spacing, y);
    y += question_height(screen, rating, spacing);
  }
  end_body(screen, box, y);
}

}  // namespace

void draw_rating(const Screen& screen) {
  bool pressed = false;
  const bool complete = screen.session.can_continue();
  take_digits(screen);
  const float top = draw_text_page(screen,
                                   {.title = screen.texts("rating.title"),
                                    .text = screen.texts("rating.hint"),
                                    .button = screen.texts("button.continue"),
                                    .missing = screen.texts("rating.missing")},
                                   complete, pressed);
  draw_questions(screen, top);
  if (pressed) screen.actions.emplace_back(study::Continue{});
}

}  // namespace promenade::app
