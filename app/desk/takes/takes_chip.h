// What the page says of a take: in two or three words on a chip, and in whole sentences.
#pragma once

#include "app/widgets.h"
#include "study/texts.h"
#include "study/workshop.h"

namespace promenade::app {

enum class ChipKind { plain, good, doubt, failed };

struct Chip {
  std::string words;
  ChipKind kind = ChipKind::plain;
};

Chip chip_of(const study::Workshop& shop, std::size_t take, const study::Texts& words);
// Why, and what to do; empty: nothing is wrong.
std::string reason_of(const study::Workshop& shop, std::size_t take, const study::Texts& words);
// "cm", "inch"; "0.05644 m" for what has no name.
std::string unit_name(double unit_m, const study::Texts& words);

// Takes of the set whose unit was guessed and not yet confirmed, and the guess that most of them
// share.
std::vector<std::size_t> guessed_units(const study::Workshop& shop);
double common_guess(const study::Workshop& shop, const std::vector<std::size_t>& guessed);

float chip_width(const Ui& ui, const Chip& chip);
// `box`: as wide as chip_width(), or narrower: then its words lose their middle.
void draw_chip(const Ui& ui, const Box& box, const Chip& chip);

}  // namespace promenade::app
