#include "motion/gait/tempo.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion::gait {
namespace {

void swing_faster(Arms& arms, double factor) {
  const double more = factor - 1;
  arms.swing *= std::pow(factor, 1.2);
  arms.elbow_swing *= std::pow(factor, 1.2);
  arms.elbow += 36 * more;
  arms.centre += 4 * more;
}

}  // namespace

GaitStyle at_tempo(GaitStyle style, double factor) {
  const double more = factor - 1;
  Timing& timing = style.timing;
  timing.speed *= factor;
  timing.cadence *= std::pow(factor, 0.45);
  timing.stance -= 0.08 * more;
  timing.heel_off -= 0.10 * more;
  const double step = std::pow(factor, 0.55);
  style.feet.strike_pitch *= step;
  style.feet.push_off_pitch = std::min(70.0, style.feet.push_off_pitch * step);
  style.feet.lift *= step;
  style.knees.loading += 10 * more;
  style.pelvis.rotation *= factor;
  style.pelvis.list *= step;
  style.pelvis.sway /= step;
  style.trunk.rotation *= factor;
  style.trunk.lean += 10 * more;
  style.head.pitch -= 10 * more;
  swing_faster(style.arms, factor);
  if (style.left_arm) swing_faster(*style.left_arm, factor);
  style.character.pace = std::clamp(style.character.pace + 1.6 * more, -1.0, 1.0);
  return style;
}

}  // namespace promenade::motion::gait
