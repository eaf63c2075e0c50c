// Shown where a session could begin, while the study is another one than its sessions had: why was
// it changed? Only then `promenade amend` lets it go on.
#pragma once

#include "app/desk/column.h"
#include "app/desk/open_study.h"
#include "app/desk/services.h"
#include "app/text_box.h"
#include "study/texts.h"

namespace promenade::app {

class AmendBox {
 public:
  // Takes room only while an amendment is due. "type" "amend.reason", "press" "amend".
  void draw(const Ui& ui, const study::Texts& words, Column& column, const OpenStudy& study,
            DeskServices& services, std::int64_t now_us);

 private:
  Draft reason_;
};

}  // namespace promenade::app
