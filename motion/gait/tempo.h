// The same way of walking, faster or slower, with all that goes with it in people.
#pragma once

#include "motion/gait/style.h"

namespace promenade::motion::gait {

// `factor` of the speed, about 0.5 to 1.6. Cadence and step length share the change
// (people keep the ratio of the two); quicker walks swing arms, hips and chest more,
// bend elbows and the loaded knee more, strike and push off steeper, lean into it, stand
// shorter and sway less. The character's pace follows.
GaitStyle at_tempo(GaitStyle style, double factor);

}  // namespace promenade::motion::gait
