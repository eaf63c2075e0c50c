// Where captures become a motion set: the takes that somebody brought, what was found in them, the
// loops that are chosen, and their names. What it decides is a recipe (study/workshop_recipe.h),
// and the set is what `promenade set build` makes of that. Start here to understand the page
// "Takes to walks".
//
// It reads no capture by itself: unread() says what is to be read, read_capture() does it in any
// thread, take_in() takes it in. The same for cutting loops.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "motion/take_review.h"

namespace promenade::study {

// What the recipe says of a take. `source.cycles` are the loops that are chosen.
struct WorkshopTake {
  motion::TakeSource source;
  bool left_out = false;  // by somebody's wish
  bool operator==(const WorkshopTake& other) const;
};

// What reading a capture gave.
struct ReadCapture {
  std::shared_ptr<const motion::TakeReview> review;  // null: it cannot be read
  std::vector<Problem> problems;                     // why
};
ReadCapture read_capture(const motion::TakeSource& source, const motion::SetOptions& options);

enum class TakeState {
  unread,      // not yet
  unreadable,  // there is no take in the file
  no_loop,     // a take, but of something else than a walk
  misfit,      // of another skeleton
  left_out,    // by somebody's wish
  used
};

struct Verdict {
  TakeState state = TakeState::unread;
  std::string reason;  // why it is refused, as `set build` says it
  int line = 0;        // of the file where reading stopped; 0: none
  bool refused() const {
    return state == TakeState::unreadable || state == TakeState::no_loop ||
           state == TakeState::misfit;
  }
};

// A loop to be cut, or that was.
struct LoopOrder {
  std::shared_ptr<const motion::TakeReview> review;
  std::vector<double> keys;  // frames of the take
  auto operator<=>(const LoopOrder&) const = default;
};

// A walk of the set: a loop of a take.
struct WalkPlace {
  std::size_t take = 0, cycle = 0;
  bool operator==(const WalkPlace&) const = default;
};

class Workshop {
 public:
  Workshop();

  // Captures, each with a style guessed from its name; what is there already is passed by. How
  // many were added.
  int add(const std::vector<std::string>& files);
  // Instead of all that is here; undo brings that back. Throws InputError.
  void open(const std::string& recipe);
  const std::string& recipe() const { return state().recipe; }  // that was opened; empty: none

  const std::vector<WorkshopTake>& takes() const { return state().takes; }  // sorted by files
  const motion::SetOptions& options() const { return state().options; }
  std::string label(std::size_t take) const;  // its path below folder()
  std::string folder() const;                 // that all takes lie below
  // Its review; null: not read yet, or not to be read.
  std::shared_ptr<const motion::TakeReview> review(std::size_t take) const;
  const std::vector<Problem>& problems(std::size_t take) const;
  const Verdict& verdict(std::size_t take) const { return verdicts_[take]; }
  std::vector<WalkPlace> walks() const;  // that the set will have
  std::size_t refused() const;

  // What is to be read next, and what it gave.
  std::optional<motion::TakeSource> unread() const;
  void take_in(const motion::TakeSource& source, ReadCapture read);
  // The loop of a walk, and how it is cut; null: not yet.
  LoopOrder order_of(const WalkPlace& walk) const;
  std::shared_ptr<const motion::LoopReview> loop(const WalkPlace& walk) const;
  std::optional<LoopOrder> uncut() const;
  void take_in(const LoopOrder& order, std::shared_ptr<const motion::LoopReview> loop);
  // Cutting it failed for `why`: its take counts as one that cannot be read.
  void refuse(const LoopOrder& order, const ReadCapture& why);

  // What somebody does; each can be undone.
  void describe(const std::string& name, const std::string& credit);
  void choose_loop(const WalkPlace& walk, const std::vector<double>& keys);
  void add_loop(std::size_t take, const std::vector<double>& keys);
  // An end of the loop goes to that frame of the take. All moves of one `gesture` are undone at
  // once.
  void move_end(const WalkPlace& walk, bool last, double frame, int gesture);
  // Nothing changes if the name is empty or another walk has it: false.
  bool rename(const WalkPlace& walk, const std::string& name);
  void remove(const WalkPlace& walk);
  void leave_out(std::size_t take, bool out);
  void forget(std::size_t take);  // it leaves the list
  void set_unit(const std::vector<std::size_t>& takes, double unit_m);
  bool can_undo() const { return now_ > 0; }
  bool can_redo() const { return now_ + 1 < history_.size(); }
  void undo();
  void redo();
  int revision() const { return revision_; }  // grows with all that is seen
  // Of what somebody did: another number after each change, and the same one again after undo.
  int step() const { return state().step; }

 private:
  struct State {
    motion::SetOptions options;
    std::vector<WorkshopTake> takes;
    std::string recipe, recipe_folder;  // that was opened, and where it says the takes are
    int step = 0;
  };
  const State& state() const { return history_[now_]; }
  void commit(State state, int gesture = 0);
  void settle();  // after every change: what follows from it for the state of now
  void choose_missing(State& state) const;
  void name_missing(State& state) const;
  void judge();
  std::string key_of(const motion::TakeSource& source) const;

  std::vector<State> history_;
  std::size_t now_ = 0;
  int gesture_ = 0;  // of the last change; 0: none
  std::map<std::string, ReadCapture> read_;
  std::map<LoopOrder, std::shared_ptr<const motion::LoopReview>> loops_;
  std::vector<Verdict> verdicts_;
  std::vector<const ReadCapture*> found_;  // of each take, in read_; null: not read yet
  int revision_ = 0, steps_ = 0;
};

}  // namespace promenade::study
