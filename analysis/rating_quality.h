// How carefully motions were rated: pages whose answers hardly vary or came too fast, and how
// alike people rate a motion that comes a second time (docs/methods.md, 14).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/log.h"
#include "analysis/selection.h"
#include "study/answer_pattern.h"

namespace promenade::analysis {

// One motion as one person rated it on the scales of one instrument.
struct RatedMotion {
  int person = 0;              // index into Dataset::people
  std::string session, trial;  // uuids
  int position = 0;            // in the session, from 1
  std::string task, target, instrument;
  std::vector<std::string> items;           // in the order shown
  std::vector<study::TimedAnswer> answers;  // likewise
  study::AnswerPattern pattern;
};

// Of one person: the pages, and the motions that came again.
struct RaterQuality {
  int person = 0;
  int motions = 0, straight = 0, fast = 0, flagged = 0;  // pages; flagged: for either reason
  int repeated = 0;                       // motions that were rated twice in the session
  int compared = 0;                       // answers of these that were given both times
  std::optional<double> mean_difference;  // absolute, in steps of the scale
  std::optional<double> within_one;       // share that differ by one step at most
  std::optional<double> correlation;      // Pearson's; nothing where one of them does not vary
};

struct RatingQuality {
  std::vector<RatedMotion> motions;  // by person and position
  std::vector<RaterQuality> raters;  // of people who rated anything
};

// Judges pages and compares each motion's first with its last.
RatingQuality rating_quality(std::vector<RatedMotion> motions);

// The pages of people who count, from all files of the log: opens each again, read-only. Throws
// InputError as read_log does.
std::vector<RatedMotion> read_rated_motions(const Log& log, const Selection& selection);

}  // namespace promenade::analysis
