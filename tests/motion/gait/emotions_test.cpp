#include "motion/gait/emotions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace promenade::motion::gait {
namespace {

GaitStyle walk(const std::string& name) {
  const std::vector<GaitStyle> styles = styles_of_set_b();
  const auto found = std::find_if(styles.begin(), styles.end(),
                                  [&](const GaitStyle& style) { return style.name == name; });
  if (found == styles.end()) throw std::out_of_range("set B has no walk " + name);
  return *found;
}

TEST(SetBStyles, LieOnRussellsCircle) {
  for (const GaitStyle& style : styles_of_set_b()) {
    const double radius = std::hypot(style.character.valence, style.character.arousal);
    EXPECT_NEAR(radius, style.style == "neutral" ? 0 : 1, 1e-12) << style.name;
  }
  EXPECT_NEAR(walk("pleasure-slow").character.valence, 1, 1e-12);
  EXPECT_NEAR(walk("sleepiness-fast").character.arousal, -1, 1e-12);
  EXPECT_NEAR(walk("distress-normal").character.valence, -std::sqrt(0.5), 1e-12);
}

// Michalak 2009: slower, less arm swing, slumped. Montepare 1987: the happy swing their
// arms. Roether 2009: the afraid bend their elbows.
TEST(SetBStyles, FollowWhatStudiesOfEmotionalGaitFound) {
  const GaitStyle neutral = walk("neutral-normal");
  const GaitStyle depressed = walk("depression-normal");
  EXPECT_LT(depressed.timing.speed, neutral.timing.speed);
  EXPECT_LT(stride_length(depressed), stride_length(neutral));
  EXPECT_LT(depressed.arms.swing, 0.5 * neutral.arms.swing);
  EXPECT_GT(depressed.trunk.lean, neutral.trunk.lean + 10);
  EXPECT_GT(depressed.head.pitch, neutral.head.pitch + 20);
  EXPECT_GT(walk("pleasure-normal").arms.swing, neutral.arms.swing + 5);
  EXPECT_GT(walk("excitement-normal").pelvis.bounce, 0.01);
  EXPECT_GT(walk("distress-normal").arms.elbow, neutral.arms.elbow + 30);
}

TEST(SetBStyles, PaceFollowsArousalAndTempo) {
  EXPECT_GT(walk("arousal-fast").character.pace, walk("arousal-normal").character.pace);
  EXPECT_GT(walk("arousal-normal").character.pace, walk("sleepiness-normal").character.pace);
  EXPECT_LT(walk("sleepiness-slow").character.pace, -0.5);
}

}  // namespace
}  // namespace promenade::motion::gait
