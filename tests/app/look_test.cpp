// Colours that can be told apart without hues, by computation.
#include "app/look.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace promenade::app {
namespace {

Eigen::Vector3d linear(const Rgb& colour) {
  Eigen::Vector3d light;
  for (int k = 0; k < 3; ++k) {
    const double c = colour[k];
    light[k] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return light;
}

// Machado, Oliveira and Fernandes 2009, deuteranopia (severity 1), on linear light.
Eigen::Vector3d deuteranopic(const Eigen::Vector3d& light) {
  Eigen::Matrix3d view;
  view << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
      0.968881;
  return (view * light).cwiseMax(0).cwiseMin(1);
}

double luminance(const Eigen::Vector3d& light) {
  return light.dot(Eigen::Vector3d(0.2126, 0.7152, 0.0722));
}

// CIE L*.
double lightness(const Eigen::Vector3d& light) {
  const double y = luminance(light);
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

// WCAG 2.
double contrast(const Rgb& a, const Rgb& b) {
  const double one = luminance(linear(a)) + 0.05;
  const double other = luminance(linear(b)) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

double apart_for_deuteranopes(const Rgb& a, const Rgb& b) {
  return std::abs(lightness(deuteranopic(linear(a))) - lightness(deuteranopic(linear(b))));
}

TEST(Look, LightnessOfWhiteIs100AndOfMiddleGreyIsAsPublished) {
  EXPECT_NEAR(lightness(linear(rgb(0xFFFFFF))), 100, 0.01);
  EXPECT_NEAR(lightness(linear(rgb(0x777777))), 50.0, 0.1);
}

TEST(Look, TargetAndCreatedDifferInLightnessForDeuteranopes) {
  const Palette palette = make_palette(false);
  EXPECT_GE(apart_for_deuteranopes(palette.target, palette.created), 15);
}

TEST(Look, BothFiguresStandOutFromTheBackground) {
  const Palette palette = make_palette(false);
  EXPECT_GE(apart_for_deuteranopes(palette.target, palette.background), 15);
  EXPECT_GE(apart_for_deuteranopes(palette.created, palette.background), 15);
}

TEST(Look, AnswersStandOutFromWhatHasNoneAndTheEndsFromTheMiddle) {
  const Palette palette = make_palette(false);
  for (const Rgb& step : palette.steps) {
    EXPECT_GE(apart_for_deuteranopes(step, palette.on_colour), 15);
  }
  EXPECT_GE(apart_for_deuteranopes(palette.steps[0], palette.steps[1]), 15);
  EXPECT_GE(apart_for_deuteranopes(palette.steps[4], palette.steps[3]), 15);
  EXPECT_EQ(step_colour(palette, 0), palette.steps[0]);
  EXPECT_EQ(step_colour(palette, 0.5f), palette.steps[2]);
  EXPECT_EQ(step_colour(palette, 1), palette.steps[4]);
}

TEST(Look, TextCanBeRead) {
  const Palette palette = make_palette(false);
  EXPECT_GE(contrast(palette.text, palette.background), 7);
  EXPECT_GE(contrast(palette.quiet, palette.background), 4.5);
  EXPECT_GE(contrast(palette.on_colour, palette.created), 4.5);
  EXPECT_GE(contrast(palette.text, palette.target), 4.5);
}

TEST(Look, PaperColoursAreGreenAndBlue) {
  const Palette palette = make_palette(true);
  EXPECT_GT(palette.target.y(), palette.target.x() + palette.target.z());
  EXPECT_GT(palette.created.z(), palette.created.x() + palette.created.y());
}

TEST(Look, NoTextIsBelow16Pixels) {
  ImGui::CreateContext();
  const Fonts fonts = load_fonts(*ImGui::GetIO().Fonts, 1, {});
  for (const ImFont* font : {fonts.text, fonts.bold, fonts.reading, fonts.title, fonts.heading}) {
    // The line of Noto Sans is 1.362 em.
    EXPECT_GE(font->FontSize, std::floor(16 * 1.362f));
  }
  ImGui::DestroyContext();
}

// Is there a picture for each of these?
bool has_all(const ImFont& font, std::initializer_list<ImWchar> letters) {
  return std::all_of(letters.begin(), letters.end(),
                     [&](ImWchar letter) { return font.FindGlyphNoFallback(letter) != nullptr; });
}

TEST(Fonts, WhatPeopleWriteInJapaneseHasItsCharacters) {
  ImFontAtlas atlas;
  const Fonts fonts = load_fonts(atlas, 2, {"次へ"});
  for (const ImFont* font : {fonts.text, fonts.bold}) {
    EXPECT_TRUE(has_all(*font, {0x697D, 0x3057, 0x305D, 0x3046, 0x30AB}));
  }
  EXPECT_FALSE(has_all(*fonts.heading, {0x697D})) << "nobody writes headings";
  EXPECT_LE(std::max(atlas.TexWidth, atlas.TexHeight), 8192) << "of the smallest cards";
}

TEST(Fonts, AStudyWithoutJapaneseHasASmallAtlas) {
  ImFontAtlas atlas;
  const Fonts fonts = load_fonts(atlas, 2, {"Next", "日本語"});
  EXPECT_FALSE(has_all(*fonts.text, {0x697D}));
  EXPECT_TRUE(has_all(*fonts.text, {0x65E5, 0x672C, 0x8A9E}));
}

}  // namespace
}  // namespace promenade::app
