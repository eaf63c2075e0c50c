#include "motion/graph/matches.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <set>

#include "motion/angles.h"
#include "motion/graph/window_distance.h"
#include "tests/motion/graph/random_clouds.h"
#include "tests/motion/walker.h"

namespace promenade::motion {
namespace {

constexpr double frame_time = 0.1;
const MatchOptions five_frames = {.threshold_m = 1e-4, .window_s = 0.5, .apart_s = 0.3};

LabelledClouds take(std::uint64_t seed, int frames, const std::string& label = "") {
  Clouds clouds = random_clouds(seed, frames, 4);
  clouds.weights.setConstant(0.25);
  return {clouds, label};
}

MatchOptions with_threshold(double threshold_m) {
  MatchOptions options = five_frames;
  options.threshold_m = threshold_m;
  return options;
}

std::vector<double> sorted_rms(const Matches& matches) {
  std::vector<double> rms;
  for (const Match& match : matches.found) rms.push_back(match.rms_m);
  std::sort(rms.begin(), rms.end());
  return rms;
}

TEST(WindowTaper, SumsToOneAndMayFavourTheMiddle) {
  for (const bool tapered : {false, true}) {
    const std::vector<double> taper =
        window_taper({.window_s = 0.7, .tapered = tapered}, frame_time);
    ASSERT_EQ(taper.size(), 7u);
    EXPECT_NEAR(std::accumulate(taper.begin(), taper.end(), 0.0), 1, 1e-15);
    EXPECT_NEAR(taper[1], taper[5], 1e-15);
    EXPECT_EQ(taper[3] > 3 * taper[0], tapered);
  }
  EXPECT_EQ(window_taper({.window_s = 0.01}, frame_time).size(), 2u);
}

TEST(Matches, AMovedCopyIsFoundWithItsMove) {
  const LabelledClouds original = take(1, 60);
  const PlanarMove away{2.5, -3, 1.5};
  const LabelledClouds copy = {moved(away, part(original.clouds, 23, 12)), ""};
  const Matches matches = find_matches({original, copy}, frame_time, five_frames);
  ASSERT_EQ(matches.found.size(), 1u);  // of equals along the diagonal the first
  const Match& match = matches.found[0];
  EXPECT_EQ(std::tuple(match.take_a, match.take_b, match.start_a, match.start_b),
            std::tuple(0, 1, 23, 0));
  EXPECT_LT(match.rms_m, 1e-14);
  EXPECT_NEAR(std::remainder(match.move.theta + 2.5, 2 * pi), 0, 1e-13);
  const PlanarMove none = after(match.move, away);
  EXPECT_NEAR(none.x0, 0, 1e-13);
  EXPECT_NEAR(none.z0, 0, 1e-13);
}

TEST(Matches, AreReportedInDouble) {
  const std::vector<LabelledClouds> takes = {take(2, 40), take(3, 50)};
  const Matches matches = find_matches(takes, frame_time, with_threshold(1));
  ASSERT_GT(matches.found.size(), 10u);
  const auto taper = window_taper(five_frames, frame_time);
  for (const Match& match : matches.found) {
    const Clouds& a = takes[static_cast<std::size_t>(match.take_a)].clouds;
    const Clouds& b = takes[static_cast<std::size_t>(match.take_b)].clouds;
    const auto distance = window_distance(a, match.start_a, b, match.start_b + 4, taper);
    EXPECT_EQ(match.rms_m, distance.rms());
    EXPECT_EQ(match.move.theta, distance.move.theta);
  }
}

TEST(Matches, ComeInOrderOfTakesAndFrames) {
  const Matches matches =
      find_matches({take(4, 40), take(5, 40), take(6, 40)}, frame_time, with_threshold(2));
  const auto key = [](const Match& m) {
    return std::tuple(m.take_a, m.take_b, m.start_a, m.start_b);
  };
  EXPECT_TRUE(std::is_sorted(matches.found.begin(), matches.found.end(),
                             [&](const Match& a, const Match& b) { return key(a) < key(b); }));
  std::set<std::pair<int, int>> pairs;
  for (const Match& match : matches.found) pairs.emplace(match.take_a, match.take_b);
  EXPECT_EQ(pairs.size(), 6u);
  EXPECT_EQ(matches.minima, std::ssize(matches.found));
}

TEST(Matches, OfOneTakeLieApart) {
  const Matches matches = find_matches({take(7, 80)}, frame_time, with_threshold(2));
  ASSERT_FALSE(matches.found.empty());
  for (const Match& match : matches.found) EXPECT_GE(match.start_b - match.start_a, 3);
}

TEST(Matches, AThresholdOfLabelsIsTheirs) {
  const std::vector<LabelledClouds> takes = {take(8, 40, "glad"), take(9, 40, "sad"),
                                             take(10, 40, "glad")};
  MatchOptions options = with_threshold(0.5);
  options.labels = {{"sad", "glad", 2}};
  const Matches all = find_matches(takes, frame_time, with_threshold(2));
  const Matches matches = find_matches(takes, frame_time, options);
  const auto meant = [](const Match& m) {
    const bool mixed = (m.take_a == 1) != (m.take_b == 1);
    return m.rms_m <= (mixed ? 2 : 0.5);
  };
  EXPECT_EQ(std::ssize(matches.found), std::count_if(all.found.begin(), all.found.end(), meant));
  EXPECT_TRUE(std::all_of(matches.found.begin(), matches.found.end(), meant));
}

TEST(Matches, AQuantileIsAShareOfAllMinima) {
  const std::vector<LabelledClouds> takes = {take(11, 60), take(12, 60)};
  MatchOptions options = five_frames;
  options.quantile = 0.25;
  const Matches matches = find_matches(takes, frame_time, options);
  const std::vector<double> all = sorted_rms(find_matches(takes, frame_time, with_threshold(100)));
  EXPECT_EQ(matches.minima, std::ssize(all));
  const auto below = static_cast<std::size_t>(0.25 * static_cast<double>(all.size() - 1));
  EXPECT_GE(matches.threshold_m, all[below]);
  EXPECT_LE(matches.threshold_m, all[below + 1]);
  EXPECT_EQ(matches.found.size(), below + 1);
}

TEST(Matches, LabelsHaveTheirThresholdBesideAQuantile) {
  const std::vector<LabelledClouds> takes = {take(13, 40, "glad"), take(14, 40, "sad")};
  MatchOptions options = five_frames;
  options.quantile = 0.1;
  options.labels = {{"glad", "sad", 0}};
  const Matches matches = find_matches(takes, frame_time, options);
  EXPECT_FALSE(matches.found.empty());
  for (const Match& match : matches.found) EXPECT_EQ(match.take_a, match.take_b);
}

TEST(Matches, NothingIsLikeNothing) {
  EXPECT_TRUE(find_matches({}, frame_time, five_frames).found.empty());
  EXPECT_TRUE(find_matches({take(15, 1)}, frame_time, five_frames).found.empty());
  EXPECT_TRUE(find_matches({take(16, 4), take(17, 0)}, frame_time, five_frames).found.empty());
  EXPECT_EQ(find_matches({take(18, 5), take(19, 5)}, frame_time, with_threshold(9)).found.size(),
            1u);
}

TEST(Matches, WindowsWithoutNumbersHaveNone) {
  LabelledClouds broken = take(20, 60);
  broken.clouds.points(2, 4 * 30) = std::numeric_limits<double>::quiet_NaN();
  broken.clouds.points(0, 4 * 45 + 1) = std::numeric_limits<double>::infinity();
  const Matches matches = find_matches({broken, take(21, 60)}, frame_time, with_threshold(5));
  EXPECT_GT(matches.found.size(), 50u);
  const auto broken_window = [](int start) {
    return (start >= 26 && start <= 30) || (start >= 41 && start <= 45);
  };
  for (const Match& match : matches.found) {
    EXPECT_TRUE(std::isfinite(match.rms_m));
    EXPECT_FALSE(match.take_a == 0 && broken_window(match.start_a));
    EXPECT_FALSE(match.take_b == 0 && broken_window(match.start_b));
  }
}

TEST(Matches, SomebodyWhoStandsStillMatchesOnce) {
  LabelledClouds still = take(22, 200);
  for (int f = 1; f < 200; ++f)
    still.clouds.points.middleCols(4 * f, 4) = still.clouds.points.leftCols(4);
  const Matches matches = find_matches({still, still}, frame_time, five_frames);
  std::set<std::pair<int, int>> pairs;
  for (const Match& match : matches.found) {
    EXPECT_TRUE(pairs.emplace(match.take_a, match.take_b).second);
    EXPECT_EQ(match.start_a, 0);
  }
}

TEST(Matches, AFrameWhichIsInHalfAMapIsInTheOther) {
  const LabelledClouds both = take(23, 90);
  const Matches with_itself = find_matches({both}, frame_time, with_threshold(3));
  const Matches with_copy = find_matches({both, both}, frame_time, with_threshold(3));
  int above = 0;
  for (const Match& m : with_copy.found) {
    above += m.take_a == 0 && m.take_b == 1 && m.start_b - m.start_a >= 3 ? 1 : 0;
  }
  EXPECT_EQ(above, std::ssize(with_itself.found));
}

TEST(Matches, StopWhenAskedTo) {
  double last = 0;
  const std::vector<LabelledClouds> takes = {take(24, 30), take(25, 30), take(26, 30)};
  const Matches all = find_matches(takes, frame_time, with_threshold(3), [&](double share) {
    EXPECT_GE(share, last);
    last = share;
    return true;
  });
  EXPECT_FALSE(all.found.empty());
  EXPECT_TRUE(find_matches(takes, frame_time, with_threshold(3), [](double) {
                return false;
              }).found.empty());
}

}  // namespace
}  // namespace promenade::motion
