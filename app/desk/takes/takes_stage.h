// The middle of the page "Takes to walks": the figure that walks through its take and, beside it,
// the chosen loop. Both are seen by the same camera and turned by dragging them.
#pragma once

#include "app/desk/takes/take_figures.h"
#include "app/desk/takes/takes_work.h"
#include "app/gui.h"
#include "app/widgets.h"
#include "study/texts.h"

namespace promenade::app {

class TakesStage {
 public:
  explicit TakesStage(TakesWork& work) : work_(work) {}

  // Under what draw() drew last; nothing where there is no figure.
  void draw_figures(FigureRenderer& renderer, const Gui& gui);
  void draw(const Ui& ui, const study::Texts& words, const Box& box, const std::string& name);
  void hide() { box_ = {}; }
  Orbit& orbit() { return orbit_; }

 private:
  void follow();
  void draw_plate(const Ui& ui, const Box& half, std::string_view label, const Rgb& colour) const;

  TakesWork& work_;
  Box box_;  // of the figures; empty: not on the page
  Orbit orbit_;
  std::unique_ptr<TakeFigure> take_;
  std::unique_ptr<LoopFigure> loop_;
  FigureMoment take_now_, loop_now_;
};

}  // namespace promenade::app
