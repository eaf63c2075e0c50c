// A study file while it is edited: its text, the way back, and what became of the file on disk
// meanwhile. The file stays the truth: what somebody else wrote there is read again when nothing
// was changed here, and is never written over unasked. Nothing is lost: every text that this draft
// ever had, and every one that it found on disk, is a step that undo goes back to. Knows no window.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/file_stamp.h"
#include "study/toml_edit.h"
#include "study/toml_spans.h"

namespace promenade::study {

class StudyDraft {
 public:
  enum class Disk {
    same,    // as it was read or written last
    reread,  // it was changed outside, nothing here: the draft is what it says now
    both,    // it was changed outside, and the draft was changed, too
    gone     // there is no such file any more
  };

  // Reads it. Throws InputError when it cannot be read.
  explicit StudyDraft(std::string file);

  const std::string& file() const { return file_; }
  const std::string& text() const { return text_; }
  // Of the text as it is now; an empty table when it is no TOML.
  const TomlValue& root() const { return root_; }
  const TomlSpans& spans() const { return spans_; }
  bool is_toml() const { return trouble_.empty(); }
  const std::string& trouble() const { return trouble_; }  // why it is no TOML
  int version() const { return version_; }                 // another number for another text
  bool saved() const { return text_ == on_disk_ && disk_ != Disk::gone; }
  Disk disk() const { return disk_; }

  // Changes that make one step of undo have the same `gesture`, a word of the caller's, and come
  // one after the other; empty: a step of its own. False: refused, and refusal() says why.
  bool change(const TomlEdit& edit, std::string_view gesture = {});
  bool change(const std::vector<TomlEdit>& edits, std::string_view gesture = {});
  void write(std::string text, std::string_view gesture = {});
  void end_gesture() { gesture_.clear(); }
  const std::string& refusal() const { return refusal_; }  // of the last change
  void forget_refusal() { refusal_.clear(); }

  bool can_undo() const { return !undo_.empty(); }
  bool can_redo() const { return !redo_.empty(); }
  void undo();
  void redo();

  // Looks at the file on disk; true: there is news.
  bool look();
  void seen();  // the notice of a file that was read again has been read
  // Where both were changed: the file's text, or the draft's. The other one is a step back.
  void take_the_files();
  void keep_mine();
  // Writes beside the file and renames. False: the file was changed meanwhile. Throws OutsideError.
  bool save();

 private:
  void show(std::string text);
  void push(std::string_view gesture);

  std::string file_, text_, on_disk_, theirs_, gesture_, refusal_, trouble_;
  std::vector<std::string> undo_, redo_;
  TomlValue root_;
  TomlSpans spans_;
  FileStamp stamp_;
  Disk disk_ = Disk::same;
  int version_ = 0;
};

}  // namespace promenade::study
