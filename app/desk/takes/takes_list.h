// The takes at the left of their page: how more of them come, what was guessed of their unit, and
// a row for each with a chip. What failed stands first.
#pragma once

#include "app/desk/takes/takes_chip.h"
#include "app/desk/takes/takes_work.h"
#include "app/file_list.h"
#include "app/text_box.h"

namespace promenade::app {

class TakesList {
 public:
  explicit TakesList(TakesWork& work);

  void draw(const Ui& ui, const study::Texts& words, const Box& box, std::int64_t now_us);
  // The folders in the place of the figures, while somebody looks for captures.
  bool browsing() const { return browsing_; }
  void draw_folders(const Ui& ui, const study::Texts& words, const Box& box);
  void browse(bool on) { browsing_ = on; }
  const FileList& folders() const { return files_; }
  const std::string& path() const { return path_.text.words(); }  // as it is being written
  const std::vector<std::string>& names();                        // of the takes, short

 private:
  void take_path();
  void draw_unit(const Ui& ui, const study::Texts& words, Box& left);
  void draw_rows(const Ui& ui, const study::Texts& words, const Box& box);
  void draw_row(const Ui& ui, const study::Texts& words, const Box& box, std::size_t take);
  void move_by_key(const Ui& ui);

  TakesWork& work_;
  Draft path_;
  FileList files_;
  bool browsing_ = false;
  std::vector<std::string> names_;
  int named_ = -1;  // the revision of the workshop that they are of
};

}  // namespace promenade::app
