// The form of the Edit page: sections of fields on the left, the fields of one of them beside, and
// a sentence about the field that the hand is on below.
#pragma once

#include <set>
#include <string>

#include "app/desk/edit/edit_controls.h"

namespace promenade::app {

class EditForm {
 public:
  // What to say of a text that is no value for this field: what it takes.
  static std::string refusal_of(const EditField& field, const study::Texts& words);
  void draw(const Ui& ui, const study::Texts& words, const Box& box, const FormScene& scene);
  // Shows the field of this value, and brings the keyboard to it.
  void go_to(const study::TomlPath& path);
  // The same without the keyboard.
  void reveal(const study::TomlPath& path);
  void show(std::size_t section);
  std::size_t section() const { return section_; }
  // The value that the keyboard works on; empty: none.
  const study::TomlPath& focused() const { return focused_; }

 private:
  void draw_sections(const FormPass& pass, const Box& box);
  void draw_rows(const FormPass& pass, const Box& box);
  void draw_row(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_field(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_list(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_item(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_item_buttons(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_add(const FormPass& pass, const FormRow& row, const Box& box);
  void fold_removed(const study::TomlPath& list, std::size_t index, std::size_t count);
  void draw_label(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_help(const FormPass& pass, const Box& box) const;
  float draw_problems(const FormPass& pass, const FormRow& row, const Box& box) const;
  float problems_height(const FormPass& pass, const FormRow& row, float width) const;
  std::vector<const PlacedProblem*> problems_of(const FormPass& pass, const FormRow& row) const;
  float row_height(const FormPass& pass, const FormRow& row, float width) const;
  void come(const FormPass& pass, const FormRow& row);
  void note(const FormPass& pass, const FormRow& row, const Box& box);
  void move_open(const study::TomlPath& list, std::size_t from, std::size_t to);

  EditControls controls_;
  std::size_t section_ = 0;
  std::set<std::string> open_;
  std::optional<study::TomlPath> wanted_;  // go_to, not done yet
  study::TomlPath focused_, hovered_;
  std::string help_;  // of the field that is focused or, first, hovered
  bool help_hovered_ = false;
};

}  // namespace promenade::app
