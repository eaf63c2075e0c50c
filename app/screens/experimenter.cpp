// What the experimenter can do in a session: over a page that nobody opens by accident, and
// while it is open the session stands still and nothing of it can be seen.
#include <array>

#include "app/screens/screen.h"

namespace promenade::app {
namespace {

constexpr const char* words_field = "experimenter:words";

void close(const Screen& screen) {
  ExperimenterPanel& panel = screen.memory.panel;
  panel = {};
  screen.memory.asks_to_end = false;
}

void open(const Screen& screen) {
  ExperimenterPanel& panel = screen.memory.panel;
  panel.open = true;
  panel.over_pause = screen.session.paused();
  if (!panel.over_pause) screen.orders.emplace_back(study::Pause{});
}

// Which session this is, and where it stands.
std::string place_of(const Screen& screen) {
  const study::Page& page = screen.session.page();
  std::string place(screen.participant);
  if (page.trial >= 0) {
    const study::PlannedTrial& planned = planned_trial(screen);
    place += ": " + task_of(screen).name;
    if (planned.interface >= 0) place += ", " + use_of(screen).name;
    place += ", " + number_of(screen);
  }
  return place + " (" + std::string(study::to_text(page.kind)) + ")";
}

struct Button {
  const char* name;  // of its texts and its target
  StudyAction action;
  bool possible;
  bool needs_words;
  bool leaves;  // the panel
};

std::array<Button, 6> buttons(const Screen& screen, const std::string& words) {
  const study::Session& session = screen.session;
  const bool waits = session.page().kind == study::PageKind::release;
  return {{{"note", study::Note{words}, true, true, false},
           {"release", study::Release{}, waits, false, true},
           {"skip", study::Skip{words}, session.can_skip(), true, true},
           {"repeat_trial", study::Repeat{false, words}, session.can_repeat(), true, true},
           {"repeat_block", study::Repeat{true, words}, session.can_repeat(), true, true},
           {"stop", study::Stop{words}, true, true, true}}};
}

void press(const Screen& screen, const Button& one, bool has_words) {
  ExperimenterPanel& panel = screen.memory.panel;
  panel.said = one.needs_words && !has_words ? "experimenter.words_missing" : "";
  if (!one.possible || !panel.said.empty()) return;
  screen.orders.push_back(one.action);
  if (one.leaves) return close(screen);
  panel.words = {};
  panel.said = "experimenter.noted";
}

float draw_words(const Screen& screen, float y) {
  const Ui& ui = screen.ui;
  const Box column = ui.layout.column();
  draw_text(ui.look.fonts.bold, {column.x, y, column.width, ui.layout.size(28)},
            ui.look.palette.text, screen.texts("experimenter.words"));
  const Box box{column.x, y + ui.layout.size(28), column.width, ui.layout.size(76)};
  text_box(ui, words_field, box, screen.memory.panel.words, {.most = 500}, screen.now_us);
  if (screen.memory.panel.words.changed) screen.memory.panel.said.clear();
  return box.bottom() + ui.layout.size(16);
}

void draw_buttons(const Screen& screen, float y, const std::string& words) {
  const Ui& ui = screen.ui;
  const bool has_words = words.find_first_not_of(" \n") != std::string::npos;
  const float x = ui.layout.column().x;
  for (const Button& one : buttons(screen, words)) {
    const std::string key = std::string("experimenter.") + one.name;
    const Box box{x, y, ui.layout.size(208), ui.layout.size(40)};
    if (button(ui, std::string("experimenter:") + one.name, box, screen.texts(key),
               ButtonKind::outlined, one.possible)) {
      press(screen, one, has_words);
    }
    draw_line(ui.look.fonts.text,
              {box.right() + ui.layout.size(16), y, ui.layout.size(416), box.height},
              ui.look.palette.quiet, screen.texts(key + "_does"));
    y += ui.layout.size(46);
  }
}

}  // namespace

bool open_experimenter(const Screen& screen) {
  ExperimenterPanel& panel = screen.memory.panel;
  if (screen.chord && !panel.open) open(screen);
  return panel.open;
}

void draw_experimenter(const Screen& screen) {
  const Ui& ui = screen.ui;
  const Box column = ui.layout.column();
  if (screen.fresh) ui.focus.write_in("type", words_field);
  const float below = draw_text_column(screen, screen.texts("experimenter.title"),
                                       screen.texts("experimenter.text"));
  draw_line(ui.look.fonts.text,
            {column.x, below + ui.layout.size(4), column.width, ui.layout.size(24)},
            ui.look.palette.quiet, place_of(screen));
  const float top = draw_words(screen, below + ui.layout.size(36));
  draw_buttons(screen, top, screen.memory.panel.words.text.words());
  if (!screen.memory.panel.open) return;
  if (!screen.memory.panel.said.empty()) {
    draw_text(ui.look.fonts.bold, ui.layout.box(320, 640, 424, 48), ui.look.palette.text,
              screen.texts(screen.memory.panel.said));
  }
  if (!button(ui, "experimenter:back", ui.layout.box(760, 640, 200, 48),
              screen.texts("experimenter.back"), ButtonKind::filled)) {
    return;
  }
  if (!screen.memory.panel.over_pause) screen.orders.emplace_back(study::Resume{});
  close(screen);
}

}  // namespace promenade::app
