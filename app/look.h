// Colours and fonts. The created motion has one colour everywhere, the target
// another; they differ in lightness too, for people who do not see the hues
// (tests/app/look_test.cpp computes it).
#pragma once

#include <imgui.h>

#include <Eigen/Dense>
#include <array>
#include <string>
#include <vector>

namespace promenade::app {

using Rgb = Eigen::Vector3f;  // 0 to 1, as a display takes it (sRGB)

Rgb rgb(unsigned int hex);  // 0xRRGGBB
ImU32 packed(const Rgb& colour, float alpha = 1);

struct Palette {
  Rgb background = rgb(0xECEAE6);
  Rgb panel = rgb(0xF8F7F5);
  Rgb text = rgb(0x26282C);
  Rgb quiet = rgb(0x63666C);  // text that stands back
  Rgb line = rgb(0xCFCCC6);
  Rgb hover = rgb(0xE9E7E2);
  Rgb track = rgb(0xD5D2CC);
  Rgb target = rgb(0x72B73E);     // green
  Rgb created = rgb(0x2B5FB0);    // blue
  Rgb reference = rgb(0xB23A48);  // red
  // On the map: the dots of the examples, of the bookmarks, and of what is shown.
  Rgb example = rgb(0x8FA9CF);
  Rgb bookmark = rgb(0x1F7A5C);
  Rgb current = rgb(0x2B5FB0);
  Rgb known = rgb(0xE6ECF5);  // the region that the examples cover
  std::array<Rgb, 3> clusters = {rgb(0xC9A66B), rgb(0x7FA38A), rgb(0xA98BB5)};  // of the examples
  // From one of two opposite words to the other: an answer shows which way it goes. They differ
  // in lightness from the middle, for people who do not see the hues (ColorBrewer PuOr).
  std::array<Rgb, 5> steps = {rgb(0xB35806), rgb(0xF1A340), rgb(0x9C9C9C), rgb(0x998EC3),
                              rgb(0x542788)};
  Rgb pilot = rgb(0xE07B1A);
  Rgb alarm = rgb(0xB3261E);      // something is lost unless somebody acts
  Rgb on_colour = rgb(0xFFFFFF);  // text on `created`
};

// `paper`: as the sources have them: green, blue and red ([O] 6), and on the map blue
// examples, green bookmarks and a red dot ([N] 5.4).
Palette make_palette(bool paper);

// The colour of a place between the two words, 0 to 1.
Rgb step_colour(const Palette& palette, float share);

// Black on a light ground, white on a dark one: whichever can be read better.
const Rgb& ink_on(const Palette& palette, const Rgb& ground);

struct Fonts {
  ImFont* text = nullptr;     // 16 px
  ImFont* bold = nullptr;     // 16 px
  ImFont* reading = nullptr;  // 20 px, for pages of text
  ImFont* title = nullptr;    // 24 px
  ImFont* heading = nullptr;  // 32 px
};

struct Look {
  Palette palette;
  Fonts fonts;
  float scale = 1;  // of everything, from 1280 x 720
};

// Throws OutsideError when the fonts are not installed.
void require_fonts();

// Loads the fonts at `scale` into the atlas, with the characters of `words` and
// those of Latin; where words are Japanese, `text` and `bold` have all kana and the common
// kanji too, for what people write. Throws OutsideError when the fonts are not installed. Builds
// the atlas, so that tests need no graphics card.
Fonts load_fonts(ImFontAtlas& atlas, float scale, const std::vector<std::string>& words);

// Dear ImGui in our style: square, flat, and cheap to draw in software.
void set_style(float scale, const Palette& palette);

}  // namespace promenade::app
