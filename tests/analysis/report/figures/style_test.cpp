#include "analysis/report/figures/style.h"

#include <gtest/gtest.h>

#include <set>

namespace promenade::analysis {
namespace {

TEST(FittedText, IsNoWiderThanAskedAndNeverCutsALetter) {
  EXPECT_EQ(fitted("map", 10), "map");
  for (const std::string text :
       {"a rather long name of an interface", "とても長い名前のスライダー"}) {
    for (double width = 2; width < 12; width += 0.5) {
      const std::string cut = fitted(text, width);
      EXPECT_LE(text_width(cut), width) << cut;
      EXPECT_EQ(cut.substr(cut.size() - 3), "…");
      EXPECT_EQ((static_cast<unsigned char>(text[cut.size() - 3]) & 0xc0u) == 0x80u, false) << cut;
    }
  }
}

TEST(FittedText, TakesStrayBytesForLetters) {
  EXPECT_GT(text_width("\xff\x80\xe3"), 0);
  EXPECT_FALSE(fitted("\xff\xff\xff\xff\xff\xff\xff\xff", 2).empty());
}

TEST(Looks, DifferInColourPointAndDash) {
  std::set<std::string> points, lines;
  for (int i = 0; i < 8; ++i) {
    points.insert(point_style(i).substr(0, 5));
    lines.insert(line_style(i).substr(0, line_style(i).find(" lw")));
  }
  EXPECT_EQ(points.size(), 8U);
  EXPECT_EQ(lines.size(), 8U);
}

TEST(Frame, GrowsWithItsLegendAndTurnsNamesThatHaveNoRoom) {
  Frame frame;
  frame.columns = {"map", "labels"};
  const FramedPlot flat = framed(frame);
  EXPECT_EQ(flat.commands.find("rotate by 45"), std::string::npos);
  frame.columns.assign(6, "a rather long name");
  EXPECT_NE(framed(frame).commands.find("rotate by 45"), std::string::npos);
  EXPECT_GT(framed(frame).height_mm, flat.height_mm);
  frame.columns = {"map", "labels"};
  frame.series = {"one series", "another one", "a third one", "and a fourth"};
  frame.looks = {0, 1, 2, 3};
  EXPECT_NEAR(framed(frame).height_mm, flat.height_mm + 2 * 4.2, 1e-9) << "two rows";
}

}  // namespace
}  // namespace promenade::analysis
