// Draws a ModelEditor and says what was done to it: the tree on the left, cut by a line that is
// dragged; on the right the thresholds, the table of pairs, and Save.
#pragma once

#include <functional>
#include <string>

#include "app/model_editor.h"
#include "app/tool_page.h"

namespace promenade::app {

// Every text that the view can show.
std::vector<std::string> shown_words(const ModelEditor& editor);

class ModelView {
 public:
  // `save`: writes the model, and throws InputError or OutsideError; empty: there is no Save.
  // All outlive the view.
  ModelView(ModelEditor& editor, Gui& gui, InputQueue& queue,
            std::function<void(const study::AdjectiveModel&)> save);

  // Draws until nothing waits in the queue.
  void frame();
  const WidgetMap& widgets() const { return page_.widgets(); }
  const std::string& said() const { return saved_.words; }  // about the last Save

 private:
  void draw(const Ui& ui);
  void draw_head(const Ui& ui);
  void draw_tree(const Ui& ui);
  void draw_names(const Ui& ui, const Box& box);
  void draw_field(const Ui& ui, const Box& box);
  void draw_thresholds(const Ui& ui, const Box& box);
  void draw_table(const Ui& ui, const Box& box);
  void draw_foot(const Ui& ui);
  void save();

  ModelEditor& editor_;
  Gui& gui_;
  ToolPage page_;
  std::function<void(const study::AdjectiveModel&)> save_;
  float row_ = 17;    // pixels, of a leaf
  int renamed_ = -1;  // the cluster whose name is being written
  std::string text_;  // what was written
  SaveReport saved_;  // the last time; no words: not since something changed
};

}  // namespace promenade::app
