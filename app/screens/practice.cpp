#include <algorithm>

#include "app/screens/screen.h"

namespace promenade::app {
namespace {

// Line `number` of a text, or its last.
std::string_view line_of(std::string_view text, std::size_t number) {
  for (; number > 0; --number) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

}  // namespace

// The text of an interface has a line for each step; the first stays until something was
// done, the last from the fourth thing on.
void draw_practice_hint(const Screen& screen, const study::TrialState& trial) {
  const study::PlannedTrial& planned = planned_trial(screen);
  if (!planned.practice || planned.interface < 0) return;
  const Ui& ui = screen.ui;
  const std::string key = "interface." + use_of(screen).type + ".practice";
  if (screen.texts.find(key) == nullptr) return;
  const std::size_t done = trial.history.undo.size();
  const std::size_t step = done == 0 ? 0 : done < 4 ? 1 : 2;
  const Box& stage = screen.stage_plan.figures;
  const float width = ui.layout.size(560);
  const float x = stage.middle_x() - 0.5f * width;
  const std::string_view hint = line_of(screen.texts(key), step);
  const bool one_line = text_width(ui.look.fonts.text, hint) <= width;
  if (one_line) {
    draw_text(ui.look.fonts.text, {x, stage.y + ui.layout.size(4), width, ui.layout.size(24)},
              ui.look.palette.text, hint, Align::centre);
  } else {
    draw_paragraphs(ui.look.fonts.text, x, stage.y + ui.layout.size(4), width, ui.look.palette.text,
                    hint);
  }
}

}  // namespace promenade::app
