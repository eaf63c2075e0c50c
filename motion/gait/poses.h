// What only one style does: whatever it holds, hurts or looks at. Applied last.
#pragma once

#include "motion/gait/style.h"

namespace promenade::motion::gait {

// The right leg hurts: the body hurries over it, leans over it and does not push off.
void limp(GaitStyle& style);

// One hand on a stick, the other arm close to the body; limps.
void with_a_stick(GaitStyle& style);

// A heavy bag in the right hand, the left arm out against it.
void with_a_bag(GaitStyle& style);

void with_hands_in_pockets(GaitStyle& style);
void with_crossed_arms(GaitStyle& style);
void with_arms_ahead(GaitStyle& style);
// As who has just learned to walk: ready to fall.
void with_hands_up(GaitStyle& style);

void with_folded_hands(GaitStyle& style);
void looking_around(GaitStyle& style);
void like_a_machine(GaitStyle& style);
void lost_in_thought(GaitStyle& style);

}  // namespace promenade::motion::gait
