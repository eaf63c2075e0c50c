// The controls of the form: for each kind of field one that shows its value in the file and changes
// it there. What is no value yet (a number that is out of range) stays in its box and is said.
#pragma once

#include <map>
#include <string>

#include "app/desk/edit_options.h"
#include "app/desk/edit_rows.h"
#include "app/desk/edit_values.h"
#include "app/desk/study_check.h"
#include "app/text_box.h"
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
  // What was written in a field is no value for it.
  bool is_refused(const study::TomlPath& path) const;
  // The kind of control that the keyboard comes to for a field, and its target.
  static std::pair<std::string, std::string> stop_of(const FormPass& pass, const FormRow& row);

 private:
  struct Written {
    Draft draft;
    std::string shown;  // of the file, when it was looked at last
    bool fresh = true;
    bool active = false;  // in the frame before
    bool refused = false;
    int generation = 0;  // another one takes what is written out of Dear ImGui's hands
  };
  struct Line {
    std::string target, shown, hint;
    bool several = false;
  };
  // A box to write in; true: it was changed, and `text` is what it says now.
  bool write(const FormPass& pass, const Box& box, const Line& line, std::string& text);
  void follow(const FormPass& pass, const Line& line, Written& written);
  void change(const FormPass& pass, const std::string& target, const std::optional<Edits>& edits,
              bool typed);

  void draw_text(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_words(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_choice(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_flag(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_some(const FormPass& pass, const FormRow& row, const Box& box);
  void draw_source(const FormPass& pass, const FormRow& row, const Box& box);

  std::map<std::string, Written, std::less<>> boxes_;  // by their targets
};

}  // namespace promenade::app
