// Draws what study::Watch tells, to be read from two metres: at the top how many have finished, a
// card for each session that runs or waits to be resumed, below those that ended. What has no room
// is scrolled with the wheel. The window of `promenade monitor` shows it whole, and nothing in it
// can be touched there; on the page of the desk a card can be chosen.
#pragma once

#include <string>
#include <vector>

#include "app/monitor_card.h"
#include "app/tool_page.h"
#include "study/texts.h"
#include "study/watch.h"

namespace promenade::app {

// Every text that the view can show of it and that stands in no file of texts.
std::vector<std::string> shown_words(const study::Watched& now);

// `chosen`: the uuid of the chosen session, which pressing another card ("choose" and its uuid)
// changes; null: nothing can be touched. Each card is in the map under "session" and its uuid, its
// parts under theirs, each row under "ended".
void draw_monitor(const Ui& ui, const study::Texts& texts, const study::Watched& now,
                  const Box& room, std::string* chosen = nullptr);

// As the window has it, in English.
class MonitorView {
 public:
  explicit MonitorView(InputQueue& queue);

  void frame(Gui& gui, const study::Watched& now);
  const WidgetMap& widgets() const { return page_.widgets(); }

 private:
  study::Texts texts_;
  ToolPage page_;
};

}  // namespace promenade::app
