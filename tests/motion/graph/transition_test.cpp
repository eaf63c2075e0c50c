#include "motion/graph/transition.h"

#include <gtest/gtest.h>

#include "motion/angles.h"
#include "tests/motion/graph/matching.h"
#include "tests/motion/walker.h"

namespace promenade::motion {
namespace {

constexpr int window = 20;  // frames; walkers have 60 a second

TEST(WeightOfFirst, FallsFromOneToNothing) {
  EXPECT_EQ(weight_of_first(-1, 10), 1);
  EXPECT_EQ(weight_of_first(4, 10), 0.5);
  EXPECT_EQ(weight_of_first(0, 4), 0.84375);  // 2 / 64 - 3 / 16 + 1
  EXPECT_EQ(weight_of_first(9, 10), 0);
}

TEST(WeightOfFirst, IsHeldBeforeAndBehind) {
  EXPECT_EQ(weight_of_first(-7, 10), 1);
  EXPECT_EQ(weight_of_first(12, 10), 0);
}

TEST(WeightOfFirst, IsTheOthersSeenFromBehind) {
  for (int p = -1; p < 13; ++p) {
    EXPECT_NEAR(weight_of_first(p, 13) + weight_of_first(11 - p, 13), 1, 1e-15) << p;
  }
}

// Three cycles of each style of a built-in set, and what graphs ask of them.
class Walkers {
 public:
  explicit Walkers(const char* name) : set_(builtin_set(name).value()) {
    for (const Cycle& cycle : set_.cycles) takes_.push_back(walker_take(set_, cycle, 3));
    for (const Take& take : takes_) matchable_.emplace_back(take);
  }

  std::size_t size() const { return takes_.size(); }
  const Take& take(std::size_t n) const { return takes_[n]; }
  const Matchable& operator[](std::size_t n) const { return matchable_[n]; }
  const std::string& style(std::size_t n) const { return set_.cycles[n].name; }

  // From frame i of one into the most similar place of the other's second cycle.
  FoundMatch match(std::size_t a, int i, std::size_t b) const {
    return best_match((*this)[a], i, (*this)[b], 60, 135, window);
  }

 private:
  MotionSet set_;
  std::vector<Take> takes_;
  std::vector<Matchable> matchable_;
};

const Walkers& walkers() {
  static const Walkers found("A");
  return found;
}

struct Passed {
  FoundMatch match;
  std::size_t a, b;
  Transition transition;
};

// Into every other style, from several frames of a stride.
std::vector<Passed> make_passages() {
  std::vector<Passed> all;
  for (std::size_t a = 0; a < walkers().size(); ++a) {
    for (std::size_t b = 0; b < walkers().size(); ++b) {
      for (const int i : {50, 66, 82, 98}) {
        const FoundMatch match = walkers().match(a, i, b);
        if (a == b || match.distance.rms() > 0.06) continue;
        all.push_back({match, a, b, transition_of(walkers()[a], walkers()[b], match)});
      }
    }
  }
  return all;
}

const std::vector<Passed>& passages() {
  static const std::vector<Passed> all = make_passages();
  return all;
}

std::vector<Passed> usable_passages() {
  std::vector<Passed> all = passages();
  std::erase_if(all, [](const Passed& passed) { return !passed.transition.refusal.empty(); });
  return all;
}

TEST(Transition, IsUsableBetweenMostStylesThatAreAlike) {
  EXPECT_GE(passages().size(), 30U);
  EXPECT_GE(3 * usable_passages().size(), 2 * passages().size());
}

TEST(Transition, KeepsStandingFeetInPlace) {
  double raw = 0;
  for (const Passed& passed : usable_passages()) {
    EXPECT_LT(passed.transition.quality.slide_m, 0.005)
        << walkers().style(passed.a) << " to " << walkers().style(passed.b);
    raw = std::max(raw, passed.transition.quality.slide_raw_m);
  }
  EXPECT_GT(raw, 0.02) << "there is something to keep";
}

// From two frames before the transition to two after it.
Take seen(const Passed& passed) {
  const auto& [i, j, k] = passed.match.frames;
  Take take = part(walkers().take(passed.a), i - 2, i - 1);
  for (const Pose& pose : passed.transition.poses) take.poses.push_back(pose);
  for (const int f : {j, j + 1}) {
    take.poses.push_back(
        moved(passed.transition.move, walkers().take(passed.b).poses[static_cast<std::size_t>(f)]));
  }
  return take;
}

// Whether a foot is flat or on its toe from one frame to another; in the first third of a stance
// it turns about its heel.
bool stands(const Take& take, Side side, int from, int to) {
  const FootContacts contacts = find_contacts(take);
  for (const Stance& stance : side == Side::left ? contacts.left : contacts.right) {
    if (stance.on + (stance.off - stance.on) / 3 <= from && to <= stance.off) return true;
  }
  return false;
}

TEST(Transition, LeavesAToeWhereItStoodFromBeforeUntilAfter) {
  int seen_standing = 0;
  for (const Passed& passed : usable_passages()) {
    const auto& [i, j, k] = passed.match.frames;
    for (const Side side : {Side::left, Side::right}) {
      if (!stands(walkers().take(passed.a), side, i - 1, i + k) ||
          !stands(walkers().take(passed.b), side, j - k, j)) {
        continue;
      }
      const Take take = seen(passed);
      const Eigen::Vector3d way = body_at(take, k + 1).col(leg_joints(side).toe) -
                                  body_at(take, 1).col(leg_joints(side).toe);
      EXPECT_LT(std::hypot(way.x(), way.z()), 0.005);
      ++seen_standing;
    }
  }
  EXPECT_GE(seen_standing, 3);
}

TEST(Transition, IsAsSmoothAsTheWalksAroundIt) {
  for (const Passed& passed : usable_passages()) {
    const TransitionQuality& quality = passed.transition.quality;
    const KneeAxes axes = knee_axes(walkers().take(passed.a));
    const FrameGap gap = largest_gap(frame_gaps(seen(passed), axes));
    EXPECT_NEAR(gap.place_m, quality.gap_m, 1e-12);
    EXPECT_LE(gap.place_m, quality.inside_gap_m * (1 + 1e-9));
    EXPECT_NEAR(gap.knee, quality.knee_gap, 1e-3);  // the axis is the mean of both here
    EXPECT_LE(quality.knee_gap, quality.inside_knee_gap * (1 + 1e-9));
  }
}

// Its first pose is the first mix, its feet hardly moved: by less than in the whole.
TEST(Transition, BeginsAndEndsWithTheCaptures) {
  for (const Passed& passed : usable_passages()) {
    const auto& [i, j, k] = passed.match.frames;
    const std::vector<Pose>& poses = passed.transition.poses;
    ASSERT_EQ(poses.size(), static_cast<std::size_t>(k - 1));
    const Pose& before = walkers().take(passed.a).poses[static_cast<std::size_t>(i)];
    const Pose behind = moved(passed.transition.move,
                              walkers().take(passed.b).poses[static_cast<std::size_t>(j - 1)]);
    EXPECT_LT((poses.front().root - before.root).norm(), 0.01);
    EXPECT_LT((poses.back().root - behind.root).norm(), 0.01);
    EXPECT_LT(poses.front().rotations[0].angularDistance(before.rotations[0]), 0.01);
    EXPECT_LT(poses.back().rotations[0].angularDistance(behind.rotations[0]), 0.01);
  }
}

TEST(Transition, LeavesNoKneeBeyondStraight) {
  for (const Passed& passed : usable_passages()) {
    const Take& take = walkers().take(passed.a);
    const KneeAxes axes = knee_axes(take);
    for (const Pose& pose : passed.transition.poses) {
      const WorldPose world = forward_kinematics(take.skeleton, pose);
      EXPECT_GT(knee_bend(take.skeleton, take.body, Side::left, axes[0], world), 0);
      EXPECT_GT(knee_bend(take.skeleton, take.body, Side::right, axes[1], world), 0);
    }
  }
}

// A walk that was walked elsewhere, by more than a right angle to the side.
Take elsewhere(Take take) {
  for (Pose& pose : take.poses) pose = moved(PlanarMove{2.1, 3, -1}, pose);
  return take;
}

TEST(Transition, IntoItsOwnCopyACycleLaterGoesOnAsTheWalkDoes) {
  const std::size_t robot = 8;
  ASSERT_EQ(walkers().style(robot), "robot");
  const Take& take = walkers().take(robot);
  const Take copy = elsewhere(take);
  const Matchable there(copy);
  const int cycle = (take.frames() - 1) / 3;
  const FoundMatch match =
      best_match(walkers()[robot], 30, there, 30 + cycle, 40 + window + cycle, window);
  ASSERT_EQ(match.frames.j, 30 + window - 1 + cycle);
  const Transition transition = transition_of(walkers()[robot], there, match);
  EXPECT_EQ(transition.refusal, "");
  for (std::size_t p = 0; p + 1 < window; ++p) {
    EXPECT_LT((transition.poses[p].root - take.poses[30 + p].root).norm(), 1e-9);
    for (std::size_t joint = 0; joint < take.skeleton.joints.size(); ++joint) {
      EXPECT_LT(
          transition.poses[p].rotations[joint].angularDistance(take.poses[30 + p].rotations[joint]),
          1e-7);
    }
  }
}

// Somebody who stands still, with the legs so far apart.
Take standing(double radians) {
  Take take = part(walkers().take(0), 0, 0);
  const auto turn_hip = [&](BodyJoint hip, double angle) {
    Eigen::Quaterniond& turn =
        take.poses[0].rotations[static_cast<std::size_t>(take.body.joint[hip])];
    turn = Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())) * turn;
  };
  turn_hip(left_hip, radians);
  turn_hip(right_hip, -radians);
  take.poses.resize(80, take.poses[0]);
  return take;
}

Transition between_standing(double a, double b) {
  const Take from = standing(a), to = standing(b);
  const Matchable first(from), second(to);
  return transition_of(first, second, best_match(first, 30, second, 40, 40, window));
}

TEST(Transition, OfFeetThatStandApartOtherwiseIsRefused) {
  const Transition transition = between_standing(0, 0.1);
  EXPECT_NE(transition.refusal.find("foot would slide"), std::string::npos) << transition.refusal;
  EXPECT_NE(transition.refusal.find(" mm"), std::string::npos) << transition.refusal;
  EXPECT_GT(transition.quality.slide_m, 0.005);
}

TEST(Transition, OfSomebodyWhoStandsStillIsUsable) {
  EXPECT_EQ(between_standing(0.1, 0.1).refusal, "");
}

TEST(Transition, NeedsAFrameBeforeIt) {
  const FoundMatch match = best_match(walkers()[0], 0, walkers()[1], 60, 60, window);
  const Transition transition = transition_of(walkers()[0], walkers()[1], match);
  EXPECT_NE(transition.refusal, "");
  EXPECT_TRUE(transition.poses.empty());
}

TEST(Transition, IsTheSameEveryTime) {
  const FoundMatch match = walkers().match(0, 66, 1);
  const Transition first = transition_of(walkers()[0], walkers()[1], match);
  const Transition again = transition_of(walkers()[0], walkers()[1], match);
  for (std::size_t p = 0; p < first.poses.size(); ++p) {
    EXPECT_EQ(first.poses[p].root, again.poses[p].root);
    for (std::size_t joint = 0; joint < first.poses[p].rotations.size(); ++joint) {
      EXPECT_EQ(first.poses[p].rotations[joint].coeffs(), again.poses[p].rotations[joint].coeffs());
    }
  }
}

}  // namespace
}  // namespace promenade::motion
