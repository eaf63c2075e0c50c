// A take over time: when which foot stands, where the figure turns or stands, what was lost, and
// the loops that it offers. The ends of the chosen one are dragged, or moved by the arrow keys.
#pragma once

#include "app/desk/takes/takes_work.h"
#include "app/widgets.h"
#include "study/texts.h"

namespace promenade::app {

class TakesTimeline {
 public:
  explicit TakesTimeline(TakesWork& work) : work_(work) {}
  void draw(const Ui& ui, const study::Texts& words, const Box& box);

 private:
  struct Rows;
  struct Shown {  // frames that are seen
    double from = 0, to = 1;
  };
  struct Edge {
    bool seen = false, hot = false;
  };
  void follow(const motion::TakeReview& review);
  void zoom(const Ui& ui, const Box& box);
  std::vector<std::vector<double>> loops_in_time() const;  // keytimes of each
  void choose(const std::vector<double>& keys);
  void choose_by_key(const Ui& ui, const std::vector<std::vector<double>>& loops);
  void draw_rows(const Ui& ui, const study::Texts& words, const Rows& rows) const;
  void draw_ruler(const Ui& ui, const Rows& rows);
  void draw_loops(const Ui& ui, const study::Texts& words, const Rows& rows);
  void draw_chosen(const Ui& ui, const study::Texts& words, const Rows& rows);
  static void draw_numbers(const Ui& ui, const study::Texts& words, const Rows& rows,
                           const Box& band, const motion::LoopReview& loop);
  Edge touch_edge(const Ui& ui, const Rows& rows, bool last);
  void draw_edge(const Ui& ui, const Rows& rows, bool last, bool hot) const;
  void draw_overview(const Ui& ui, const Rows& rows);

  TakesWork& work_;
  const motion::TakeReview* review_ = nullptr;
  Shown shown_;
  double grip_ = 0;  // frames between the hand and the edge that it holds
  int gesture_ = 0;
};

// "seam 8 mm, slide 3 mm"
std::string loop_says(const motion::LoopReview& loop, const study::Texts& words);

}  // namespace promenade::app
