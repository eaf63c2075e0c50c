// The study file as it is, with the numbers of its lines: what is wrong is marked, and the lines of
// the field that the hand is on are in sight.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/desk/edit/study_check.h"
#include "app/widgets.h"
#include "study/study_draft.h"

namespace promenade::app {

class EditFileView {
 public:
  // `focused`: the value to be in sight; empty: none. The line that was pressed.
  std::optional<int> draw(const Ui& ui, const Box& box, const study::StudyDraft& draft,
                          const std::vector<PlacedProblem>& problems,
                          const study::TomlPath& focused);
  // Brings a line into sight, from 1, and chooses it.
  void show(int line) { wanted_ = chosen_ = line; }
  // The line that can be written in: that of the field, or one that was pressed.
  int chosen() const { return chosen_; }
  // Lines that are marked as the field's, from 1; 0: none.
  int first_marked() const { return first_; }

 private:
  // A line of the file, or a part of one that is too long for the view.
  struct Row {
    std::size_t begin = 0, end = 0;  // bytes
    int line = 0;
    bool goes_on = false;  // the line began above
    bool header = false;
    std::size_t remark = 0;  // from here on it is one
  };
  void lay_out(const Ui& ui, const study::StudyDraft& draft, float width);
  void add_line(const Ui& ui, const std::string& text, std::size_t begin, std::size_t end,
                const study::TomlStatement* statement, float width);
  void find_focus(const study::StudyDraft& draft, const study::TomlPath& focused);
  void bring_into_sight(const Ui& ui, float view_height);
  void draw_row(const Ui& ui, const std::string& text, const Row& row, const Box& box) const;
  void choose_by_key(const Ui& ui, float view_height);

  std::vector<Row> rows_;
  int version_ = -1, lines_ = 0;
  float width_ = 0;
  int first_ = 0, last_ = 0;  // lines of the field
  study::TomlPath focused_;
  int chosen_ = 1;
  int wanted_ = 0;      // a line to be brought into sight; 0: none
  bool moved_ = false;  // another field: it is to be brought into sight
};

// What is wrong, below each other; the one that was pressed.
std::optional<std::size_t> draw_problem_list(const Ui& ui, const study::Texts& words,
                                             const Box& box,
                                             const std::vector<PlacedProblem>& problems,
                                             bool working);

}  // namespace promenade::app
