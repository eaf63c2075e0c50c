// What the coming block asks for, beside walking figures that can be turned
// already.
#include <cmath>

#include "app/screens/screen.h"

namespace promenade::app {
namespace {

std::string task_text(const Screen& screen) {
  const study::Task& task = task_of(screen);
  const bool match = task.kind == study::TaskKind::match;
  std::string text = screen.texts(match ? "instructions.match" : "instructions.find");
  const auto add = [&](const std::string& more) { text += "\n\n" + more; };
  if (match) add(screen.texts("instructions.match_done"));
  if (task.limit_s) {
    const auto seconds = static_cast<int>(std::lround(*task.limit_s));
    add(screen.texts.with("instructions.limit", {{"seconds", std::to_string(seconds)}}));
  } else {
    add(screen.texts("instructions.no_limit"));
  }
  add(screen.texts("instructions.start_over"));
  if (planned_trial(screen).practice) add(screen.texts("instructions.practice"));
  return text;
}

}  // namespace

void draw_instructions(const Screen& screen) {
  const Ui& ui = screen.ui;
  const Palette& palette = ui.look.palette;
  const study::PlannedTrial& planned = planned_trial(screen);
  const study::InterfaceUse& use =
      screen.bundle.study.interfaces[static_cast<std::size_t>(planned.interface)];
  draw_text(ui.look.fonts.heading, ui.layout.box(32, 24, 800, 56), palette.text,
            screen.texts("instructions.title"));
  draw_stage(screen);
  draw_text(ui.look.fonts.text, ui.layout.box(32, 84, 784, 28), palette.quiet,
            screen.texts("instructions.camera"));

  const Box panel = ui.layout.panel();
  const float inset = ui.layout.size(24);
  const float x = panel.x + inset;
  const float width = panel.width - 2 * inset;
  float y = panel.y + inset;
  y += draw_paragraphs(ui.look.fonts.text, x, y, width, palette.text, task_text(screen));
  y += ui.layout.size(24);
  fill({x, y, width, ui.layout.size(1)}, palette.line);
  y += ui.layout.size(20);
  const std::string key = "interface." + use.type + ".";
  y += draw_paragraphs(ui.look.fonts.bold, x, y, width, palette.text, screen.texts(key + "title"));
  y += ui.layout.size(6);
  draw_paragraphs(ui.look.fonts.text, x, y, width, palette.text, screen.texts(key + "hint"));
  if (button(ui, "continue", ui.layout.box(1064, 648, 200, 48),
             screen.texts(planned.practice ? "button.practice" : "button.start"),
             ButtonKind::filled)) {
    screen.actions.emplace_back(study::Continue{});
  }
}

}  // namespace promenade::app
