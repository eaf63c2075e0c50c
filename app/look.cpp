#include "app/look.h"

#include <algorithm>
#include <filesystem>

#include "motion/problem.h"

namespace promenade::app {
namespace {

constexpr const char* latin_file = "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf";
constexpr const char* latin_bold_file = "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf";
constexpr const char* japanese_file = "/usr/share/fonts/opentype/ipafont-gothic/ipagp.ttf";

// Dear ImGui's size is ascent plus descent; ours is the em, as in print and on the
// web. The ratio is a property of Noto Sans (1069 + 293 over 1000).
constexpr float latin_line = 1.362f;

ImFont* add_font(ImFontAtlas& atlas, const char* latin, float pixels, const ImWchar* ranges) {
  ImFontConfig config;
  config.OversampleH = 2;
  config.PixelSnapH = true;
  ImFont* font = atlas.AddFontFromFileTTF(latin, pixels * latin_line, &config, ranges);
  config.MergeMode = true;
  config.OversampleH = 1;
  atlas.AddFontFromFileTTF(japanese_file, pixels, &config, ranges);
  return font;
}

ImVec4 vec(const Rgb& colour) { return {colour.x(), colour.y(), colour.z(), 1}; }

}  // namespace

void require_fonts() {
  for (const char* file : {latin_file, latin_bold_file, japanese_file}) {
    if (std::filesystem::exists(file)) continue;
    throw OutsideError("the font " + std::string(file) +
                       " is missing; install the packages fonts-noto-core and "
                       "fonts-ipafont-gothic");
  }
}

Rgb rgb(unsigned int hex) {
  return Rgb(static_cast<float>(hex >> 16 & 255), static_cast<float>(hex >> 8 & 255),
             static_cast<float>(hex & 255)) /
         255.0f;
}

ImU32 packed(const Rgb& colour, float alpha) {
  return ImGui::ColorConvertFloat4ToU32({colour.x(), colour.y(), colour.z(), alpha});
}

Palette make_palette(bool paper) {
  Palette palette;
  if (paper) {
    palette.target = rgb(0x00A000);
    palette.created = rgb(0x2040E0);
    palette.reference = rgb(0xE02020);
    palette.example = rgb(0x2040E0);
    palette.bookmark = rgb(0x008000);
    palette.current = rgb(0xE02020);
  }
  return palette;
}

Rgb step_colour(const Palette& palette, float share) {
  const auto last = static_cast<float>(palette.steps.size() - 1);
  const float at = std::clamp(share, 0.0f, 1.0f) * last;
  const auto below = static_cast<std::size_t>(std::min(at, last - 1));
  const float rest = at - static_cast<float>(below);
  return (1 - rest) * palette.steps[below] + rest * palette.steps[below + 1];
}

const Rgb& ink_on(const Palette& palette, const Rgb& ground) {
  // Relative luminance; 0.18 is where black and white have the same contrast.
  const Rgb linear = ground.array().pow(2.2f);
  return linear.dot(Rgb(0.2126f, 0.7152f, 0.0722f)) > 0.18f ? palette.text : palette.on_colour;
}

namespace {

bool has_kana(const std::string& text) {
  // U+3040 to U+30FF in UTF-8.
  for (std::size_t at = text.find('\xE3'); at != std::string::npos;
       at = text.find('\xE3', at + 1)) {
    const unsigned char next = at + 1 < text.size() ? static_cast<unsigned char>(text[at + 1]) : 0;
    if (next >= 0x81 && next <= 0x83) return true;
  }
  return false;
}

}  // namespace

Fonts load_fonts(ImFontAtlas& atlas, float scale, const std::vector<std::string>& words) {
  require_fonts();
  atlas.Clear();
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  ImFontGlyphRangesBuilder builder;
  builder.AddRanges(atlas.GetGlyphRangesDefault());
  for (const std::string& text : words) builder.AddText(text.c_str());
  for (const char* text : {"–", "…", "“", "”", "’", "%", "°", "×", "½", "¼"}) builder.AddText(text);
  ImVector<ImWchar> shown, written;  // the atlas reads them while it builds
  builder.BuildRanges(&shown);
  const bool japanese = std::any_of(words.begin(), words.end(), has_kana);
  if (japanese) builder.AddRanges(atlas.GetGlyphRangesJapanese());
  builder.BuildRanges(&written);
  const auto font = [&](const char* file, float pixels, const ImVector<ImWchar>& ranges) {
    return add_font(atlas, file, std::round(pixels * scale), ranges.Data);
  };
  Fonts fonts;
  fonts.text = font(latin_file, 16, written);
  fonts.bold = font(latin_bold_file, 16, written);
  fonts.reading = font(latin_file, 20, shown);
  fonts.title = font(latin_file, 24, shown);
  fonts.heading = font(latin_file, 32, shown);
  atlas.Build();
  return fonts;
}

void set_style(float scale, const Palette& palette) {
  ImGuiStyle style;
  style.AntiAliasedLinesUseTex = false;  // the font texture is sampled nearest
  style.WindowBorderSize = 0;
  style.WindowPadding = {0, 0};
  style.FramePadding = {12, 9};
  style.ScrollbarSize = 14;
  style.ScrollbarRounding = 0;
  style.ScaleAllSizes(scale);
  style.Colors[ImGuiCol_Text] = vec(palette.text);
  style.Colors[ImGuiCol_FrameBg] = vec(palette.on_colour);
  style.Colors[ImGuiCol_WindowBg] = {0, 0, 0, 0};
  style.Colors[ImGuiCol_ScrollbarBg] = vec(palette.panel);
  style.Colors[ImGuiCol_ScrollbarGrab] = vec(palette.track);
  style.Colors[ImGuiCol_ScrollbarGrabHovered] = vec(palette.line);
  style.Colors[ImGuiCol_ScrollbarGrabActive] = vec(palette.quiet);
  style.Colors[ImGuiCol_TextSelectedBg] = {0.62f, 0.74f, 0.93f, 1};
  ImGui::GetStyle() = style;
}

}  // namespace promenade::app
