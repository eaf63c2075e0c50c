// The Edit page of the desk: a form for what people change in a study, beside its file. The file
// stays the truth: the form changes one value of its text at a time (study/toml_edit.h), `check`
// reads the text as it is in a thread, and what is wrong stands at the field and at the line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/desk/edit/edit_distances.h"
#include "app/desk/edit/edit_file_view.h"
#include "app/desk/edit/edit_form.h"
#include "app/desk/edit/edit_line.h"
#include "app/desk/edit/edit_preview.h"
#include "app/desk/edit/edit_walks.h"
#include "app/desk/page.h"
#include "app/tool_page.h"

namespace promenade::app {

class EditPage : public DeskPage {
 public:
  // `file`: of the study. One that cannot be read is said, and read again when it can.
  explicit EditPage(std::string file);
  ~EditPage() override;

  void advance(std::int64_t now_us) override;
  void draw_figures(FigureRenderer& renderer, const Gui& gui) override;
  void draw(const Ui& ui, const study::Texts& words, const Box& room) override;
  bool moves() const override;
  bool unsaved() const override;
  void save() override;
  const std::vector<std::string>& shown_words() const override { return shown_; }

  // Null: the file cannot be read.
  const study::StudyDraft* draft() const { return draft_ ? &*draft_ : nullptr; }
  const std::shared_ptr<const StudyCheck>& check() const { return check_; }  // null: none yet
  const EditForm& form() const { return form_; }
  int line() const { return file_view_.chosen(); }  // of the file, that can be written in
  const StudyChecker& checker() const { return *checker_; }
  const EditWalks& walks() const { return walks_; }
  const EditPreview& preview() const { return preview_; }
  const EditDistances& distances() const { return distances_; }

 private:
  // What is beside the form.
  enum class Side { file, walks, preview, distances };
  void read();
  void follow();
  void draw_head(const Ui& ui, const study::Texts& words, const Box& box);
  std::string notice(const study::Texts& words) const;
  float draw_notice(const Ui& ui, const study::Texts& words, const Box& box);
  float draw_answers(const Ui& ui, const study::Texts& words, const Box& row);
  void draw_right(const FormPass& pass, const Box& box);
  void draw_file(const FormPass& pass, const Box& box);
  void draw_motions(const FormPass& pass, const Box& box);
  void draw_trouble(const Ui& ui, const study::Texts& words, const Box& room);
  void hear_keys();
  void go_back(bool again);
  std::string state_key() const;
  const std::vector<PlacedProblem>& problems() const;

  std::string file_, trouble_;
  std::optional<study::StudyDraft> draft_;
  EditOptions options_;
  EditForm form_;
  EditFileView file_view_;
  EditLine line_;
  EditFigures figures_;
  EditWalks walks_;
  EditPreview preview_;
  EditDistances distances_;
  std::shared_ptr<const StudyCheck> check_;
  std::shared_ptr<const study::StudyBundle> bundle_;  // the last without errors; null: none yet
  std::vector<std::string> shown_;
  Side side_ = Side::file;
  int followed_ = -1;  // the version of the draft that the options and words are of
  std::int64_t now_us_ = 0, looked_us_ = 0;
  SaveReport saved_;
  std::unique_ptr<StudyChecker> checker_;
};

}  // namespace promenade::app
