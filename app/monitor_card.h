// The card of one session that is watched: who, what they do now, D over time with its
// threshold, a ring for the time left, and how far they are.
#pragma once

#include "app/widgets.h"
#include "study/texts.h"
#include "study/watch.h"

namespace promenade::app {

struct CardLook {
  bool chosen = false;      // what is asked for goes to this one
  bool can_resume = false;  // there is a button to go on with it, so that nothing is advised
};

// `box`: at least 120 high at 1280 x 720. In a low one the plot has no axis and notes are left out.
void draw_session_card(const Ui& ui, const study::Texts& texts,
                       const study::WatchedSession& session, const Box& box,
                       const CardLook& look = {});

}  // namespace promenade::app
