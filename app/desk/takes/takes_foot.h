// The foot of the page "Takes to walks": how many walks there are, where the set goes, and what
// became of making it.
#pragma once

#include "app/desk/takes/takes_work.h"
#include "app/text_box.h"
#include "study/texts.h"

namespace promenade::app {

class TakesFoot {
 public:
  TakesFoot(TakesWork& work, const std::string& folder);

  // Whose motions these are, and the set's file: below the set.
  float fields_height(const Ui& ui) const;
  void draw_fields(const Ui& ui, const study::Texts& words, const Box& box, std::int64_t now_us);
  void draw(const Ui& ui, const study::Texts& words, const Box& box);
  std::string file() const;  // of the set
  const std::string& credit() const { return credit_.text.words(); }
  // The set lies beside the recipe that was opened; when that is undone, where it was to lie
  // before.
  void follow_recipe();
  void save();  // the recipe

 private:
  void draw_state(const Ui& ui, const study::Texts& words, const Box& box) const;
  void draw_progress(const Ui& ui, const study::Texts& words, const Box& box);
  void describe(const std::string& set);
  void make();

  TakesWork& work_;
  std::string folder_;
  Draft file_, credit_;
  std::string recipe_;                 // that file_ lies beside; empty: none
  std::string own_file_, own_credit_;  // from before it
};

}  // namespace promenade::app
