#include "app/shelf.h"

#include <algorithm>
#include <cmath>

#include "study/utf8.h"

namespace promenade::app {
namespace {

using study::Applied;
using study::ControlInput;

}  // namespace

Shelf::Shelf(const motion::MotionSet& set, const Eigen::Matrix2Xd* points, Eigen::VectorXd start)
    : set_(&set), points_(points), start_(std::move(start)) {}

const Bookmark* Shelf::find_bookmark(int number) const {
  const auto found =
      std::find_if(bookmarks_.begin(), bookmarks_.end(),
                   [&](const Bookmark& bookmark) { return bookmark.number == number; });
  return found == bookmarks_.end() ? nullptr : &*found;
}

Bookmark* Shelf::bookmark_of(const std::string& target) {
  for (Bookmark& bookmark : bookmarks_) {
    if (target.size() == 1 && target[0] - '0' == bookmark.number) return &bookmark;
  }
  return nullptr;
}

std::optional<Item> Shelf::item_of(const std::string& target) const {
  if (target.size() == 2 && target[0] == '#' && find_bookmark(target[1] - '0') != nullptr) {
    return Item{.bookmark = target[1] - '0'};
  }
  const int example = motion::find_cycle(*set_, target);
  if (example < 0) return std::nullopt;
  return Item{.example = example};
}

std::string_view Shelf::target_of(const Item& item) const {
  constexpr std::string_view marks = "#1#2#3#4#5#6#7#8#9";
  if (item.bookmark > 0) return marks.substr(2 * static_cast<std::size_t>(item.bookmark) - 2, 2);
  if (item.example < 0) return {};
  return set_->cycles[static_cast<std::size_t>(item.example)].name;
}

Applied Shelf::apply(const ControlInput& input, const Spot& here) {
  if (input.kind == "goto") {
    const Bookmark* bookmark = bookmark_of(input.target);
    if (bookmark == nullptr) return Applied::refused;
    go({.bookmark = bookmark->number});
    return Applied::done;
  }
  if (input.kind == "bookmark") return keep(input.target, here);
  if (input.kind == "rename") return rename(input);
  if (input.kind == "remove") return remove(input.target, here);
  if (input.kind == "mix") return mix(input.target);
  if (input.kind == "share") return share(input);
  if (input.kind == "unmix") return unmix(input.target, here);
  return open(input);
}

void Shelf::go(const Item& item) {
  held_ = spot_of(item);
  current_ = item;
  offered_ = {};
  edited_ = 0;
  shown_ = Shown::item;
}

void Shelf::leave() {
  current_ = offered_ = {};
  edited_ = 0;
  shown_ = Shown::own;
}

Applied Shelf::keep(const std::string& target, const Spot& here) {
  const std::optional<Item> item = item_of(target);
  if (!target.empty() && !item) return Applied::refused;
  if (bookmarks_.size() == most_bookmarks) return Applied::refused;
  int number = 1;
  while (find_bookmark(number) != nullptr) ++number;
  const auto place =
      std::find_if(bookmarks_.begin(), bookmarks_.end(),
                   [&](const Bookmark& bookmark) { return bookmark.number > number; });
  const bool is_shown = target.empty() || *item == current_;
  bookmarks_.insert(place, {number, "", target.empty() ? here : spot_of(*item)});
  offered_ = {};
  edited_ = 0;
  // The mixture stays what is shown: its sliders go on.
  if (is_shown && shown_ != Shown::mixture) go({.bookmark = number});
  return Applied::done;
}

Applied Shelf::rename(const ControlInput& input) {
  Bookmark* bookmark = bookmark_of(input.target);
  if (bookmark == nullptr) return Applied::refused;
  std::string name(study::first_characters(input.text, longest_bookmark_name));
  if (name == bookmark->name) return Applied::aside;
  bookmark->name = std::move(name);
  return Applied::done;
}

Applied Shelf::remove(const std::string& target, const Spot& here) {
  const Bookmark* bookmark = bookmark_of(target);
  if (bookmark == nullptr) return Applied::refused;
  const Item item{.bookmark = bookmark->number};
  if (const auto part = part_of(item); part != mixture_.end()) take_out(part, here);
  bookmarks_.erase(bookmarks_.begin() + (bookmark - bookmarks_.data()));
  if (current_ == item) current_ = {};  // its walk goes on, without a name
  if (offered_ == item) offered_ = {};
  if (edited_ == item.bookmark) edited_ = 0;
  return Applied::done;
}

std::vector<Ingredient>::iterator Shelf::part_of(const Item& item) {
  return std::find_if(mixture_.begin(), mixture_.end(),
                      [&](const Ingredient& part) { return part.item == item; });
}

Applied Shelf::mix(const std::string& target) {
  const std::optional<Item> item = item_of(target);
  if (!item || part_of(*item) != mixture_.end()) return Applied::refused;
  mixture_.push_back({*item});
  leave();
  shown_ = Shown::mixture;
  return Applied::done;
}

Applied Shelf::share(const ControlInput& input) {
  const std::optional<Item> item = item_of(input.target);
  if (!item || !(input.value >= 0 && input.value <= 1)) return Applied::refused;
  const auto part = part_of(*item);
  if (part == mixture_.end()) return Applied::refused;
  part->share = input.value;
  leave();
  shown_ = Shown::mixture;
  return Applied::done;
}

Applied Shelf::unmix(const std::string& target, const Spot& here) {
  const std::optional<Item> item = item_of(target);
  if (!item || part_of(*item) == mixture_.end()) return Applied::refused;
  take_out(part_of(*item), here);
  return Applied::done;
}

// A mixture of nothing cannot be shown: the walk stays as it was.
void Shelf::take_out(std::vector<Ingredient>::iterator part, const Spot& here) {
  mixture_.erase(part);
  if (!mixture_.empty() || shown_ != Shown::mixture) return;
  held_ = here;
  shown_ = Shown::item;
}

Applied Shelf::open(const ControlInput& input) {
  if (input.kind == "offer") {
    const std::optional<Item> item = item_of(input.target);
    if (!item && !input.target.empty()) return Applied::refused;
    offered_ = item.value_or(Item{});
    edited_ = 0;
    return Applied::aside;
  }
  if (input.kind != "edit") return Applied::refused;
  const Bookmark* bookmark = bookmark_of(input.target);
  if (bookmark == nullptr && !input.target.empty()) return Applied::refused;
  edited_ = bookmark != nullptr ? bookmark->number : 0;
  if (edited_ > 0) offered_ = {.bookmark = edited_};
  return Applied::aside;
}

double Shelf::share_sum() const {
  double sum = 0;
  for (const Ingredient& part : mixture_) sum += part.share;
  return sum;
}

Spot Shelf::spot_of(const Item& item) const {
  if (const Bookmark* bookmark = find_bookmark(item.bookmark)) return bookmark->spot;
  Spot spot{Eigen::VectorXd::Unit(start_.size(), item.example)};
  if (points_ != nullptr) spot.point = points_->col(item.example);
  return spot;
}

void Shelf::add_weights(const Item& item, double share, Eigen::VectorXd& weights) const {
  if (const Bookmark* bookmark = find_bookmark(item.bookmark)) {
    weights += share * bookmark->spot.weights;
  } else {
    weights(item.example) += share;
  }
}

bool Shelf::weights(Eigen::VectorXd& weights) const {
  if (shown_ == Shown::own) return false;
  if (shown_ == Shown::item) {
    weights = held_.weights;
    return true;
  }
  // All at zero asks for nothing: the start is shown.
  const double sum = share_sum();
  weights = start_;
  if (sum <= 0) return true;
  weights.setZero();
  for (const Ingredient& part : mixture_) add_weights(part.item, part.share / sum, weights);
  return true;
}

Eigen::Vector2d Shelf::point() const {
  if (shown_ == Shown::item) return held_.point;
  if (points_ == nullptr) return Eigen::Vector2d::Zero();
  const double sum = share_sum();
  if (sum <= 0) return *points_ * start_;
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  for (const Ingredient& part : mixture_) {
    const Bookmark* bookmark = find_bookmark(part.item.bookmark);
    const Eigen::Vector2d at = bookmark != nullptr
                                   ? bookmark->spot.point
                                   : Eigen::Vector2d(points_->col(part.item.example));
    point += part.share / sum * at;
  }
  return point;
}

void Shelf::propose(std::vector<ControlInput>& ideas, study::Rng& rng) const {
  for (const Bookmark& bookmark : bookmarks_) {
    if (current_.bookmark == bookmark.number) continue;
    ideas.push_back({.kind = "goto", .target = std::to_string(bookmark.number)});
  }
  const bool can_keep = current_.bookmark == 0 && bookmarks_.size() < most_bookmarks;
  if (can_keep && rng.uniform() < 0.05) ideas.push_back({.kind = "bookmark", .target = ""});
  if (!offered_.empty()) return;  // it hides the mixture
  if (mixture_.size() < 2) return;
  const Ingredient& part = mixture_[rng.below(mixture_.size())];
  ideas.push_back(
      {.kind = "share", .target = std::string(target_of(part.item)), .value = rng.uniform()});
}

void Shelf::add_settings(std::vector<ControlInput>& settings) const {
  for (const Ingredient& part : mixture_) {
    settings.push_back({.kind = "mix", .target = std::string(target_of(part.item))});
    settings.push_back(
        {.kind = "share", .target = std::string(target_of(part.item)), .value = part.share});
  }
}

}  // namespace promenade::app
