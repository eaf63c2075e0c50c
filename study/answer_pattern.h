// Was a motion judged, or were the answers only filled in? How much they vary in the order in
// which they were shown, and how fast they came (docs/methods.md, 14). A sign, not a proof: a walk
// with nothing special about it has many equal answers, too.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace promenade::study {

struct TimedAnswer {
  double value = 0;
  std::int64_t t_us = 0;  // when it was given
};

struct AnswerPattern {
  int items = 0;
  int longest_run = 0;             // of equal answers, in the order shown
  int distinct = 0;                // different values
  std::optional<double> median_s;  // from one answer to the next; nothing for fewer than two
  bool straight = false;           // they hardly vary
  bool fast = false;               // faster than anybody can read
  bool flagged() const { return straight || fast; }
};

// Ours: fewer items than this are too few to tell anything by their values, or by their times.
constexpr int least_items_to_vary = 12;
constexpr int least_items_to_time = 4;
constexpr double straight_run_share = 0.5;  // a run of so many of the items
constexpr double fastest_s = 0.6;           // for two words, a look and a press

// Answers to the scales of one page, in the order shown.
AnswerPattern answer_pattern(const std::vector<TimedAnswer>& answers);

}  // namespace promenade::study
