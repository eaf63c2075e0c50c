#include "study/process_measures.h"

#include <gtest/gtest.h>

#include "play.h"
#include "toy.h"

namespace promenade::study {
namespace {

using toy::Player;

constexpr std::int64_t second = 1'000'000;

const std::string text =
    "[study]\nname = 'process'\n[[interface]]\nname = 'mix'\n[[task]]\nname = 'copy'\nkind = "
    "'match'\ntargets = [{example = 'far'}]\n";

ProcessMeasures of(Player& player, std::int64_t t_us) {
  player.at(t_us, Done{});
  return player.all<TrialEnded>().at(0).process;
}

TEST(ProcessMeasures, SumDOverTheTimeWorked) {
  const StudyBundle bundle = toy::bundle(text);
  Player player(bundle);
  player.to_trial(0);
  const double start = *player.session.trial()->d;
  player.at(2 * second, toy::slide("near", 1));
  const double near = *player.session.trial()->d;
  player.at(3 * second, Pause{});
  player.at(33 * second, Resume{});
  const ProcessMeasures measures = of(player, 35 * second);
  EXPECT_NEAR(*measures.d_area_m_s, 2 * start + 3 * near, 1e-12);
}

TEST(ProcessMeasures, FollowTheWayThatWasShown) {
  const StudyBundle bundle = toy::bundle(text);
  Player player(bundle);
  player.to_trial(0);
  const motion::MotionSpace& space = bundle.space;
  const motion::Cycle average = motion::blend(space, start_weights(space));
  player.at(1 * second, toy::slide("near", 1));
  player.at(3 * second, StartOver{});
  const double there = motion::distance(space.set, average, space.set.cycles[0]).mean_m;
  EXPECT_NEAR(of(player, 5 * second).path_m, 2 * there, 1e-9);
}

TEST(ProcessMeasures, CountWhatWasDone) {
  const StudyBundle bundle = toy::bundle(text);
  Player player(bundle);
  player.to_trial(0);
  player.at(1'000'000, Press{});
  for (int k = 1; k <= 4; ++k) player.at(1'000'000 + k * 1000, toy::slide("far", 0.2 * k));
  player.at(2'000'000, Press{});
  player.at(2'000'000, toy::slide("far", 0));  // back to the start: nothing is set
  player.at(2'100'000, Press{});
  player.at(2'100'000, toy::slide("near", 1));
  player.at(2'200'000, Camera{0.5, 0, 1, 0, 0});
  player.at(2'210'000, Camera{0.6, 0, 1, 0, 0});
  const ProcessMeasures measures = of(player, 9'200'000);
  EXPECT_EQ(measures.drags, 1);
  EXPECT_EQ(measures.controls_touched, 2);
  EXPECT_EQ(measures.examples_visited, 2);
  EXPECT_EQ(measures.camera_moves, 1);
  EXPECT_EQ(measures.idle_us, 6'990'000);
  EXPECT_GE(measures.reversals, 1);
}

TEST(ProcessMeasures, CoverNothingBeyondTheMap) {
  const CoverageMap map = make_coverage_map(toy::bundle(text).space);
  EXPECT_EQ(map.cell_of(Eigen::Vector3d(100, -99, 0)), -1);
  for (int i = 0; i < 3; ++i) {
    const int cell = map.cell_of(Eigen::Vector3d::Unit(i));
    EXPECT_GE(cell, 0);
    EXPECT_LT(cell, 100);
  }
}

}  // namespace
}  // namespace promenade::study
