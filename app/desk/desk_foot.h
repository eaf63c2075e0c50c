// The foot of the desk: what runs beside, how far it is, and what became of it.
#pragma once

#include "app/desk/services.h"
#include "app/widgets.h"
#include "study/texts.h"

namespace promenade::app {

// Has "press" "job.stop" while it runs, and "job.close" when it has ended.
void draw_desk_foot(const Ui& ui, const study::Texts& words, DeskJobs& jobs, const Box& bar);

// What to say of a command that ended badly: its last sentence, without its own name or a path
// before it.
std::string last_sentence(const std::string& messages);

}  // namespace promenade::app
