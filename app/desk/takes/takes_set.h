// The set as it grows: a tile for each walk, in which it walks, with its name, which is written
// over in place.
#pragma once

#include <map>

#include "app/desk/takes/take_figures.h"
#include "app/desk/takes/takes_work.h"
#include "app/gui.h"
#include "app/widgets.h"
#include "study/texts.h"

namespace promenade::app {

class TakesSet {
 public:
  explicit TakesSet(TakesWork& work) : work_(work) {}

  // Under what draw() drew last. `box` is the whole column, whose ground it draws too.
  void draw_figures(FigureRenderer& renderer, const Gui& gui);
  void draw(const Ui& ui, const study::Texts& words, const Box& box);
  bool writing() const { return renamed_.has_value(); }
  const std::string& written() const { return written_; }  // a name

 private:
  using Key = std::pair<std::string, std::size_t>;  // file and cycle
  struct Shown {
    Box box, clip;
    const LoopFigure* figure = nullptr;
    double late_s = 0;  // so that they do not all step at once
  };
  Key key_of(const study::WalkPlace& walk) const;
  const std::string& name_of(const study::WalkPlace& walk) const;
  const LoopFigure* figure_of(const study::WalkPlace& walk);
  void draw_tile(const Ui& ui, const study::WalkPlace& walk, const Box& cell);
  void draw_name(const Ui& ui, const study::WalkPlace& walk, const Box& box);
  void begin_renaming(const Ui& ui, const study::WalkPlace& walk);
  void end_renaming(const Ui& ui, bool keep);

  TakesWork& work_;
  std::map<Key, std::unique_ptr<LoopFigure>> figures_;
  std::vector<Shown> shown_;
  Box area_;
  std::optional<Key> renamed_;
  std::optional<study::WalkPlace> removed_;
  std::string written_;
  bool refused_name_ = false, was_written_ = false;
  std::vector<Part> parts_;
};

}  // namespace promenade::app
