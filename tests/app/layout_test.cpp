#include "app/layout.h"

#include <gtest/gtest.h>

namespace promenade::app {
namespace {

TEST(Layout, IsTheSceneAsDrawnAt1280By720) {
  const Layout layout = make_layout(1280, 720);
  EXPECT_EQ(layout.panel().x, 848);
  EXPECT_EQ(layout.panel().right(), 1264);
  EXPECT_EQ(layout.stage().bottom(), 704);
  EXPECT_EQ(layout.done().width, 160);
}

TEST(Layout, EverythingIsTwiceAsLargeAt2560By1440) {
  const Layout layout = make_layout(2560, 1440);
  EXPECT_EQ(layout.panel().x, 2 * 848);
  EXPECT_EQ(layout.done().height, 96);
}

TEST(Layout, AWiderWindowCentresThePicture) {
  const Layout layout = make_layout(1480, 720);
  EXPECT_EQ(layout.strip().x, 100);
  EXPECT_EQ(layout.scale, 1);
}

TEST(Layout, NothingOverlapsAtOddSizes) {
  for (int width = 900; width < 2000; width += 37) {
    const Layout layout = make_layout(width, width * 9 / 16);
    EXPECT_LE(layout.stage().right(), layout.panel().x);
    EXPECT_LE(layout.panel().bottom(), layout.done().y);
    EXPECT_LE(layout.start_over().right(), layout.done().x);
  }
}

TEST(Layout, APictureThatTakesAShareIsCentred) {
  const Layout layout = make_layout(1280, 720, 0.5);
  EXPECT_EQ(layout.scale, 0.5f);
  const Box panel = layout.panel();
  EXPECT_EQ(panel.x, 320 + 424);
  EXPECT_EQ(panel.y, 180 + 32);
}

}  // namespace
}  // namespace promenade::app
