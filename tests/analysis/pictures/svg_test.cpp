#include "analysis/pictures/svg.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

bool holds(const Svg& svg, const std::string& part) {
  return svg.finish().find(part) != std::string::npos;
}

TEST(APictureInSvg, EscapesItsWords) {
  Svg svg(100, 50);
  svg.words(1, 2, "a<b> & \"c\"\x01");
  EXPECT_TRUE(holds(svg, ">a&lt;b&gt; &amp; &quot;c&quot; </text>")) << svg.finish();
}

TEST(APictureInSvg, HasNoRectangleOfNegativeWidth) {
  Svg svg(100, 50);
  svg.rect(10, 5, -3, 2, "#000000");
  EXPECT_TRUE(holds(svg, "<rect x=\"10.0\" y=\"5.0\" width=\"0.0\" height=\"2.0\""));
}

TEST(APictureInSvg, ConnectsThePointsOfACurve) {
  Svg svg(100, 50);
  svg.curve({{0, 1}, {2.25, 3}}, "#112233");
  EXPECT_TRUE(holds(svg, "points=\"0.0,1.0 2.2,3.0 \""));
  EXPECT_TRUE(holds(svg, "</svg>\n"));
}

}  // namespace
}  // namespace promenade::analysis
