#include "study/workshop.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <set>

#include "motion/files.h"
#include "motion/shared_skeleton.h"
#include "study/capture_files.h"
#include "study/recipe.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;
using motion::GivenCycle;
using motion::TakeSource;

// Hundredths of a frame: finer than a frame says anything, and a number that people can read.
double rounded(double frame) { return std::round(100 * frame) / 100; }

// Keytimes of a take as frames of its file.
std::vector<double> frames_of(const motion::Take& take, const std::vector<double>& keys) {
  const double first = take.first_frame, last = first + take.frames() - 1.0;
  std::vector<double> frames;
  frames.reserve(keys.size());
  for (const double key : keys) frames.push_back(std::clamp(rounded(key + first), first, last));
  return frames;
}

bool same_cycles(const std::vector<GivenCycle>& a, const std::vector<GivenCycle>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const GivenCycle& one, const GivenCycle& other) {
                      return one.name == other.name && one.frames == other.frames;
                    });
}

// Its name without a number at the end: "happy_2" is of the style "happy".
std::string style_in(const std::string& name) {
  const std::size_t at = name.find_last_not_of("0123456789");
  const bool numbered = at != std::string::npos && at + 1 < name.size() && at > 0;
  return numbered && name[at] == '_' ? name.substr(0, at) : name;
}

std::string trouble_of(const WorkshopTake& take, const motion::Take& read) {
  for (const GivenCycle& cycle : take.source.cycles) {
    std::vector<double> keys = cycle.frames;
    for (double& key : keys) key -= read.first_frame;
    const std::string trouble = motion::trouble_with_keys(read, keys);
    if (!trouble.empty()) return trouble;
  }
  return {};
}

std::set<std::string> names_in(const std::vector<WorkshopTake>& takes) {
  std::set<std::string> names;
  for (const WorkshopTake& take : takes) {
    for (const GivenCycle& cycle : take.source.cycles) names.insert(cycle.name);
  }
  return names;
}

std::string free_name(const std::string& style, const std::set<std::string>& taken) {
  for (int number = 1;; ++number) {
    std::string name = style + "_" + std::to_string(number);
    if (!taken.contains(name)) return name;
  }
}

std::string message_of(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) text += (text.empty() ? "" : "; ") + problem.message;
  return text;
}

}  // namespace

bool WorkshopTake::operator==(const WorkshopTake& other) const {
  const TakeSource &a = source, &b = other.source;
  return a.file == b.file && a.style == b.style && a.from == b.from && a.to == b.to &&
         a.figure.unit_m == b.figure.unit_m && left_out == other.left_out &&
         same_cycles(a.cycles, b.cycles);
}

ReadCapture read_capture(const TakeSource& source, const motion::SetOptions& options) {
  try {
    return {std::make_shared<const motion::TakeReview>(motion::review_take(source, options)), {}};
  } catch (const InputError& error) {
    return {nullptr, error.problems()};
  }
}

Workshop::Workshop() : history_(1) { history_[0].options.name = "walks"; }

int Workshop::add(const std::vector<std::string>& files) {
  State next = state();
  const std::vector<std::string> styles = styles_of(files);
  int added = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const bool known =
        std::any_of(next.takes.begin(), next.takes.end(),
                    [&](const WorkshopTake& take) { return take.source.file == files[i]; });
    if (known) continue;
    next.takes.push_back({{files[i], "", styles[i]}});
    ++added;
  }
  if (added > 0) commit(std::move(next));
  return added;
}

void Workshop::open(const std::string& recipe_file) {
  Recipe recipe = load_recipe(recipe_file);
  State next;
  next.options = recipe.options;
  next.options.recipe.clear();
  const auto take_over = [&](const std::vector<TakeSource>& sources, bool left_out) {
    for (TakeSource source : sources) {
      std::error_code error;
      source.file = fs::absolute(source.file, error).lexically_normal().generic_string();
      if (source.label == next.options.skeleton) next.options.skeleton = source.file;
      source.place = {};
      for (GivenCycle& cycle : source.cycles) cycle.place = {};
      next.takes.push_back({std::move(source), left_out});
    }
  };
  take_over(recipe.takes, false);
  take_over(recipe.left_out, true);
  std::error_code error;
  next.recipe = fs::absolute(recipe_file, error).lexically_normal().string();
  std::string& folder = next.recipe_folder;
  folder = fs::absolute(recipe.folder, error).lexically_normal().generic_string();
  while (folder.size() > 1 && folder.ends_with('/')) folder.pop_back();
  commit(std::move(next));
}

std::string Workshop::folder() const {
  std::vector<std::string> files;
  for (const WorkshopTake& take : takes()) files.push_back(take.source.file);
  std::string common = common_folder(files);
  const std::string& said = state().recipe_folder;
  const bool below = common == said || common.starts_with(said + "/");
  return !said.empty() && below ? said : common;
}

std::string Workshop::label(std::size_t take) const {
  return fs::path(takes()[take].source.file).lexically_relative(folder()).generic_string();
}

// All that decides what reading gives.
std::string Workshop::key_of(const TakeSource& source) const {
  const motion::FigureOptions& common = options().figure;
  const auto unit = source.figure.unit_m ? source.figure.unit_m : common.unit_m;
  const auto up = source.figure.z_up ? source.figure.z_up : common.z_up;
  const auto number = [](const auto& value) {
    return value ? std::to_string(static_cast<double>(*value)) : std::string("-");
  };
  return source.file + "\n" + number(unit) + number(up) + number(source.from) + number(source.to) +
         number(source.load.rate) + source.load.skeleton.string() +
         (options().walk ? "walk" : "other");
}

std::shared_ptr<const motion::TakeReview> Workshop::review(std::size_t take) const {
  return found_[take] != nullptr ? found_[take]->review : nullptr;
}

const std::vector<Problem>& Workshop::problems(std::size_t take) const {
  static const std::vector<Problem> none;
  return found_[take] != nullptr ? found_[take]->problems : none;
}

std::vector<WalkPlace> Workshop::walks() const {
  std::vector<WalkPlace> walks;
  for (std::size_t t = 0; t < takes().size(); ++t) {
    if (verdicts_[t].state != TakeState::used) continue;
    for (std::size_t c = 0; c < takes()[t].source.cycles.size(); ++c) walks.push_back({t, c});
  }
  return walks;
}

std::size_t Workshop::refused() const {
  return static_cast<std::size_t>(
      std::count_if(verdicts_.begin(), verdicts_.end(),
                    [](const Verdict& verdict) { return verdict.refused(); }));
}

std::optional<TakeSource> Workshop::unread() const {
  for (std::size_t t = 0; t < takes().size(); ++t) {
    if (found_[t] == nullptr) return takes()[t].source;
  }
  return std::nullopt;
}

void Workshop::take_in(const TakeSource& source, ReadCapture read) {
  // Whoever says the unit that was guessed already need not wait for the same again.
  if (read.review && read.review->unit_guessed) {
    TakeSource said = source;
    said.figure.unit_m = read.review->figure.unit_m;
    read_.emplace(key_of(said), read);
  }
  read_.insert_or_assign(key_of(source), std::move(read));
  settle();
}

LoopOrder Workshop::order_of(const WalkPlace& walk) const {
  LoopOrder order{review(walk.take), takes()[walk.take].source.cycles[walk.cycle].frames};
  if (!order.review) return {};
  for (double& key : order.keys) key -= order.review->take.first_frame;
  return order;
}

std::shared_ptr<const motion::LoopReview> Workshop::loop(const WalkPlace& walk) const {
  const auto found = loops_.find(order_of(walk));
  return found == loops_.end() ? nullptr : found->second;
}

std::optional<LoopOrder> Workshop::uncut() const {
  for (const WalkPlace& walk : walks()) {
    LoopOrder order = order_of(walk);
    if (order.review && !loops_.contains(order)) return order;
  }
  return std::nullopt;
}

void Workshop::take_in(const LoopOrder& order, std::shared_ptr<const motion::LoopReview> loop) {
  constexpr std::size_t most = 2000;  // a long drag leaves one at every pixel
  if (loops_.size() > most) loops_.clear();
  loops_.insert_or_assign(order, std::move(loop));
  ++revision_;
}

void Workshop::refuse(const LoopOrder& order, const ReadCapture& why) {
  for (auto& [key, read] : read_) {
    if (read.review == order.review) read = why;
  }
  settle();
}

// Takes without a loop that could have one get the best, as `set build` would choose.
void Workshop::choose_missing(State& state) const {
  for (WorkshopTake& take : state.takes) {
    const auto read = read_.find(key_of(take.source));
    if (!take.source.cycles.empty() || read == read_.end() || !read->second.review) continue;
    const motion::TakeReview& review = *read->second.review;
    for (const motion::CycleCandidate& loop :
         motion::best_apart(review.search.candidates, state.options.cycles_per_take)) {
      take.source.cycles.push_back({"", frames_of(review.take, loop.keys)});
    }
  }
}

// Once all takes are read, so that numbers follow the order of the takes.
void Workshop::name_missing(State& state) const {
  for (const WorkshopTake& take : state.takes) {
    if (!read_.contains(key_of(take.source))) return;
  }
  std::set<std::string> taken = names_in(state.takes);
  for (WorkshopTake& take : state.takes) {
    for (GivenCycle& cycle : take.source.cycles) {
      if (!cycle.name.empty()) continue;
      cycle.name = free_name(take.source.style, taken);
      taken.insert(cycle.name);
    }
  }
}

void Workshop::judge() {
  verdicts_.assign(takes().size(), {});
  found_.assign(takes().size(), nullptr);
  std::vector<motion::Take> skeletons;
  int model = -1;
  for (std::size_t t = 0; t < takes().size(); ++t) {
    Verdict& verdict = verdicts_[t];
    const WorkshopTake& take = takes()[t];
    const auto known = read_.find(key_of(take.source));
    if (known == read_.end()) continue;
    const ReadCapture* read = found_[t] = &known->second;
    if (!read->review) {
      verdict = {TakeState::unreadable, message_of(read->problems),
                 read->problems.empty() ? 0 : read->problems.front().line};
      continue;
    }
    const motion::Take& seen = read->review->take;
    if (std::string trouble = trouble_of(take, seen); !trouble.empty()) {
      verdict = {TakeState::unreadable, std::move(trouble)};
    } else if (take.left_out) {
      verdict.state = TakeState::left_out;
    } else {
      const bool loops = !take.source.cycles.empty();
      verdict = {loops ? TakeState::used : TakeState::no_loop,
                 loops ? "" : "gives no cycle: " + read->review->search.refusal};
      if (take.source.file == options().skeleton) model = static_cast<int>(skeletons.size());
      skeletons.push_back({seen.source, seen.skeleton, seen.body, seen.frame_time, {}, 0, 0});
    }
  }
  if (skeletons.empty()) return;
  const motion::SharedSkeleton shared = motion::shared_skeleton(skeletons, model);
  std::size_t k = 0;
  for (Verdict& verdict : verdicts_) {
    if (verdict.state != TakeState::used && verdict.state != TakeState::no_loop) continue;
    const std::string refusal = motion::fit_to(shared, skeletons[k++]).refusal;
    if (verdict.state == TakeState::used && !refusal.empty()) {
      verdict = {TakeState::misfit, refusal};
    }
  }
}

void Workshop::settle() {
  State& now = history_[now_];
  std::sort(now.takes.begin(), now.takes.end(), [](const WorkshopTake& a, const WorkshopTake& b) {
    return a.source.file < b.source.file;
  });
  choose_missing(now);
  name_missing(now);
  judge();
  ++revision_;
}

void Workshop::commit(State next, int gesture) {
  constexpr std::size_t most = 200;
  next.step = ++steps_;
  history_.resize(now_ + 1);
  if (gesture != 0 && gesture == gesture_) {
    history_.back() = std::move(next);
  } else {
    history_.push_back(std::move(next));
    if (history_.size() > most) history_.erase(history_.begin());
    now_ = history_.size() - 1;
  }
  gesture_ = gesture;
  settle();
}

void Workshop::undo() {
  if (!can_undo()) return;
  --now_;
  gesture_ = 0;
  settle();
}

void Workshop::redo() {
  if (!can_redo()) return;
  ++now_;
  gesture_ = 0;
  settle();
}

void Workshop::describe(const std::string& name, const std::string& credit) {
  // Of the set as a whole: no step of its own that Ctrl-Z would take back behind a field.
  for (State& one : history_) {
    one.options.name = name;
    one.options.credit = credit;
  }
}

void Workshop::choose_loop(const WalkPlace& walk, const std::vector<double>& keys) {
  State next = state();
  next.takes[walk.take].source.cycles[walk.cycle].frames = frames_of(review(walk.take)->take, keys);
  commit(std::move(next));
}

void Workshop::add_loop(std::size_t take, const std::vector<double>& keys) {
  State next = state();
  next.takes[take].left_out = false;
  next.takes[take].source.cycles.push_back({"", frames_of(review(take)->take, keys)});
  commit(std::move(next));
}

void Workshop::move_end(const WalkPlace& walk, bool last, double frame, int gesture) {
  const LoopOrder order = order_of(walk);
  assert(order.review && "a take that was read");
  const motion::Take& take = order.review->take;
  const std::vector<double> frames =
      frames_of(take, motion::with_end_at(take, order.keys, last, frame));
  State next = state();
  std::vector<double>& now = next.takes[walk.take].source.cycles[walk.cycle].frames;
  if (now == frames) return;
  now = frames;
  commit(std::move(next), gesture);
}

bool Workshop::rename(const WalkPlace& walk, const std::string& name) {
  State next = state();
  TakeSource& source = next.takes[walk.take].source;
  std::string& now = source.cycles[walk.cycle].name;
  if (now == name) return true;
  if (name.empty() || names_in(next.takes).contains(name)) return false;
  now = name;
  if (source.cycles.size() == 1) source.style = style_in(name);
  commit(std::move(next));
  return true;
}

void Workshop::remove(const WalkPlace& walk) {
  State next = state();
  WorkshopTake& take = next.takes[walk.take];
  if (take.source.cycles.size() == 1) {
    take.left_out = true;  // its loop is kept for whoever takes it in again
  } else {
    take.source.cycles.erase(take.source.cycles.begin() + static_cast<std::ptrdiff_t>(walk.cycle));
  }
  commit(std::move(next));
}

void Workshop::leave_out(std::size_t take, bool out) {
  State next = state();
  next.takes[take].left_out = out;
  commit(std::move(next));
}

void Workshop::forget(std::size_t take) {
  State next = state();
  next.takes.erase(next.takes.begin() + static_cast<std::ptrdiff_t>(take));
  commit(std::move(next));
}

void Workshop::set_unit(const std::vector<std::size_t>& list, double unit_m) {
  State next = state();
  for (const std::size_t t : list) {
    next.takes[t].source.figure.unit_m = unit_m;  // when the feet step stays the same
  }
  commit(std::move(next));
}

}  // namespace promenade::study
