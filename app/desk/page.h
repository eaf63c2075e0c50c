// A page of the desk: what fills the window below its tabs. A page is plain state with a function
// that draws it; what takes longer than a frame is a job (app/desk/services.h) or a thread of the
// page's own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/figure/renderer.h"
#include "app/gui.h"
#include "app/widgets.h"
#include "study/texts.h"

namespace promenade::app {

class DeskPage {
 public:
  DeskPage() = default;
  virtual ~DeskPage() = default;
  DeskPage(const DeskPage&) = delete;
  DeskPage& operator=(const DeskPage&) = delete;

  // Before each frame: time passed, threads may have news.
  virtual void advance(std::int64_t now_us);
  // Figures, where the page has any, under what draw() draws. The picture is begun already.
  virtual void draw_figures(FigureRenderer& renderer, const Gui& gui);
  // `room`: pixels, all that the page has. May be called several times in a frame, once for each
  // change of a key or a button.
  virtual void draw(const Ui& ui, const study::Texts& words, const Box& room) = 0;
  // Files or folders were dropped on the window.
  virtual void dropped(const std::vector<std::string>& paths);
  // The page moves by itself: figures walk, something runs.
  virtual bool moves() const { return false; }
  // Something was changed here that is not on the disk yet; save() brings it there.
  virtual bool unsaved() const { return false; }
  virtual void save();
  // Names, notes and whatever else is shown that stands in no file of texts, for the characters of
  // the fonts. Asked before each frame, so it should cost nothing while nothing is new.
  virtual const std::vector<std::string>& shown_words() const;
};

}  // namespace promenade::app
