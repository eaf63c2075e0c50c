// All walks of the motion set as small figures: the one under the hand walks. A walk that is
// pressed can be made a target of a task.
#pragma once

#include <string>
#include <vector>

#include "app/desk/edit/edit_controls.h"
#include "app/desk/edit/edit_figures.h"

namespace promenade::app {

class EditWalks {
 public:
  void draw(const FormPass& pass, const Box& box, EditFigures& figures);
  const std::string& chosen() const { return chosen_; }  // the name of a walk; empty: none
  // Those that are under the hand or the keyboard.
  const std::vector<std::string>& walking() const { return walking_; }

 private:
  // The arrow keys go from tile to tile.
  static void go_by_key(const Ui& ui, const EditFigures& figures, const std::vector<int>& order,
                        int columns);
  void draw_tile(const FormPass& pass, const Box& tile, const Box& view, int walk,
                 EditFigures& figures);
  void draw_foot(const FormPass& pass, const Box& box);
  std::string chosen_, hovered_;
  std::size_t task_ = 0;              // of those that have targets
  std::vector<std::string> targets_;  // walks that are targets already
  std::vector<std::string> walking_;
};

}  // namespace promenade::app
