// Bookmarks and a mixture: what the map and the list of labels let people do with the
// walks that they come to, so that only the presentation differs. A part of the state of
// an interface, with its rule: no clock, no UI. Inputs, by kind and target:
//
//   goto      1            shows a bookmark
//   bookmark  "" or happy  keeps what is shown, or that example
//   rename    1, TEXT      names a bookmark
//   remove    1            forgets it
//   mix       happy or #1  one more part of the mixture
//   share     happy or #1  its share, value 0 to 1
//   unmix     happy or #1  takes it out
//   offer     happy or #1  opens what else can be done with it (aside)
//   edit      1            opens its name (aside)
#pragma once

#include <optional>

#include "study/interface.h"

namespace promenade::app {

constexpr int most_bookmarks = 9;
constexpr int longest_bookmark_name = 40;  // characters

// A walk that can be gone to again: an example or a bookmark.
struct Item {
  int example = -1;  // -1: none
  int bookmark = 0;  // its number, 1 to 9; 0: none
  bool operator==(const Item&) const = default;
  bool empty() const { return example < 0 && bookmark == 0; }
};

// A walk, and where it lies on a map if there is one.
struct Spot {
  Eigen::VectorXd weights;  // N
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
};

struct Bookmark {
  int number = 0;
  std::string name;  // empty: nobody named it
  Spot spot;
};

struct Ingredient {
  Item item;
  double share = 0.5;  // 0 to 1; what counts is its share of their sum
};

class Shelf {
 public:
  enum class Shown { own, item, mixture };  // own: what the interface itself says

  // `points`: 2 x N, where the examples lie; null: there is no map. Both outlive it.
  Shelf(const motion::MotionSet& set, const Eigen::Matrix2Xd* points, Eigen::VectorXd start);

  // Of InterfaceState::apply. `here`: what is shown now.
  study::Applied apply(const study::ControlInput& input, const Spot& here);
  void go(const Item& item);  // shows it
  void leave();               // the interface shows what is its own

  Shown shown() const { return shown_; }
  // Of what the shelf shows; false: that is the interface's own. Allocation-free when
  // `weights` has N.
  bool weights(Eigen::VectorXd& weights) const;
  Eigen::Vector2d point() const;  // of what the shelf shows

  const motion::MotionSet& set() const { return *set_; }
  const std::vector<Bookmark>& bookmarks() const { return bookmarks_; }  // by number
  const Bookmark* find_bookmark(int number) const;                       // null: none
  const std::vector<Ingredient>& mixture() const { return mixture_; }
  double share_sum() const;
  const Item& current() const { return current_; }  // what is shown; empty: not one of these
  const Item& offered() const { return offered_; }  // whose rest is on offer
  int edited() const { return edited_; }            // the bookmark whose name is open; 0: none

  // What a person might do next here.
  void propose(std::vector<study::ControlInput>& ideas, study::Rng& rng) const;
  // The mixture, as inputs that would set it.
  void add_settings(std::vector<study::ControlInput>& settings) const;

  // "happy", "#1"; nothing: there is none.
  std::optional<Item> item_of(const std::string& target) const;
  std::string_view target_of(const Item& item) const;

 private:
  study::Applied keep(const std::string& target, const Spot& here);
  study::Applied rename(const study::ControlInput& input);
  study::Applied remove(const std::string& target, const Spot& here);
  study::Applied mix(const std::string& target);
  study::Applied share(const study::ControlInput& input);
  study::Applied unmix(const std::string& target, const Spot& here);
  study::Applied open(const study::ControlInput& input);

  Bookmark* bookmark_of(const std::string& target);
  std::vector<Ingredient>::iterator part_of(const Item& item);
  void take_out(std::vector<Ingredient>::iterator part, const Spot& here);
  Spot spot_of(const Item& item) const;
  void add_weights(const Item& item, double share, Eigen::VectorXd& weights) const;

  const motion::MotionSet* set_;
  const Eigen::Matrix2Xd* points_;
  Eigen::VectorXd start_;
  std::vector<Bookmark> bookmarks_;
  std::vector<Ingredient> mixture_;
  Shown shown_ = Shown::own;
  Item current_, offered_;
  Spot held_;  // what is shown when shown_ is item
  int edited_ = 0;
};

}  // namespace promenade::app
