#include "motion/foot_contacts.h"

#include <gtest/gtest.h>

#include "tests/motion/walker.h"

namespace promenade::motion {
namespace {

// Four cycles of a generated walker, of which it is known when its feet are down.
Take recorded(const MotionSet& set, const Cycle& cycle) { return walker_take(set, cycle, 4); }

// Every second frame only.
Take half_the_rate(Take take) {
  for (std::size_t f = 0; 2 * f < take.poses.size(); ++f) take.poses[f] = take.poses[2 * f];
  take.poses.resize((take.poses.size() + 1) / 2);
  take.frame_time *= 2;
  return take;
}

// Seconds between a time and the nearest of the landings, or leavings, of a foot.
double gap(const Take& take, const std::vector<Stance>& foot, double Stance::*moment,
           double seconds) {
  double least = INFINITY;
  for (const Stance& stance : foot) {
    least = std::min(least, std::abs(stance.*moment * take.frame_time - seconds));
  }
  return least;
}

TEST(FootContacts, BeginWhenTheHeelStrikesAndEndWhenTheToeLeaves) {
  const MotionSet set = builtin_set("A").value();
  for (const Cycle& cycle : set.cycles) {
    const Take take = recorded(set, cycle);
    const FootContacts found = find_contacts(take);
    const std::vector<double>& keys = cycle.keytimes;
    const double later = cycle.seconds;
    // One frame is 17 ms, and the heel is known to a centimetre.
    EXPECT_LT(gap(take, found.right, &Stance::on, later + keys[1]), 0.02) << cycle.name;
    EXPECT_LT(gap(take, found.left, &Stance::on, later + keys[3]), 0.02) << cycle.name;
    EXPECT_LT(gap(take, found.right, &Stance::off, later + keys[4]), 0.02) << cycle.name;
    EXPECT_LT(gap(take, found.left, &Stance::off, later + keys[2]), 0.02) << cycle.name;
  }
}

TEST(FootContacts, AreFoundAtThirtyFramesASecondToo) {
  const MotionSet set = builtin_set("A").value();
  for (const Cycle& cycle : set.cycles) {
    const Take take = half_the_rate(recorded(set, cycle));
    const FootContacts found = find_contacts(take);
    const std::vector<double>& keys = cycle.keytimes;
    EXPECT_LT(gap(take, found.right, &Stance::on, cycle.seconds + keys[1]), 0.025) << cycle.name;
    EXPECT_LT(gap(take, found.left, &Stance::off, cycle.seconds + keys[2]), 0.025) << cycle.name;
  }
}

// The floor of a capture that is tilted by 1 %: all is as before, but for the foot that
// comes down from above the slope behind it (2 cm/s: 40 ms at the most).
TEST(FootContacts, AreFoundOnAFloorThatIsNotLevel) {
  const MotionSet set = builtin_set("A").value();
  for (const Cycle& cycle : set.cycles) {
    Take take = recorded(set, cycle);
    for (Pose& pose : take.poses) pose.root.y() += 0.01 * pose.root.z();
    const FootContacts found = find_contacts(take);
    const std::vector<double>& keys = cycle.keytimes;
    EXPECT_LT(gap(take, found.right, &Stance::on, cycle.seconds + keys[1]), 0.045) << cycle.name;
    EXPECT_LT(gap(take, found.right, &Stance::off, cycle.seconds + keys[4]), 0.025) << cycle.name;
  }
}

TEST(FootContacts, ComeOnceACycleForEachFoot) {
  const MotionSet set = builtin_set("A").value();
  for (const Cycle& cycle : set.cycles) {
    const FootContacts found = find_contacts(recorded(set, cycle));
    EXPECT_NEAR(static_cast<double>(found.left.size()), 4.5, 0.5) << cycle.name;
    EXPECT_NEAR(static_cast<double>(found.right.size()), 4.5, 0.5) << cycle.name;
  }
}

TEST(FootContacts, LandBeforeTheyAreStill) {
  const MotionSet set = builtin_set("A").value();
  int landing = 0;
  for (const Cycle& cycle : set.cycles) {
    for (const Stance& stance : find_contacts(recorded(set, cycle)).left) {
      EXPECT_LE(stance.on, stance.still) << cycle.name;
      EXPECT_LT(stance.still, stance.off) << cycle.name;
      if (stance.on < stance.still) ++landing;
    }
  }
  EXPECT_GT(landing, 10);
}

}  // namespace
}  // namespace promenade::motion
