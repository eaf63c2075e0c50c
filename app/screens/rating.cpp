#include "app/screens/screen.h"

namespace promenade::app {
namespace {

std::string answer_target(const study::Rating& rating, int point) {
  return "answer:" + rating.item + ":" + std::to_string(point);
}

// One question: a row of numbers between two words. Returns its height.
float draw_question(const Screen& screen, const study::Rating& rating,
                    const std::optional<double>& answer, float y) {
  const Ui& ui = screen.ui;
  const Palette& palette = ui.look.palette;
  const Box column = ui.layout.column();
  const float asked =
      draw_paragraphs(ui.look.fonts.reading, column.x, y, column.width, palette.text,
                      study::text_in(rating.question, screen.language));
  const float top = y + asked + ui.layout.size(14);
  const float side = ui.layout.size(52);
  const float gap =
      std::min(ui.layout.size(16), (column.width - side * static_cast<float>(rating.points)) /
                                       static_cast<float>(std::max(1, rating.points - 1)));
  for (int point = 1; point <= rating.points; ++point) {
    const Box box{column.x + static_cast<float>(point - 1) * (side + gap), top, side, side};
    const bool chosen = answer && *answer == point;
    const std::string number = std::to_string(point);
    if (button(ui, answer_target(rating, point), box, number,
               chosen ? ButtonKind::filled : ButtonKind::outlined)) {
      screen.actions.emplace_back(study::SetAnswer{rating.item, static_cast<double>(point)});
    }
  }
  const float width = static_cast<float>(rating.points) * (side + gap) - gap;
  const Box words{column.x, top + side + ui.layout.size(4), width, ui.layout.size(28)};
  draw_text(ui.look.fonts.text, words, palette.quiet, study::text_in(rating.low, screen.language));
  draw_text(ui.look.fonts.text, words, palette.quiet, study::text_in(rating.high, screen.language),
            Align::right);
  return words.bottom() - y;
}

// The question whose button has the keyboard; null: none.
const study::Rating* focused_question(const Screen& screen) {
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

}  // namespace

void draw_rating(const Screen& screen) {
  bool pressed = false;
  const bool complete = screen.session.can_continue();
  take_digits(screen);
  float y = draw_text_page(
      screen,
      {screen.texts("rating.title"), screen.texts("rating.hint"), screen.texts("button.continue")},
      complete, pressed);
  const std::vector<std::optional<double>>& answers = screen.session.answers();
  for (std::size_t i = 0; i < answers.size(); ++i) {
    y += screen.ui.layout.size(28);
    y += draw_question(screen, screen.bundle.study.ratings[i], answers[i], y);
  }
  if (pressed) screen.actions.emplace_back(study::Continue{});
}

}  // namespace promenade::app
