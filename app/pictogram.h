// Tiny stick figures that show which part of the body is meant, and which way it goes.
// They are drawn from the side, walking to the right, or from behind, so that left is left.
#pragma once

#include <string_view>

#include "app/box.h"
#include "app/look.h"

namespace promenade::app {

struct Pictogram {
  // Bits of `parts`.
  enum Part : unsigned {
    head = 1U << 0,
    torso = 1U << 1,
    left_upper_arm = 1U << 2,
    right_upper_arm = 1U << 3,
    left_forearm = 1U << 4,
    right_forearm = 1U << 5,
    left_thigh = 1U << 6,
    right_thigh = 1U << 7,
    left_shin = 1U << 8,
    right_shin = 1U << 9,
    left_foot = 1U << 10,
    right_foot = 1U << 11,
    centre = 1U << 12,  // of mass
    clock = 1U << 13,   // no figure: a duration
  };
  enum class View { side, back };
  enum class Arrow { across, up, none };

  unsigned parts = 0;  // 0: there is no pictogram
  View view = View::side;
  Arrow arrow = Arrow::none;
};

// Of a feature of motion/models/features.h, by its name.
Pictogram feature_pictogram(std::string_view feature);

void draw_pictogram(const Box& box, const Pictogram& pictogram, const Palette& palette);

}  // namespace promenade::app
