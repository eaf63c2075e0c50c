// An interface of the study as participants will see it, to be tried: its map, its sliders, its
// list, with the settings that the file says. And the trees behind the sliders: which adjectives,
// and which features, go together in this motion set.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/desk/edit/edit_controls.h"
#include "app/desk/edit/edit_figures.h"
#include "app/desk/newest_work.h"
#include "app/model_editor.h"

namespace promenade::app {

class EditPreview {
 public:
  // `bundle`: of the last text without errors; null: there was none. While it is of another set
  // than the figures are, nothing can be tried.
  void draw(const FormPass& pass, const Box& box,
            const std::shared_ptr<const study::StudyBundle>& bundle, EditFigures& figures);
  bool working() const { return work_.working(); }
  // What the controls make now: N weights.
  const Eigen::VectorXd& weights() const { return weights_; }
  const ModelEditor* tree() const { return tree_.get(); }  // null: none is shown, or not yet

 private:
  enum class Tree { adjectives, features };
  void begin(const FormPass& pass, const std::shared_ptr<const study::StudyBundle>& bundle);
  void draw_interface(const FormPass& pass, const Box& box, EditFigures& figures);
  void draw_tree(const FormPass& pass, const Box& box, Tree tree);
  void plant(Tree tree);
  std::shared_ptr<const study::StudyBundle> bundle_;  // of the state
  std::size_t chosen_ = 0, shown_ = 0;
  std::unique_ptr<study::InterfaceState> state_;
  std::vector<study::ControlInput> changes_;
  Eigen::VectorXd weights_;
  std::shared_ptr<ModelEditor> tree_;
  std::shared_ptr<const study::StudyBundle> planted_;  // what the tree is of, or will be
  Tree planted_tree_ = Tree::adjectives;
  NewestWork<std::shared_ptr<ModelEditor>> work_;
};

}  // namespace promenade::app
