#include "study/study_draft.h"

#include <utility>

#include "motion/files.h"
#include "motion/problem.h"
#include "study/toml_parse.h"

namespace promenade::study {
namespace {

constexpr std::size_t most_steps = 1000;

}  // namespace

StudyDraft::StudyDraft(std::string file) : file_(std::move(file)) {
  stamp_ = file_stamp(file_);
  on_disk_ = read_file(file_);
  show(on_disk_);
}

void StudyDraft::show(std::string text) {
  text_ = std::move(text);
  spans_ = scan_toml(text_);
  trouble_.clear();
  ++version_;
  try {
    root_ = parse_toml(file_, text_);
  } catch (const InputError& error) {
    root_ = {};
    trouble_ = error.problems().front().message;
  }
}

void StudyDraft::push(std::string_view gesture) {
  const bool goes_on = !gesture.empty() && gesture == gesture_ && redo_.empty();
  gesture_ = gesture;
  redo_.clear();
  if (goes_on) return;
  undo_.push_back(text_);
  if (undo_.size() > most_steps) undo_.erase(undo_.begin());
}

bool StudyDraft::change(const TomlEdit& edit, std::string_view gesture) {
  return change(std::vector{edit}, gesture);
}

bool StudyDraft::change(const std::vector<TomlEdit>& edits, std::string_view gesture) {
  refusal_.clear();
  std::string text = text_;
  try {
    for (const TomlEdit& edit : edits) text = edited_toml(file_, text, edit);
  } catch (const InputError& error) {
    refusal_ = error.problems().front().message;
    return false;
  }
  write(std::move(text), gesture);
  return true;
}

void StudyDraft::write(std::string text, std::string_view gesture) {
  if (text == text_) return;
  push(gesture);
  show(std::move(text));
}

void StudyDraft::undo() {
  if (undo_.empty()) return;
  redo_.push_back(text_);
  show(std::move(undo_.back()));
  undo_.pop_back();
  end_gesture();
}

void StudyDraft::redo() {
  if (redo_.empty()) return;
  undo_.push_back(text_);
  show(std::move(redo_.back()));
  redo_.pop_back();
  end_gesture();
}

bool StudyDraft::look() {
  const FileStamp now = file_stamp(file_);
  if (now == stamp_) return false;
  stamp_ = now;
  if (now.file == 0) {
    disk_ = Disk::gone;
    return true;
  }
  std::string found;
  try {
    found = read_file(file_);
  } catch (const InputError&) {
    stamp_ = {};  // it is being replaced: looked at again next time
    return false;
  }
  const bool was_gone = disk_ == Disk::gone;
  const bool changed_here = text_ != on_disk_;
  if (found == on_disk_ || found == text_) {
    const bool news = was_gone || disk_ == Disk::both;
    on_disk_ = std::move(found);
    disk_ = Disk::same;
    return news;
  }
  if (changed_here) {
    theirs_ = std::move(found);
    disk_ = Disk::both;
    return true;
  }
  push({});
  on_disk_ = found;
  show(std::move(found));
  disk_ = Disk::reread;
  return true;
}

void StudyDraft::seen() {
  if (disk_ == Disk::reread) disk_ = Disk::same;
}

void StudyDraft::take_the_files() {
  if (disk_ != Disk::both) return;
  push({});
  on_disk_ = theirs_;
  show(std::exchange(theirs_, {}));
  disk_ = Disk::same;
}

void StudyDraft::keep_mine() {
  if (disk_ != Disk::both) return;
  undo_.push_back(theirs_);
  end_gesture();
  on_disk_ = std::exchange(theirs_, {});
  disk_ = Disk::same;
}

bool StudyDraft::save() {
  look();
  if (disk_ == Disk::both) return false;
  write_file(file_, text_);
  on_disk_ = text_;
  stamp_ = file_stamp(file_);
  disk_ = Disk::same;
  end_gesture();
  return true;
}

}  // namespace promenade::study
