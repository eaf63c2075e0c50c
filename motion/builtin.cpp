#include "motion/builtin.h"

#include "motion/canonical.h"
#include "motion/gait/styles.h"
#include "motion/gait/walk.h"

namespace promenade::motion {
namespace {

Cycle walked(const MotionSet& set, const gait::GaitStyle& style) {
  const gait::Walk walk = gait::make_walk(style);
  const double start = gait::first_toe_off(style);
  const double length = gait::stride_seconds(style);
  Cycle cycle = canonical_cycle(set, gait::walking_keytimes(style), [&](double seconds) {
    return gait::walking_pose(walk, start + seconds / length);
  });
  cycle.name = style.name;
  cycle.style = style.name;
  cycle.source = "generated";
  return cycle;
}

MotionSet set_a() {
  MotionSet set;
  set.name = "A";
  set.credit = "made by Promenade";
  set.skeleton = gait::make_skeleton();
  set.body = gait::make_body_map(set.skeleton);
  for (const gait::GaitStyle& style : gait::styles_of_set_a()) {
    set.cycles.push_back(walked(set, style));
  }
  return set;
}

}  // namespace

std::optional<MotionSet> builtin_set(std::string_view name) {
  if (name == "A") return set_a();
  return std::nullopt;
}

}  // namespace promenade::motion
