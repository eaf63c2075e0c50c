// What the page "Takes to walks" works on: the workshop, the threads that read captures and cut
// loops for it, and what is looked at now. Draws nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "study/work_queue.h"
#include "study/workshop_recipe.h"

namespace promenade::app {

// A set that is being made, or was.
struct MadeSet {
  bool working = false, stopped = false;
  double share = 0;     // of the work, 0 to 1
  std::string file;     // of the set
  std::string trouble;  // why there is none
  int walks = 0, refused = 0;
  bool done() const { return !working && !file.empty() && trouble.empty() && !stopped; }
};

// What its threads do. Whatever they throw is said of the take.
struct TakesTools {
  std::function<study::ReadCapture(const motion::TakeSource&, const motion::SetOptions&)> read =
      study::read_capture;
  std::function<motion::LoopReview(const motion::Take&, const std::vector<double>& keys,
                                   const motion::SetOptions&)>
      cut = motion::review_loop;
};

class TakesWork {
 public:
  explicit TakesWork(TakesTools tools = {});
  ~TakesWork();
  TakesWork(const TakesWork&) = delete;
  TakesWork& operator=(const TakesWork&) = delete;

  // Files and folders of captures, or a recipe (.toml), which takes the place of all. Why not, for
  // people, when nothing came of it.
  void add(const std::vector<std::string>& paths);
  const std::string& trouble() const { return trouble_; }

  // Time passed: the figures walk, threads have news.
  void advance(std::int64_t now_us);
  bool busy() const;            // captures are read
  std::size_t to_read() const;  // how many

  study::Workshop& shop() { return shop_; }
  const study::Workshop& shop() const { return shop_; }

  // What is looked at; nothing: there is no take.
  std::optional<std::size_t> take() const;
  std::size_t cycle() const;  // of that take: which of its loops
  void look_at(std::size_t take, std::size_t cycle = 0);
  // The walk of the set that it is; nothing: it has none.
  std::optional<study::WalkPlace> walk() const;
  // A walk's loop as it was cut last: while a new one is cut, the one before; null: none was.
  std::shared_ptr<const motion::LoopReview> loop(const study::WalkPlace& walk) const;
  // Takes as the list shows them: what was refused first, what was left out last.
  const std::vector<std::size_t>& listed();
  void step(int by);  // to the next take of the list

  double frame() const { return frame_; }      // of the take that is looked at
  double clock_s() const { return clock_s_; }  // since the page was opened
  void scrub(double frame);
  bool playing() const { return playing_; }
  void play(bool playing) { playing_ = playing; }

  int new_gesture() { return ++gesture_; }

  // Writes the recipe beside the set, and the set.
  void make(const std::string& set_file);
  void stop_making();
  // The recipe alone, where it lies beside the set; made().trouble says why not.
  void save(const std::string& set_file);
  // There are walks, and something was done since they were opened, saved or made.
  bool unsaved() const { return shop_.step() != kept_ && !shop_.walks().empty(); }
  const MadeSet& made() const { return made_; }
  // The set that was made last is not what would be made now.
  bool changed_since_made();

 private:
  struct Making;
  void read_next();
  void cut_next();
  void finish_making();

  TakesTools tools_;
  study::Workshop shop_;
  std::string trouble_;
  std::string looked_at_;  // file
  std::size_t cycle_ = 0;
  std::vector<std::size_t> listed_;
  int sorted_ = -1;  // the revision of the workshop that `listed_` is of
  double frame_ = 0, clock_s_ = 0;
  bool playing_ = true, reading_now_ = false, cutting_now_ = false;
  std::int64_t last_us_ = -1;
  int gesture_ = 0;
  mutable std::map<std::pair<std::string, std::size_t>, std::shared_ptr<const motion::LoopReview>>
      loops_;  // by file and cycle
  MadeSet made_;
  std::string made_of_;  // the recipe
  int kept_ = 0;         // the step of the workshop that is on the disk
  bool changed_ = false;
  int compared_ = -1;  // the revision of the workshop that `changed_` is of
  std::shared_ptr<Making> making_;
  study::WorkQueue reading_, cutting_, maker_;  // last: their threads use the others
};

}  // namespace promenade::app
