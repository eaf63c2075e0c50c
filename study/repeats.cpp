#include "study/repeats.h"

#include <algorithm>
#include <utility>

namespace promenade::study {
namespace {

class Arrangement {
 public:
  Arrangement(std::vector<int> order, const std::vector<int>& again, bool fixed)
      : order_(std::move(order)), again_(again) {
    const auto count = static_cast<int>(order_.size());
    const auto repeats = static_cast<int>(again_.size());
    mixed_ = fixed ? 0 : std::min(repeats, count - repeats);
  }

  // The last new motions, between which repeats stand, are none that come again.
  void clear_the_end() {
    const int head = size() - mixed_;
    int free = head - 1;
    for (int i = head; i < size(); ++i) {
      if (!comes_again(i)) continue;
      while (comes_again(free)) --free;
      std::swap(at(i), at(free));
    }
  }

  // Moves first showings to the front, where the second would come too soon.
  void spread() {
    for (std::size_t moves = 0; moves < again_.size() && move_one(); ++moves) {
    }
  }

  std::vector<Showing> showings() const {
    std::vector<int> seconds;
    for (const int place : first_places())
      seconds.push_back(order_[static_cast<std::size_t>(place)]);
    std::vector<Showing> all;
    std::size_t next = 0;
    for (int i = 0; i < size(); ++i) {
      all.push_back({order_[static_cast<std::size_t>(i)], 1});
      if (i >= size() - mixed_) all.push_back({seconds[next++], 2});
    }
    for (; next < seconds.size(); ++next) all.push_back({seconds[next], 2});
    return all;
  }

 private:
  int size() const { return static_cast<int>(order_.size()); }
  int& at(int place) { return order_[static_cast<std::size_t>(place)]; }
  bool comes_again(int place) const {
    const int motion = order_[static_cast<std::size_t>(place)];
    return std::find(again_.begin(), again_.end(), motion) != again_.end();
  }
  std::vector<int> first_places() const {
    std::vector<int> places;
    for (int i = 0; i < size(); ++i) {
      if (comes_again(i)) places.push_back(i);
    }
    return places;
  }
  // False: none comes too soon, or there is no better place.
  bool move_one() {
    const std::vector<int> places = first_places();
    for (int j = 0; j < static_cast<int>(places.size()); ++j) {
      const int place = places[static_cast<std::size_t>(j)];
      if (second_place(j) - place > least_between) continue;
      const int to = better_place(std::min(place, second_place(j) - least_between) - 1);
      if (to < 0 || to >= place) continue;
      std::swap(at(place), at(to));
      return true;
    }
    return false;
  }

  // The last one up to `latest` whose motion comes only once; else the first of all.
  int better_place(int latest) const {
    for (int place = latest; place >= 0; --place) {
      if (!comes_again(place)) return place;
    }
    int place = 0;
    while (place < size() && comes_again(place)) ++place;
    return place;
  }

  // Of the j-th repeat, among all trials.
  int second_place(int j) const { return j < mixed_ ? size() - mixed_ + 2 * j + 1 : size() + j; }

  std::vector<int> order_;
  const std::vector<int>& again_;
  int mixed_ = 0;  // so many of the last new motions are followed by a repeat
};

}  // namespace

std::vector<Showing> with_repeats(std::vector<int> order, const std::vector<int>& again,
                                  bool fixed) {
  Arrangement arrangement(std::move(order), again, fixed);
  if (!fixed) {
    arrangement.clear_the_end();
    arrangement.spread();
  }
  return arrangement.showings();
}

}  // namespace promenade::study
