#include "motion/take_review.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/cycle_cut.h"

namespace promenade::motion {
namespace {

bool same_place(const FrameRange& a, const FrameRange& b) {
  return a.first <= b.last && b.first <= a.last;
}

// Frozen frames, and jumps that lie in none.
std::vector<FrameRange> losses(const Take& take, const Figure& figure, const TakeStretches& found) {
  std::vector<FrameRange> all = gaps_within(take, figure.gaps);
  for (const FrameRange& jump : found.jumps) {
    const bool known = std::any_of(all.begin(), all.end(),
                                   [&](const FrameRange& one) { return same_place(one, jump); });
    if (!known) all.push_back(jump);
  }
  std::sort(all.begin(), all.end(),
            [](const FrameRange& a, const FrameRange& b) { return a.first < b.first; });
  return all;
}

// What a take without loops shows instead of them.
TakeKind kind_of(const TakeReview& review) {
  if (!review.search.candidates.empty()) return TakeKind::walks;
  const int frames = review.take.frames();
  const int standing = frames_in(review.stretches.standing);
  if (10 * standing > 7 * frames) return TakeKind::stands;
  const bool turns = 2 * review.search.turning > review.search.refused;
  const bool turning = 2 * frames_in(review.stretches.turning) > frames - standing;
  return turns || turning ? TakeKind::turns : TakeKind::no_walk;
}

// Frames of the take that a cycle needs: poses and velocities beside the ends follow from them.
Take part_around(const Take& take, std::vector<double>& keys) {
  constexpr int margin = 3;
  const int from = std::max(static_cast<int>(std::floor(keys.front())) - margin, 0);
  const int to = std::min(static_cast<int>(std::ceil(keys.back())) + margin, take.frames() - 1);
  for (double& key : keys) key -= from;
  return part(take, from, to);
}

MotionSet empty_set(const Take& take, const SetOptions& options) {
  MotionSet set;
  set.skeleton = take.skeleton;
  set.body = take.body;
  set.phases = options.phases;
  set.key_phases = options.key_phases;
  set.walk = options.walk;
  return set;
}

}  // namespace

TakeReview review_take(const TakeSource& source, const SetOptions& options) {
  ReadTake read = read_take(source, {options.recipe, options.figure});
  TakeReview review;
  review.figure = std::move(read.figure);
  review.warnings = std::move(read.warnings);
  const bool said = source.figure.unit_m || options.figure.unit_m;
  review.unit_guessed =
      !said && std::any_of(review.warnings.begin(), review.warnings.end(), [](const Problem& one) {
        return one.message.starts_with("the file does not say its unit");
      });
  review.take = unrolled(std::move(read.take));
  review.contacts = find_contacts(review.take);
  review.search = options.walk ? find_cycles(review.take, review.contacts, options.search)
                               : find_any_loops(review.take, options.search);
  review.stretches = find_stretches(review.take);
  review.gaps = losses(review.take, review.figure, review.stretches);
  review.kind = kind_of(review);
  return review;
}

LoopReview review_loop(const Take& take, const std::vector<double>& keys,
                       const SetOptions& options) {
  LoopReview review;
  review.cut = given_cycle(take, keys);
  review.seam_m = review.cut.loop_error_m;
  CycleCandidate within = review.cut;
  const Take around = part_around(take, within.keys);
  review.set = empty_set(take, options);
  Cycle cycle = cut_cycle(review.set, around, within);
  if (options.walk) {
    const double level = toe_level(review.set, cycle);
    cycle.root.row(1).array() += floor_level(level) - level;
    review.moved_m = plant_feet(review.set, cycle).moved_m;
    review.slide_m = std::max(stance_slide_m(review.set, cycle, Side::left),
                              stance_slide_m(review.set, cycle, Side::right));
  }
  review.set.cycles.push_back(std::move(cycle));
  return review;
}

std::vector<double> with_end_at(const Take& take, std::vector<double> keys, bool last,
                                double frame) {
  assert(keys.size() >= 2 && "the keytimes of a cycle");
  constexpr double least = 1;  // frames between two keytimes
  if (last) {
    const double before = std::max(keys[keys.size() - 2] + least, keys.front() + 2);
    keys.back() = std::clamp(frame, before, std::max(before, take.frames() - 1.0));
  } else {
    const double after = std::min(keys[1] - least, keys.back() - 2);
    keys.front() = std::clamp(frame, std::min(0.0, after), after);
  }
  return keys;
}

}  // namespace promenade::motion
