#include "motion/graph/footed_take.h"

#include <gtest/gtest.h>

#include "tests/motion/walker.h"

namespace promenade::motion {
namespace {

const Take& walker() {
  static const Take take = [] {
    const MotionSet set = builtin_set("A").value();
    return walker_take(set, set.cycles[0], 3);
  }();
  return take;
}

TEST(FootedTake, IsInsideOfAStanceWhereAndAsFarAsContactsSay) {
  FootContacts contacts = find_contacts(walker());
  contacts.left = {{20.5, 60, 24}};
  const FootedTake footed = make_footed(walker(), contacts);
  const FootedLeg& leg = footed.legs[0];
  EXPECT_NEAR(leg.standing[21], 0.5, 1e-12);
  EXPECT_NEAR(leg.standing[20], -0.5, 1e-12);
  EXPECT_NEAR(leg.standing[58], 2, 1e-12);
  EXPECT_NEAR(leg.still[21], -3, 1e-12) << "it lands";
  EXPECT_NEAR(leg.standing[40], 0.1 / walker().frame_time, 1e-12) << "no more than that";
  EXPECT_NEAR(leg.standing[100], -0.1 / walker().frame_time, 1e-12);
}

TEST(FootedTake, KnowsNoEndOfAStanceThatTheTakeCuts) {
  FootContacts contacts = find_contacts(walker());
  const double last = walker().frames() - 1;
  contacts.right = {{0, 10, 0}, {last - 10, last, last - 10}};
  const FootedTake footed = make_footed(walker(), contacts);
  const FootedLeg& leg = footed.legs[1];
  EXPECT_NEAR(leg.standing.front(), 0.1 / walker().frame_time, 1e-12);
  EXPECT_NEAR(leg.standing.back(), 0.1 / walker().frame_time, 1e-12);
  EXPECT_NEAR(leg.standing[8], 2, 1e-12);
}

// A generated walker stands by its heel, flat, and by its toe in turn, and stays there.
TEST(FootedTake, FindsWhatAFootStandsBy) {
  const FootContacts contacts = find_contacts(walker());
  const FootedTake footed = make_footed(walker(), contacts);
  const Stance& stance = contacts.right[1];
  const FootedLeg& leg = footed.legs[1];
  EXPECT_EQ(leg.support[static_cast<std::size_t>(stance.off) - 2], Support::toe);
  for (int f = static_cast<int>(stance.still) + 1; f + 1 < stance.off; ++f) {
    EXPECT_LT(leg.steps.col(f).norm(), 0.003) << f;
  }
}

}  // namespace
}  // namespace promenade::motion
