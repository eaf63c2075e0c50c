#include "app/name_tags.h"

#include <gtest/gtest.h>

#include <vector>

#include "study/rng.h"

namespace promenade::app {
namespace {

constexpr Box area{0, 0, 400, 400};

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

TEST(NameTags, NeverLieOnEachOtherOrOutside) {
  study::Rng rng(1, 2, "test");
  NameTags tags(area);
  std::vector<Box> placed;
  for (int k = 0; k < 100; ++k) {
    const Eigen::Vector2f dot(static_cast<float>(400 * rng.uniform()),
                              static_cast<float>(400 * rng.uniform()));
    const auto box = tags.place(dot, 8, {60, 18});
    if (!box) continue;
    EXPECT_TRUE(box->x >= 0 && box->right() <= 400 && box->y >= 0 && box->bottom() <= 400);
    for (const Box& other : placed) EXPECT_FALSE(overlap(*box, other));
    placed.push_back(*box);
  }
  EXPECT_GT(placed.size(), 20U);
}

TEST(NameTags, KeepOffTheDots) {
  NameTags tags(area);
  tags.keep_free({210, 190, 20, 20});
  const auto box = tags.place({200, 200}, 8, {60, 18});
  ASSERT_TRUE(box);
  EXPECT_FALSE(overlap(*box, {210, 190, 20, 20}));
}

TEST(NameTags, OneCanBePlacedAnywayAndStaysInside) {
  const NameTags tags(area);
  for (const Eigen::Vector2f& dot : {Eigen::Vector2f(398, 2), Eigen::Vector2f(1, 399)}) {
    const Box box = tags.place_anyway(dot, 8, {120, 18});
    EXPECT_TRUE(box.x >= 0 && box.right() <= 400 && box.y >= 0 && box.bottom() <= 400);
  }
}

}  // namespace
}  // namespace promenade::app
