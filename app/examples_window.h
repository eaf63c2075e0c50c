// A second window on which all examples walk, as the video on the second screen of [O] 6
// did.
#pragma once

#include "app/gui.h"
#include "app/panel.h"
#include "app/window/gui_renderer.h"
#include "app/window/window.h"
#include "study/study.h"

namespace promenade::app {

class ExamplesWindow {
 public:
  // The bundle outlives it. Leaves its own window and Gui in use.
  ExamplesWindow(const study::StudyBundle& bundle, const WindowOptions& options);
  ~ExamplesWindow();
  ExamplesWindow(const ExamplesWindow&) = delete;
  ExamplesWindow& operator=(const ExamplesWindow&) = delete;

  void speak(const std::string& language);
  // The examples at a phase; hidden while the session is paused. Leaves its own window
  // and Gui in use.
  void draw(double phase, bool hidden);
  void show() { window_.swap(); }
  const Window& window() const { return window_; }

 private:
  void draw_names();

  const study::StudyBundle& bundle_;
  InputQueue nothing_;
  Window window_;
  Gui gui_;
  GuiRenderer gui_renderer_;
  FigureRenderer renderer_;
  Mannequin mannequin_;
  SmallFigures figures_;
  std::string language_;
  Captions captions_;
  study::InterfacePanel::Content content_;
  WidgetMap widgets_;
  Focus focus_;
  Eigen::VectorXd weights_;
};

}  // namespace promenade::app
