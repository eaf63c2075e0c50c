#include "analysis/report/html.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

TEST(Html, EscapesWhatPeopleWrote) {
  EXPECT_EQ(element("p", "<b> & \"x\" 'y'").code,
            "<p>&lt;b&gt; &amp; &quot;x&quot; &#39;y&#39;</p>");
  EXPECT_EQ(element("a", {{"href", "\"><script>"}}, text("x")).code,
            "<a href=\"&quot;&gt;&lt;script&gt;\">x</a>");
}

TEST(Html, DropsControlCharacters) {
  EXPECT_EQ(text("a\x01"
                 "b\nc")
                .code,
            "a b\nc");
}

TEST(Html, WritesTheHeadingOfAGroupOnce) {
  const std::string code =
      render({"c", {"m", "i", "n"}, {{"D", "a", "1"}, {"D", "b", "2"}}, {}, 2}).code;
  EXPECT_NE(code.find("<th scope=\"row\">D</th><th scope=\"row\">a</th><td>1</td>"), code.npos);
  EXPECT_NE(code.find("<th scope=\"row\"></th><th scope=\"row\">b</th><td>2</td>"), code.npos);
}

// RFC 4648, section 10.
TEST(Base64, HasTheVectorsOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace promenade::analysis
