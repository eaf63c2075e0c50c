// Results, the roster: who is booked, who came, who did not, and who comes instead.
#pragma once

#include <string>
#include <vector>

#include "app/desk/column.h"
#include "app/desk/open_study.h"
#include "app/desk/services.h"
#include "app/number_box.h"
#include "study/roster.h"
#include "study/texts.h"

namespace promenade::app {

class ResultsRoster {
 public:
  ResultsRoster(DeskServices& services, const OpenStudy& study)
      : services_(services), study_(study), place_(study.place()) {}

  void read();
  void draw_list(const Ui& ui, const study::Texts& words, const Box& box);
  void draw_chosen(const Ui& ui, const study::Texts& words, Column& column, std::int64_t now_us);
  const std::vector<std::string>& shown_words() const { return shown_; }

 private:
  void draw_row(const Ui& ui, const study::Texts& words, const study::RosterRow& one,
                const Box& box);
  void command(const study::Texts& words, const std::vector<std::string>& options);
  const study::RosterRow* chosen() const;

  DeskServices& services_;
  const OpenStudy& study_;
  study::StudyPlace place_;
  std::vector<study::RosterRow> rows_;
  std::string chosen_, trouble_;  // chosen: a code
  NumberDraft people_{12}, stations_{1};
  std::vector<std::string> shown_;
};

}  // namespace promenade::app
