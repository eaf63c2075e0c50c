// The page of a window that is no session: it takes in what has arrived and is drawn again for each
// change that waits, since Dear ImGui sees one change of a button or a key at a time.
#pragma once

#include <functional>

#include "app/focus.h"
#include "app/gui.h"
#include "app/widgets.h"
#include "app/window/input_queue.h"

namespace promenade::app {

class ToolPage {
 public:
  // Both outlive it.
  ToolPage(Gui& gui, InputQueue& queue) : gui_(gui), queue_(queue) {}

  // Draws until nothing waits in the queue; the drawing is left in ImGui::GetDrawData.
  void frame(const std::function<void(const Ui&)>& draw);
  const WidgetMap& widgets() const { return widgets_; }
  const Focus& focus() const { return focus_; }
  Focus& focus() { return focus_; }

 private:
  void pass(const std::function<void(const Ui&)>& draw);

  Gui& gui_;
  InputQueue& queue_;
  WidgetMap widgets_;
  Focus focus_;
};

}  // namespace promenade::app
