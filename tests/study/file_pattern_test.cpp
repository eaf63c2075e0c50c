#include "study/file_pattern.h"

#include <gtest/gtest.h>

namespace promenade::study {
namespace {

TEST(StyleOf, IsWhatTheMarkStandsForOrTheWholeName) {
  EXPECT_EQ(style_of("walk_sad_1.bvh", "walk_{style}_*.bvh"), "sad");
  EXPECT_EQ(style_of("walk_not-so_sad_1.bvh", "walk_{style}_?.bvh"), "not-so_sad");
  EXPECT_EQ(style_of("sad.bvh", "*.bvh"), "sad");
  EXPECT_EQ(style_of("walk__1.bvh", "walk_{style}_1.bvh"), std::nullopt);
  EXPECT_EQ(style_of("sad.amc", "*.bvh"), std::nullopt);
}

TEST(StyleOf, IsFoundInAFolderOrAFile) {
  EXPECT_EQ(style_of("Angry/take_1.bvh", "{style}/take_*.bvh"), "Angry");
  EXPECT_EQ(style_of("a/Old_FW.bvh", "*/{style}_FW.bvh"), "Old");
  EXPECT_EQ(style_of("a/b/Old_FW.bvh", "*/{style}_FW.bvh"), std::nullopt);
  EXPECT_EQ(style_of("Old_FW.bvh", "*/{style}_FW.bvh"), std::nullopt);
}

TEST(StyleOf, TakesNoTimeWhereAPatternFitsInManyWays) {
  const std::string name(255, 'a');
  EXPECT_EQ(style_of(name, "*a*a*a*a*{style}*b"), std::nullopt);
  EXPECT_EQ(style_of(name + "b", "*a*a*a*a*{style}*b"), "a");
}

}  // namespace
}  // namespace promenade::study
