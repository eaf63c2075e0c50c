#include "motion/gait/families.h"

#include <gtest/gtest.h>

#include <map>

namespace promenade::motion::gait {
namespace {

std::map<std::string, std::vector<GaitStyle>> families() {
  std::map<std::string, std::vector<GaitStyle>> found;
  for (const GaitStyle& style : styles_of_set_n()) found[style.family].push_back(style);
  return found;
}

TEST(SetNStyles, AreOfThreeFamilies) {
  const auto found = families();
  ASSERT_EQ(found.size(), 3);
  for (const char* family : {"crouching", "upright", "wide"}) {
    EXPECT_GE(found.at(family).size(), 15) << family;
  }
}

TEST(SetNStyles, DoWhatTheirFamilyIsCalledFor) {
  const auto found = families();
  for (const GaitStyle& style : found.at("crouching")) {
    EXPECT_GT(style.knees.mid, 30) << style.name;
    EXPECT_GT(style.trunk.lean, 15) << style.name;
  }
  for (const GaitStyle& style : found.at("wide")) {
    EXPECT_GT(style.feet.half_width, 0.1) << style.name;
    EXPECT_GT(style.arms.elbow, 45) << style.name;
  }
  for (const GaitStyle& style : found.at("upright")) {
    EXPECT_LT(style.knees.mid, 20) << style.name;
    EXPECT_LT(style.feet.half_width, 0.1) << style.name;
  }
}

TEST(SetNStyles, StartFromANormalWalkInTheMiddleOfEveryQuality) {
  const auto found = families();
  const StyleCharacter& normal = found.at("upright").front().character;
  EXPECT_EQ(found.at("upright").front().name, "normal");
  EXPECT_EQ(normal.valence, 0);
  EXPECT_EQ(normal.tension, 0);
}

}  // namespace
}  // namespace promenade::motion::gait
