#include "app/desk/amend_box.h"

namespace promenade::app {

void AmendBox::draw(const Ui& ui, const study::Texts& words, Column& column, const OpenStudy& study,
                    DeskServices& services, std::int64_t now_us) {
  const StudyReading* const reading = study.reading();
  if (reading == nullptr || !reading->amendment_due) return;
  const bool pilots = reading->only_pilots;
  column.words(ui.look.fonts.text, ui.look.palette.text,
               words(pilots ? "shell.amend_pilots" : "shell.amend_says"), 8);
  if (reason_.text.words().empty() && pilots && !reason_.active && !reason_.begun) {
    reason_.begun = true;
    reason_.text.set(words("shell.amend_pilot_reason"));
  }
  text_box(ui, "amend.reason", column.take(40), reason_,
           {.most = 300, .several = false, .hint = words("shell.amend_hint").c_str()}, now_us);
  const std::string reason = reason_.text.words();
  const bool pressed = button(ui, "amend", column.take(40, 16), words("shell.amend"),
                              ButtonKind::outlined, !reason.empty());
  if (reason.empty() || !(pressed || reason_.entered)) return;
  const study::StudyPlace& place = study.place();
  services.jobs.start(words("shell.amending"),
                      {"amend", place.sessions(), place.file(), "--reason", reason});
  reason_ = {};
}

}  // namespace promenade::app
