// A text box about a value that lives elsewhere: what is written is told, and what becomes of the
// value meanwhile (undo, a file that is read again) comes into the box, even while somebody writes.
// What is no value stays in the box, marked, until something else is written.
#pragma once

#include <string>

#include "app/text_box.h"

namespace promenade::app {

class WrittenField {
 public:
  struct Look {
    std::string target;  // "type" `target`
    std::string shown;   // the value as it is now
    std::string hint;    // in the empty box
    bool several = false;
    bool keeps = false;  // what is written stays, whether it was accepted or not
  };
  // True: it was changed by hand, to words(). Answer with accept() or refuse().
  bool draw(const Ui& ui, const Box& box, const Look& look, std::int64_t now_us);
  const std::string& words() const { return draft_.text.words(); }
  void accept(std::string shown);  // the value as it is shown after the change
  void refuse() { refused_ = true; }
  bool refused() const { return refused_; }
  bool left() const { return left_; }  // the keyboard has just gone elsewhere
  void hide() { active_ = draft_.active = false; }

 private:
  void follow(const Ui& ui, const Look& look);

  Draft draft_;
  std::string shown_;
  bool fresh_ = true, active_ = false, refused_ = false, left_ = false;
  int generation_ = 0;  // another one takes what is written out of Dear ImGui's hands
};

}  // namespace promenade::app
