// An interface of the study as participants will see it, to be tried: its map, its sliders, its
// list, with the settings that the file says.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/desk/edit_controls.h"
#include "app/desk/edit_figures.h"

namespace promenade::app {

class EditPreview {
 public:
  void draw(const FormPass& pass, const Box& box,
            const std::shared_ptr<const study::StudyBundle>& bundle, EditFigures& figures);
  // What the controls make now: N weights.
  const Eigen::VectorXd& weights() const { return weights_; }

 private:
  void begin(const FormPass& pass, const std::shared_ptr<const study::StudyBundle>& bundle);
  std::shared_ptr<const study::StudyBundle> bundle_;  // of the state
  std::size_t chosen_ = 0, shown_ = 0;
  std::unique_ptr<study::InterfaceState> state_;
  std::vector<study::ControlInput> changes_;
  Eigen::VectorXd weights_;
};

}  // namespace promenade::app
