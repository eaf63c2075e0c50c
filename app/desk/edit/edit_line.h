// One line of the study file, to be written by hand: for keys that the form does not have, remarks,
// and files that cannot be read as they are. It is taken over by Enter, or when the keyboard
// leaves.
#pragma once

#include "app/desk/edit/edit_controls.h"

namespace promenade::app {

class EditLine {
 public:
  // `line`: from 1. True: the file was changed.
  bool draw(const FormPass& pass, const Box& box, int line);
  // Without waiting for either. True: the file was changed.
  bool take(study::StudyDraft& draft);
  // Something is written here that is not in the file yet.
  bool differs(const study::StudyDraft& draft) const;

 private:
  bool waits(const study::StudyDraft& draft) const;
  WrittenField field_;
  int written_ = 0;  // the line in which something was written that is not taken over yet; 0: none
  std::string before_;  // what stood in it
};

}  // namespace promenade::app
