// What holds for every walk of every built-in set.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <ostream>
#include <set>

#include "motion/builtin.h"
#include "motion/distance.h"
#include "motion/gait/families.h"
#include "motion/models/map.h"
#include "motion/models/ward.h"
#include "tests/motion/walk_measures.h"

namespace promenade::motion {
namespace {

constexpr SideJoints sides[] = {right_side, left_side};

const MotionSet& made(const std::string& name) {
  static std::map<std::string, MotionSet> sets;
  const auto found = sets.find(name);
  return found != sets.end() ? found->second
                             : sets.emplace(name, builtin_set(name).value()).first->second;
}

struct Expected {
  const char* name;
  int cycles;
  std::uint64_t hash;
};

void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.name; }

class EveryBuiltinSet : public testing::TestWithParam<Expected> {
 protected:
  const MotionSet& set() const { return made(GetParam().name); }

  // check(walk, side, name of the walk) for every walk and side.
  template <class Check>
  void for_every_side(Check check) const {
    for (const Cycle& cycle : set().cycles) {
      const WalkMeasures walk(set(), cycle);
      for (const SideJoints& side : sides) {
        check(walk, side, cycle.name + (side.hip == left_hip ? " left" : " right"));
      }
    }
  }
};

TEST_P(EveryBuiltinSet, HasItsWalksWithNamesOfTheirOwn) {
  ASSERT_EQ(set().size(), GetParam().cycles);
  for (int i = 0; i < set().size(); ++i) {
    const Cycle& cycle = set().cycles[static_cast<std::size_t>(i)];
    EXPECT_EQ(find_cycle(set(), cycle.name), i);
    EXPECT_EQ(cycle.source, "generated");
    EXPECT_NEAR(cycle.velocity.x(), 0, 1e-12) << cycle.name;
    EXPECT_TRUE(std::is_sorted(cycle.keytimes.begin(), cycle.keytimes.end(), std::less_equal<>()));
  }
}

// Where the foot bears: exact on the 60 phases. Between them pose_at interpolates the
// joints on a chord: the arc of the foot about the knee or the hip is missed by
// r a^2 / 8 for an angle a between phases. The quickest stance motion is 7 rad/s at
// the knee before toe off: a = 7 x 0.018 s, r = 0.45 m, which makes 0.9 mm.
TEST_P(EveryBuiltinSet, KeepsTheBearingPointOfEachFootWithinAMillimetre) {
  for_every_side([](const WalkMeasures& walk, const SideJoints& side, const std::string& name) {
    EXPECT_LT(walk.slide(side), 0.001) << name;
  });
}

TEST_P(EveryBuiltinSet, NeverSinksIntoTheGround) {
  for_every_side([](const WalkMeasures& walk, const SideJoints& side, const std::string& name) {
    const auto lowest = [&](const WorldPose& world) { return walk.lowest(world, side); };
    EXPECT_GT(walk.range(side, 0, 1, lowest).least, -0.001) << name;
    EXPECT_GT(walk.range(side, 0.68, 0.94, lowest).least, 0.004) << name;
  });
}

// Ankles reach 40 degrees of dorsiflexion and more under load with a bent knee
// (weight-bearing lunge test), 50 of plantarflexion; knees and elbows do not overstretch.
TEST_P(EveryBuiltinSet, BendsLegsAsPeopleCan) {
  for_every_side([](const WalkMeasures& walk, const SideJoints& side, const std::string& name) {
    Range knee, ankle, hip;
    walk.range(side, 0, 1, [&](const WorldPose& world) {
      knee.add(walk.knee_flexion(world, side));
      ankle.add(walk.dorsiflexion(world, side));
      hip.add(walk.hip_flexion(world, side));
      return 0.0;
    });
    EXPECT_TRUE(knee.least > 4 && knee.most < 90) << name << knee.least << " " << knee.most;
    EXPECT_TRUE(ankle.least > -40 && ankle.most < 43) << name << ankle.least << " " << ankle.most;
    EXPECT_TRUE(hip.least > -30 && hip.most < 55) << name << hip.least << " " << hip.most;
  });
}

// The trunk is 9 cm deep from its axis; a hand on the hip touches it.
TEST_P(EveryBuiltinSet, BendsElbowsAsPeopleCanAndKeepsHandsOutOfTheBody) {
  for_every_side([](const WalkMeasures& walk, const SideJoints& side, const std::string& name) {
    Range elbow, hand;
    walk.range(side, 0, 1, [&](const WorldPose& world) {
      elbow.add(walk.elbow_flexion(world, side));
      hand.add(walk.hand_from_trunk(world, side));
      return 0.0;
    });
    EXPECT_TRUE(elbow.least > 0 && elbow.most < 140) << name << elbow.least << " " << elbow.most;
    EXPECT_GT(hand.least, 0.09) << name;
  });
}

// A velocity that jumps would show as a second difference that grows with the
// sampling rate; at the knees, heel strike makes up to ten times gravity.
TEST_P(EveryBuiltinSet, MovesWithoutJerksAndClosesItsLoop) {
  for (const Cycle& cycle : set().cycles) {
    EXPECT_LT(WalkMeasures(set(), cycle).acceleration(), 100) << cycle.name;
  }
}

// The least D at which two strips of eight figures are told apart at a glance.
TEST_P(EveryBuiltinSet, HasNoTwoWalksThatLookAlike) {
  std::vector<DistancePoints, Eigen::aligned_allocator<DistancePoints>> points;
  for (const Cycle& cycle : set().cycles) points.push_back(distance_points(set(), cycle));
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_GT(distance(points[a], points[b]).mean_m, 0.025)
          << set().cycles[a].name << " and " << set().cycles[b].name;
    }
  }
}

TEST_P(EveryBuiltinSet, SaysHowEveryWalkWasMeant) {
  const std::vector<StyleCharacter> characters = builtin_characters(GetParam().name);
  ASSERT_EQ(characters.size(), set().cycles.size());
  for (const StyleCharacter& c : characters) {
    for (const double quality : {c.valence, c.arousal, c.pace, c.openness, c.weight, c.steadiness,
                                 c.tension, c.youth, c.naturalness}) {
      EXPECT_LE(std::abs(quality), 1);
    }
  }
}

TEST_P(EveryBuiltinSet, IsTheSameEveryTimeAndEverywhere) {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a over values rounded to 1e-6
  const auto add = [&](double value) {
    hash = (hash ^ static_cast<std::uint64_t>(std::llround(value * 1e6))) * 1099511628211u;
  };
  for (const Cycle& cycle : set().cycles) {
    for (const double time : cycle.keytimes) add(time);
    for (const double value : cycle.root.reshaped()) add(value);
    for (const double value : cycle.rotations.reshaped()) add(value);
  }
  EXPECT_EQ(hash, GetParam().hash);
}

INSTANTIATE_TEST_SUITE_P(Builtin, EveryBuiltinSet,
                         testing::Values(Expected{"A", 10, 2467690565477578387u},
                                         Expected{"B", 27, 2544009100674449706u},
                                         Expected{"N", 55, 16855552599906651961u}),
                         [](const auto& suite) { return std::string(suite.param.name); });

TEST(BuiltinSets, AreThereUnderTheirNamesOnly) {
  for (const char* name : {"", "a", "C", "AB"}) {
    EXPECT_FALSE(builtin_set(name).has_value());
    EXPECT_TRUE(builtin_characters(name).empty());
  }
}

TEST(SetB, WalksEachEmotionAtThreeSpeeds) {
  const MotionSet& set = made("B");
  std::map<std::string, std::vector<const Cycle*>> emotions;
  for (const Cycle& cycle : set.cycles) emotions[cycle.style].push_back(&cycle);
  EXPECT_EQ(emotions.size(), 9);
  for (const auto& [emotion, walks] : emotions) {
    ASSERT_EQ(walks.size(), 3);
    EXPECT_EQ(walks[0]->name, emotion + "-fast");
    EXPECT_EQ(walks[2]->name, emotion + "-slow");
    EXPECT_GT(walks[0]->velocity.y(), 1.25 * walks[1]->velocity.y());
    EXPECT_LT(walks[2]->velocity.y(), 0.75 * walks[1]->velocity.y());
    EXPECT_LT(walks[0]->seconds, walks[1]->seconds);
  }
}

// The slow stand longer and the fast shorter ("the slow walk with longer double
// support"): the share of the stride in which the right foot swings falls from fast to slow.
TEST(SetB, StandsLongerWhenItWalksSlower) {
  const MotionSet& set = made("B");
  const auto swing = [](const Cycle& cycle) { return cycle.keytimes[1] / cycle.seconds; };
  for (std::size_t i = 0; i < set.cycles.size(); i += 3) {
    EXPECT_GT(swing(set.cycles[i]), swing(set.cycles[i + 1]));
    EXPECT_GT(swing(set.cycles[i + 1]), swing(set.cycles[i + 2]));
  }
}

TEST(SetN, FallsIntoItsThreeFamiliesOnTheMap) {
  const Minimap map = make_minimap(principal_components(make_motion_space(made("N"))));
  const std::vector<int> labels = cut(ward(map.examples), 3);
  std::set<std::pair<std::string, int>> pairs;
  const std::vector<gait::GaitStyle> styles = gait::styles_of_set_n();
  for (std::size_t i = 0; i < styles.size(); ++i) pairs.emplace(styles[i].family, labels[i]);
  EXPECT_EQ(pairs.size(), 3);
}

// As k-means sees it: every walk is much nearer to the centre of its own family than to
// that of another.
TEST(SetN, LiesNearTheCentreOfItsFamily) {
  const Minimap map = make_minimap(principal_components(make_motion_space(made("N"))));
  const std::vector<gait::GaitStyle> styles = gait::styles_of_set_n();
  std::map<std::string, Eigen::Vector3d> sums;  // x, y, and how many
  for (std::size_t i = 0; i < styles.size(); ++i) {
    auto& sum = sums.try_emplace(styles[i].family, Eigen::Vector3d::Zero()).first->second;
    sum += map.examples.col(static_cast<int>(i)).homogeneous();
  }
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const auto to = [&](const std::string& family) {
      return (map.examples.col(static_cast<int>(i)) - sums[family].hnormalized()).norm();
    };
    for (const auto& [family, sum] : sums) {
      if (family == styles[i].family) continue;
      EXPECT_LT(to(styles[i].family), 0.8 * to(family)) << styles[i].name;
    }
  }
}

}  // namespace
}  // namespace promenade::motion
