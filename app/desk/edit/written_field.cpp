#include "app/desk/edit/written_field.h"

namespace promenade::app {

void WrittenField::accept(std::string shown) {
  shown_ = std::move(shown);
  refused_ = false;
}

// What the value is now, unless it is what was just written here.
void WrittenField::follow(const Ui& ui, const Look& look) {
  left_ = active_ && !draft_.active;
  active_ = draft_.active;
  const bool untidy = !draft_.active && !refused_ && !look.keeps && words() != look.shown;
  if (!fresh_ && shown_ == look.shown && !untidy) return;
  fresh_ = refused_ = false;
  shown_ = look.shown;
  draft_.text.set(look.shown);
  if (!draft_.active) return;
  ++generation_;
  draft_.active = active_ = false;
  ui.focus.write_in("type", look.target);
}

bool WrittenField::draw(const Ui& ui, const Box& box, const Look& look, std::int64_t now_us) {
  constexpr int longest_line = 400;
  constexpr int longest_page = 8000;
  follow(ui, look);
  ImGui::PushID(generation_);
  text_box(ui, look.target, box, draft_,
           {.most = (look.several ? longest_page : longest_line) + static_cast<int>(shown_.size()),
            .several = look.several,
            .hint = look.hint.c_str()},
           now_us);
  ImGui::PopID();
  if (refused_) frame(box, ui.look.palette.alarm, ui.layout.size(2));
  return draft_.changed;
}

}  // namespace promenade::app
