#include "app/desk/takes/takes_chip.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace promenade::app {
namespace {

using motion::TakeKind;
using study::TakeState;

const char* key_of(TakeKind kind) {
  constexpr std::array<const char*, 4> keys = {"walks", "turns", "stands", "no_walk"};
  return keys[static_cast<std::size_t>(kind)];
}

std::string loops(std::size_t count, const study::Texts& words) {
  return count == 1 ? words("takes.loop")
                    : words.with("takes.loops", {{"count", std::to_string(count)}});
}

bool is_guessed(const study::Workshop& shop, std::size_t take) {
  const auto review = shop.review(take);
  return review && review->unit_guessed && !shop.takes()[take].source.figure.unit_m;
}

// Does a chosen loop run over a gap?
bool runs_over_gap(const study::Workshop& shop, std::size_t take) {
  const auto review = shop.review(take);
  for (const motion::GivenCycle& cycle : shop.takes()[take].source.cycles) {
    const double first = cycle.frames.front() - review->take.first_frame;
    const double last = cycle.frames.back() - review->take.first_frame;
    for (const motion::FrameRange& gap : review->gaps) {
      if (gap.first < last && gap.last > first) return true;
    }
  }
  return false;
}

// Of a take that the set uses.
Chip used_chip(const study::Workshop& shop, std::size_t take, const study::Texts& words) {
  const auto review = shop.review(take);
  if (runs_over_gap(shop, take)) return {words("takes.gap_in_loop"), ChipKind::doubt};
  if (is_guessed(shop, take)) {
    const double unit = review->figure.unit_m;
    if (unit != common_guess(shop, guessed_units(shop))) {
      return {words.with("takes.unit_guessed", {{"unit", unit_name(unit, words)}}),
              ChipKind::doubt};
    }
  }
  return {loops(std::max<std::size_t>(review->search.candidates.size(), 1), words), ChipKind::good};
}

}  // namespace

std::string unit_name(double unit_m, const study::Texts& words) {
  const std::array<std::pair<double, const char*>, 5> known = {
      {{1, "m"}, {0.01, "cm"}, {0.0254, "inch"}, {0.001, "mm"}, {0.0254 / 0.45, "cmu"}}};
  for (const auto& [metres, key] : known) {
    if (std::abs(unit_m / metres - 1) < 1e-9) return words(fmt::format("takes.unit.{}", key));
  }
  return fmt::format("{:.4g} m", unit_m);
}

std::vector<std::size_t> guessed_units(const study::Workshop& shop) {
  std::vector<std::size_t> guessed;
  for (std::size_t t = 0; t < shop.takes().size(); ++t) {
    if (is_guessed(shop, t) && shop.verdict(t).state == TakeState::used) guessed.push_back(t);
  }
  return guessed;
}

double common_guess(const study::Workshop& shop, const std::vector<std::size_t>& guessed) {
  std::map<double, int> counts;
  for (const std::size_t t : guessed) ++counts[shop.review(t)->figure.unit_m];
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? 1 : most->first;
}

Chip chip_of(const study::Workshop& shop, std::size_t take, const study::Texts& words) {
  const study::Verdict& verdict = shop.verdict(take);
  switch (verdict.state) {
    case TakeState::unread:
      return {words("takes.chip.unread"), ChipKind::plain};
    case TakeState::unreadable:
      if (verdict.line == 0) return {words("takes.chip.unreadable"), ChipKind::failed};
      return {words.with("takes.chip.unreadable_line", {{"line", std::to_string(verdict.line)}}),
              ChipKind::failed};
    case TakeState::no_loop:
      return {words(fmt::format("takes.chip.{}", key_of(shop.review(take)->kind))),
              ChipKind::failed};
    case TakeState::misfit:
      return {words("takes.chip.misfit"), ChipKind::failed};
    case TakeState::left_out:
      return {words("takes.chip.left_out"), ChipKind::plain};
    case TakeState::used:
      break;
  }
  return used_chip(shop, take, words);
}

std::string reason_of(const study::Workshop& shop, std::size_t take, const study::Texts& words) {
  const study::Verdict& verdict = shop.verdict(take);
  std::string plain;
  if (verdict.state == TakeState::unreadable) {
    plain = verdict.line > 0
                ? words.with("takes.why.unreadable_line", {{"line", std::to_string(verdict.line)}})
                : words("takes.why.unreadable");
  } else if (verdict.state == TakeState::no_loop) {
    plain = words(fmt::format("takes.why.{}", key_of(shop.review(take)->kind)));
  } else if (verdict.state == TakeState::misfit) {
    plain = words("takes.why.misfit");
  } else if (verdict.state == TakeState::left_out) {
    return words("takes.why.left_out");
  } else {
    const bool gap = verdict.state == TakeState::used && runs_over_gap(shop, take);
    return gap ? words("takes.why.gap") : "";
  }
  return plain + "\n" + words.with("takes.why.exactly", {{"reason", verdict.reason}});
}

float chip_width(const Ui& ui, const Chip& chip) {
  ImFont* const font = chip.kind == ChipKind::failed ? ui.look.fonts.bold : ui.look.fonts.text;
  return std::ceil(text_width(font, chip.words)) + ui.layout.size(18);
}

void draw_chip(const Ui& ui, const Box& box, const Chip& chip) {
  const Palette& palette = ui.look.palette;
  const std::array<Rgb, 4> grounds = {palette.hover, palette.known, palette.pilot, palette.alarm};
  const Rgb& ground = grounds[static_cast<std::size_t>(chip.kind)];
  const bool failed = chip.kind == ChipKind::failed;
  const Rgb ink = chip.kind == ChipKind::plain  ? palette.quiet
                  : chip.kind == ChipKind::good ? palette.text
                                                : ink_on(palette, ground);
  fill(box, ground);
  draw_line(failed ? ui.look.fonts.bold : ui.look.fonts.text,
            {box.x + ui.layout.size(8), box.y, box.width - ui.layout.size(14), box.height}, ink,
            chip.words);
}

}  // namespace promenade::app
