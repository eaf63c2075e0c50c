#include "study/split.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>

namespace promenade::study {
namespace {

constexpr int most_starts = 20;
constexpr std::int64_t most_work = 20'000'000;  // steps: a tenth of a second

// Which places are taken, and how often two of them are so far apart: what makes pairs even.
class Circle {
 public:
  Circle(int places, const std::vector<int>& taken)
      : places_(places), apart_(static_cast<std::size_t>(places), 0) {
    for (const int place : taken) add(place, 1);
  }

  void swap(int out, int in) {
    add(out, -1);
    add(in, 1);
  }

  // The sum of squares of the counts: least where they are even.
  std::int64_t unevenness() const {
    std::int64_t sum = 0;
    for (const std::int64_t count : apart_) sum += count * count;
    return sum;
  }
  const std::vector<int>& taken() const { return taken_; }

 private:
  std::size_t distance(int a, int b) const {
    return static_cast<std::size_t>((a - b + places_) % places_);
  }
  void add(int place, int sign) {
    if (sign < 0) taken_.erase(std::find(taken_.begin(), taken_.end(), place));
    for (const int other : taken_) {
      apart_[distance(place, other)] += sign;
      apart_[distance(other, place)] += sign;
    }
    if (sign > 0) taken_.push_back(place);
  }

  int places_;
  std::vector<int> taken_;
  std::vector<std::int64_t> apart_;
};

// As many places of every rest by `classes`: turned by multiples of it, they cover all equally.
std::vector<int> random_block(int places, int count, int classes, Rng& rng) {
  std::vector<int> block;
  for (int rest = 0; rest < classes; ++rest) {
    std::vector<int> all;
    for (int place = rest; place < places; place += classes) all.push_back(place);
    rng.shuffle(all);
    block.insert(block.end(), all.begin(), all.begin() + count / classes);
  }
  return block;
}

// Swaps one place for a free one of the same rest as long as that helps.
std::vector<int> improved(std::vector<int> block, int places, int classes, std::int64_t& work) {
  Circle circle(places, block);
  std::int64_t best = circle.unevenness();
  for (bool better = true; better && work < most_work;) {
    better = false;
    for (std::size_t i = 0; i < block.size() && work < most_work; ++i) {
      for (int in = block[i] % classes; in < places; in += classes) {
        if (std::find(block.begin(), block.end(), in) != block.end()) continue;
        work += places + 4 * static_cast<std::int64_t>(block.size());
        circle.swap(block[i], in);
        const std::int64_t sum = circle.unevenness();
        if (sum < best) {
          best = sum;
          block[i] = in;
          better = true;
        } else {
          circle.swap(in, block[i]);
        }
      }
    }
  }
  return block;
}

std::vector<int> even_block(int places, int count, Rng& rng) {
  const int classes = std::gcd(places, count);
  std::vector<int> best;
  std::int64_t least = INT64_MAX;
  std::int64_t work = 0;
  for (int start = 0; start < most_starts && (start == 0 || work < most_work); ++start) {
    std::vector<int> block =
        improved(random_block(places, count, classes, rng), places, classes, work);
    const std::int64_t sum = Circle(places, block).unevenness();
    if (sum >= least) continue;
    least = sum;
    best = std::move(block);
  }
  std::sort(best.begin(), best.end());
  return best;
}

// Multiples of `classes`, each once: every next one brings what was rated least so far, so that a
// study that ends within a round is as even as can be.
std::vector<int> even_turns(const std::vector<int>& block, int places, int classes) {
  std::vector<int> left;
  for (int turn = 0; turn < places; turn += classes) left.push_back(turn);
  const auto work = static_cast<std::int64_t>(left.size() * left.size() * block.size());
  if (work > most_work) return left;
  std::vector<std::int64_t> rated(static_cast<std::size_t>(places), 0);
  const auto count_at = [&](int place, int turn) -> std::int64_t& {
    return rated[static_cast<std::size_t>((place + turn) % places)];
  };
  std::vector<int> turns;
  while (!left.empty()) {
    const auto had = [&](int turn) {
      std::int64_t sum = 0;
      for (const int place : block) sum += count_at(place, turn);
      return sum;
    };
    const auto next =
        std::min_element(left.begin(), left.end(), [&](int a, int b) { return had(a) < had(b); });
    for (const int place : block) ++count_at(place, *next);
    turns.push_back(*next);
    left.erase(next);
  }
  return turns;
}

}  // namespace

SplitDesign make_split(int motions, int each, Rng& rng) {
  assert(each >= 1 && each <= motions && "nobody rates more motions than there are");
  SplitDesign split;
  split.motion.resize(static_cast<std::size_t>(motions));
  std::iota(split.motion.begin(), split.motion.end(), 0);
  rng.shuffle(split.motion);
  split.block = even_block(motions, each, rng);
  split.turns = even_turns(split.block, motions, std::gcd(motions, each));
  return split;
}

int round_of_ratings(const SplitDesign& split) {
  return split.motions() / std::gcd(split.motions(), split.each());
}

int round_of_pairs(const SplitDesign& split) { return split.motions(); }

std::vector<int> motions_of(const SplitDesign& split, int sequence) {
  const int n = split.motions();
  const int round = round_of_ratings(split);
  const int classes = n / round;
  // After a round each of its turns goes one place further.
  const int turn =
      split.turns[static_cast<std::size_t>(sequence % round)] + sequence / round % classes;
  std::vector<int> motions;
  for (const int place : split.block) {
    motions.push_back(split.motion[static_cast<std::size_t>((place + turn) % n)]);
  }
  return motions;
}

std::vector<int> repeated_of(const SplitDesign& split, int repeats, int sequence) {
  assert(repeats <= split.each() && "nobody rates a motion a third time");
  const std::vector<int> motions = motions_of(split, sequence);
  std::vector<int> again;
  for (int i = 0; i < repeats; ++i) {
    again.push_back(motions[static_cast<std::size_t>(i * split.each() / repeats)]);
  }
  return again;
}

}  // namespace promenade::study
