// The page of a window that is no session: it takes in what has arrived and is drawn again for each
// change that waits, since Dear ImGui sees one change of a button or a key at a time.
#pragma once

#include <functional>
#include <string>

#include "app/focus.h"
#include "app/gui.h"
#include "app/widgets.h"
#include "app/window/input_queue.h"

namespace promenade::app {

class ToolPage {
 public:
  // Outlives it.
  explicit ToolPage(InputQueue& queue) : queue_(queue) {}

  // Draws until nothing waits in the queue; the drawing is left in ImGui::GetDrawData.
  void frame(Gui& gui, const std::function<void(const Ui&)>& draw);
  const WidgetMap& widgets() const { return widgets_; }
  const Focus& focus() const { return focus_; }
  Focus& focus() { return focus_; }

 private:
  void pass(const Gui& gui, const std::function<void(const Ui&)>& draw);

  InputQueue& queue_;
  WidgetMap widgets_;
  Focus focus_;
};

// What became of saving, for people: "Saved", or why not.
struct SaveReport {
  std::string words;
  bool failed = false;
};

// `save` may throw InputError or OutsideError.
SaveReport report_of_saving(const std::function<void()>& save);

}  // namespace promenade::app
