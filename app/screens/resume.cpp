#include <algorithm>

#include "app/screens/screen.h"

namespace promenade::app {
namespace {

constexpr std::size_t most_offers = 5;

std::string label_of(const Screen& screen, const study::InterruptedSession& session) {
  const char* key = session.trial > 0 ? "resume.at_task" : "resume.at_beginning";
  return screen.texts.with(key, {{"code", session.participant},
                                 {"number", std::to_string(session.trial)},
                                 {"count", std::to_string(screen.session.plan().trials.size())}});
}

}  // namespace

// Before anything else when the program died in a session, or once somebody who left has typed
// the code: it may go on.
void draw_resume(const Screen& screen) {
  const Ui& ui = screen.ui;
  ScreenMemory& memory = screen.memory;
  const bool left = std::all_of(memory.offered.begin(), memory.offered.end(),
                                [](const study::InterruptedSession& one) { return one.left; });
  const float below =
      draw_text_column(screen, screen.texts(left ? "resume.left_title" : "resume.title"),
                       screen.texts(left ? "resume.left" : "resume.text"));
  const Box column = ui.layout.column();
  float y = below + ui.layout.size(32);
  for (std::size_t i = 0; i < std::min(most_offers, memory.offered.size()); ++i) {
    const study::InterruptedSession& session = memory.offered[i];
    const Box box{column.x, y, column.width, ui.layout.size(56)};
    if (button(ui, "resume:" + session.uuid, box, label_of(screen, session),
               i == 0 ? ButtonKind::filled : ButtonKind::outlined)) {
      memory.resume = session.uuid;
    }
    y += ui.layout.size(68);
  }
  // The likely answer is filled; Enter is none.
  if (button(ui, "begin_new", ui.layout.box(720, 640, 240, 48), screen.texts("resume.new"),
             ButtonKind::outlined)) {
    memory.refuses_offers = true;
  }
}

}  // namespace promenade::app
