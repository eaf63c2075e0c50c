// From takes to walks: captures come in at the left, what they show is seen in the middle, and at
// the right a motion set grows. The recipe of the set lies beside it (study/workshop_recipe.h).
#pragma once

#include <functional>

#include "app/desk/page.h"
#include "app/desk/takes/takes_foot.h"
#include "app/desk/takes/takes_list.h"
#include "app/desk/takes/takes_set.h"
#include "app/desk/takes/takes_stage.h"
#include "app/desk/takes/takes_timeline.h"
#include "study/capture_files.h"

namespace promenade::app {

class TakesPage : public DeskPage {
 public:
  // `folder`: where sets are made, if nobody says another place.
  explicit TakesPage(const std::string& folder);

  void advance(std::int64_t now_us) override;
  void draw_figures(FigureRenderer& renderer, const Gui& gui) override;
  void draw(const Ui& ui, const study::Texts& words, const Box& room) override;
  void dropped(const std::vector<std::string>& paths) override;
  bool moves() const override;
  bool unsaved() const override { return work_.unsaved(); }
  void save() override { foot_.save(); }
  const std::vector<std::string>& shown_words() const override;

  TakesWork& work() { return work_; }
  const TakesFoot& foot() const { return foot_; }

 private:
  std::vector<std::string> words_beside() const;
  void draw_middle(const Ui& ui, const study::Texts& words, const Box& box);
  void draw_nothing_yet(const Ui& ui, const study::Texts& words, const Box& box);
  void draw_take(const Ui& ui, const study::Texts& words, const Box& box);
  void draw_lines(const Ui& ui, const study::Texts& words, const Box& box);
  std::string facts_of(const study::Texts& words, std::size_t take) const;
  void draw_says(const Ui& ui, const study::Texts& words, const Box& box,
                 const std::string& reason);
  void draw_tools(const Ui& ui, const study::Texts& words, const Box& box);
  void draw_loop_facts(const Ui& ui, const study::Texts& words, const Box& box) const;
  void hear_keys(const Ui& ui);

  TakesWork work_;
  TakesList list_;
  TakesStage stage_;
  TakesTimeline timeline_;
  TakesSet set_;
  TakesFoot foot_;
  std::string lines_of_;  // the file that `lines_` are of
  std::vector<study::FileLine> lines_;
  bool forgotten_ = false;  // somebody wants the take off the list
  std::int64_t now_us_ = 0;
  mutable std::vector<std::string> shown_, shown_beside_;
  mutable int shown_revision_ = -1;
};

}  // namespace promenade::app
