#include "motion/graph/footed_take.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

constexpr double most_inside_s = 0.1;

// How far a frame is inside of one stance.
double inside(const Stance& stance, double frame, double last) {
  const double since = stance.on <= 0 ? INFINITY : frame - stance.on;
  const double left = stance.off >= last ? INFINITY : stance.off - frame;
  return std::min(since, left);
}

std::vector<double> standing(const Take& take, const std::vector<Stance>& stances) {
  const double most = most_inside_s / take.frame_time;
  std::vector<double> depth(take.poses.size(), -most);
  for (std::size_t f = 0; f < depth.size(); ++f) {
    for (const Stance& stance : stances) {
      const double frames = inside(stance, static_cast<double>(f), take.frames() - 1);
      depth[f] = std::clamp(frames, depth[f], most);
    }
  }
  return depth;
}

}  // namespace

FootedTake make_footed(const Take& take) { return make_footed(take, find_contacts(take)); }

FootedTake make_footed(const Take& take, const FootContacts& contacts) {
  const KneeAxes axes = knee_axes(take);
  return {take,
          {FootedLeg{axes[0], contacts.left_heel, standing(take, contacts.left)},
           FootedLeg{axes[1], contacts.right_heel, standing(take, contacts.right)}},
          frame_gaps(take, axes)};
}

}  // namespace promenade::motion
