// The controls of the form: for each kind of field one that shows its value in the file and changes
// it there. What is no value yet (a number that is out of range) stays in its box and is said.
#pragma once

#include <map>
#include <string>

#include "app/desk/edit/edit_options.h"
#include "app/desk/edit/edit_rows.h"
#include "app/desk/edit/edit_values.h"
#include "app/desk/edit/study_check.h"
#include "app/desk/edit/written_field.h"
#include "study/study_draft.h"
#include "study/texts.h"

namespace promenade::app {

// What the form shows and works on.
struct FormScene {
  study::StudyDraft& draft;
  const EditOptions& options;
  const std::vector<PlacedProblem>& problems;
  const study::InterfaceRegistry& registry;
  std::int64_t now_us = 0;
};

// One drawing of it.
struct FormPass {
  const Ui& ui;
  const study::Texts& words;
  const FormScene& scene;

  const study::TomlValue& root() const { return scene.draft.root(); }
  std::vector<std::string> languages() const;  // of the study
};

class EditControls {
 public:
  // Pixels.
  float height(const FormPass& pass, const FormRow& row) const;
  void draw(const FormPass& pass, const FormRow& row, const Box& box);
  // Nobody writes any more: the fields are hidden.
  void leave();
  // Other fields have these paths now.
  void forget() { boxes_.clear(); }
  // What was written in a field is no value for it.
  bool is_refused(const study::TomlPath& path) const;
  // The kind of control that the keyboard comes to for a field, and its target.
  static std::pair<std::string, std::string> stop_of(const FormPass& pass, const FormRow& row);

 private:
  // True: it was changed by hand.
  bool write(const FormPass& pass, const Box& box, const WrittenField::Look& look);
  // What was written; `shown` tells how the file has it now.
  template <typename Shown>
  void take(const FormPass& pass, const std::string& target, const std::optional<Edits>& edits,
            const Shown& shown);
  // A change by one press.
  static void change(const FormPass& pass, const std::optional<Edits>& edits);

  void draw_text(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_words(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_choice(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_flag(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_some(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_source(const FormPass& pass, const FormRow& row, const Box& box);

  std::map<std::string, WrittenField, std::less<>> boxes_;  // by their targets
};

}  // namespace promenade::app
