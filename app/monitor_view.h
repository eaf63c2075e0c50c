// Draws what study::Watch tells, to be read from two metres: at the top how many have finished, a
// card for each session that runs or waits to be resumed, below those that ended. Nothing in it
// can be touched; what has no room is scrolled with the wheel.
#pragma once

#include <string>
#include <vector>

#include "app/monitor_card.h"
#include "app/tool_page.h"
#include "study/watch.h"

namespace promenade::app {

// Every text that the view can show of it.
std::vector<std::string> shown_words(const study::Watched& now);

class MonitorView {
 public:
  explicit MonitorView(InputQueue& queue) : page_(queue) {}

  void frame(Gui& gui, const study::Watched& now);
  // Each card under "session" and its uuid, its parts under theirs; each row under "ended".
  const WidgetMap& widgets() const { return page_.widgets(); }

 private:
  void draw(const Ui& ui, const study::Watched& now);
  void draw_head(const Ui& ui, const study::Watched& now);
  void draw_sessions(const Ui& ui, const study::Watched& now, const Box& box);
  void draw_ended(const Ui& ui, const study::Watched& now, const Box& box);

  ToolPage page_;
};

}  // namespace promenade::app
