// What the coming block asks for: words and walking figures at the left, the very
// controls at the right, to be looked at.
#include <cmath>
#include <vector>

#include "app/screens/screen.h"

namespace promenade::app {
namespace {

// What is asked, and how it ends.
std::string match_text(const Screen& screen, const study::Task& task) {
  if (task.blind) return screen.texts("instructions.match_blind");
  const char* ending = task.threshold_m ? "instructions.match_done" : "instructions.match_by_hand";
  return screen.texts.with("instructions.match", {{"ending", screen.texts(ending)}});
}

std::string kind_text(const Screen& screen, const study::Task& task) {
  switch (task.kind) {
    case study::TaskKind::match:
      return match_text(screen, task);
    case study::TaskKind::find:
      return screen.texts("instructions.find");
    case study::TaskKind::guess:
      return screen.texts("instructions.guess");
    case study::TaskKind::rate:
      break;
  }
  const char* beside = task.reference < 0 ? "instructions.rate" : "instructions.rate_beside";
  return screen.texts(beside);
}

std::string task_text(const Screen& screen) {
  const study::Task& task = task_of(screen);
  const std::string text = kind_text(screen, task);
  if (!task.limit_s) return text + "\n\n" + screen.texts("instructions.no_limit");
  const std::string seconds = std::to_string(std::lround(*task.limit_s));
  return text + "\n\n" + screen.texts.with("instructions.limit", {{"seconds", seconds}});
}

std::string help_text(const Screen& screen) {
  const char* controls =
      planned_trial(screen).interface < 0 ? "instructions.pause" : "instructions.start_over";
  std::string text = screen.texts("instructions.camera") + "\n" + screen.texts(controls);
  if (planned_trial(screen).practice) text += "\n" + screen.texts("instructions.practice");
  return text;
}

// As it looks at the start of a trial, and one thing done to it.
void picture_controls(const Screen& screen, const study::InterfaceType& type) {
  ScreenMemory& memory = screen.memory;
  const int trial = screen.session.page().trial;
  if (memory.pictured && memory.pictured_trial == trial) return;
  const motion::MotionSpace& space = screen.bundle.space;
  const study::InterfaceUse& use = use_of(screen);
  memory.pictured_trial = trial;
  memory.pictured = type.start({space, use.parameters, study::start_weights(space), 1, use.model});
  study::Rng rng(1, 0, "picture");
  for (study::ControlInput input : type.simulate(*memory.pictured, rng)) {
    input.t_us = 0;
    if (memory.pictured->apply(input) == study::Applied::done) break;
  }
}

void draw_picture(const Screen& screen) {
  if (planned_trial(screen).interface < 0) return draw_rate_picture(screen);
  const study::InterfaceType& type = *screen.registry.find(use_of(screen).type);
  picture_controls(screen, type);
  Ui ui = screen.ui;
  ui.inert = true;
  const Box box = ui.layout.panel();
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::BeginChild("picture", {box.width, box.height}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoInputs);
  study::InterfacePanel panel(ui, box, screen.content, study::settled_us, screen.memory.unheard);
  type.draw(*screen.memory.pictured, panel);
  ImGui::EndChild();
  screen.memory.unheard.clear();
}

struct Paragraphs {
  ImFont* font;
  std::string text;
  float gap;  // below, at 720
};
using Words = std::vector<Paragraphs>;

Words words_of(const Screen& screen, ImFont* font, float gap) {
  const Fonts& fonts = screen.ui.look.fonts;
  Words words = {{font, task_text(screen), gap}};
  if (planned_trial(screen).interface >= 0) {
    const study::InterfaceUse& use = use_of(screen);
    words.push_back({fonts.bold, title_of(screen, use), 2});
    words.push_back({font, screen.texts("interface." + use.type + ".hint"), gap});
  }
  words.push_back({fonts.text, help_text(screen), 0});
  return words;
}

float height_of(const Screen& screen, const Words& words, float width) {
  float height = 0;
  for (const Paragraphs& part : words) {
    height += paragraphs_height(part.font, width, part.text) + screen.ui.layout.size(part.gap);
  }
  return height;
}

// Down to the figures; long words are smaller, and scroll if they are still too long.
void draw_words(const Screen& screen) {
  const Ui& ui = screen.ui;
  const Box box = ui.layout.box(32, 80, 784, 400);
  Words words = words_of(screen, ui.look.fonts.reading, 18);
  if (height_of(screen, words, box.width) > box.height) {
    words = words_of(screen, ui.look.fonts.text, 10);
  }
  float y = begin_body(screen, box, height_of(screen, words, box.width));
  for (const Paragraphs& part : words) {
    y += draw_paragraphs(part.font, box.x, y, box.width, ui.look.palette.text, part.text);
    y += ui.layout.size(part.gap);
  }
  end_body(screen, box, y);
}

}  // namespace

void draw_instructions(const Screen& screen) {
  const Ui& ui = screen.ui;
  draw_text(ui.look.fonts.heading, ui.layout.box(32, 20, 784, 56), ui.look.palette.text,
            screen.texts("instructions.title"));
  draw_just_ended(screen, ui.layout.box(400, 24, 720, 36));
  draw_words(screen);
  draw_stage(screen);
  draw_picture(screen);
  const bool rated = planned_trial(screen).interface < 0;
  const Box below = ui.layout.box(848, 644, 200, 56);
  draw_paragraphs(ui.look.fonts.text, below.x, below.y, below.width, ui.look.palette.quiet,
                  screen.texts(rated ? "instructions.questions" : "instructions.controls"));
  const std::string& label =
      screen.texts(planned_trial(screen).practice ? "button.practice" : "button.start");
  if (main_button(screen, {{}, {}, label}, ui.layout.box(1064, 648, 200, 48), true)) {
    screen.actions.emplace_back(study::Continue{});
  }
}

}  // namespace promenade::app
