#include "app/desk/takes/takes_work.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <mutex>

#include "motion/files.h"
#include "motion/problem.h"
#include "study/capture_files.h"

namespace promenade::app {
namespace {

namespace fs = std::filesystem;
using study::TakeState;

struct Stopped : std::exception {};

// In which part of the list a take stands.
int rank_of(const study::Verdict& verdict) {
  if (verdict.refused()) return 0;
  return verdict.state == TakeState::left_out ? 2 : 1;
}

std::string said(const InputError& error) {
  const Problem& problem = error.problems().front();
  return problem.file.empty() ? problem.message : to_text(problem);
}

// Of a take that took more than its file has to give: no memory, a disk that fails.
study::ReadCapture failed(const std::string& file, const std::exception& error) {
  return {nullptr, {{file, 0, 0, error.what(), Severity::error}}};
}

}  // namespace

// What the thread and the page both look at.
struct TakesWork::Making {
  std::atomic<bool> stop = false;
  std::atomic<double> share = 0;
  MadeSet result;  // written by the thread before it delivers
  int step = 0;    // of the workshop
};

TakesWork::TakesWork(TakesTools tools) : tools_(std::move(tools)) {}

TakesWork::~TakesWork() { stop_making(); }

void TakesWork::add(const std::vector<std::string>& paths) {
  trouble_.clear();
  std::vector<std::string> captures;
  for (const std::string& path : paths) {
    if (fs::path(path).extension() != ".toml") {
      captures.push_back(path);
      continue;
    }
    try {
      shop_.open(path);
      looked_at_.clear();
      kept_ = shop_.step();
    } catch (const InputError& error) {
      trouble_ = said(error);
    }
  }
  const std::vector<std::string> files = study::capture_files(captures);
  shop_.add(files);
  if (!captures.empty() && files.empty()) trouble_ = captures.front();
}

std::size_t TakesWork::to_read() const {
  std::size_t count = 0;
  for (std::size_t t = 0; t < shop_.takes().size(); ++t) {
    count += shop_.verdict(t).state == TakeState::unread ? 1 : 0;
  }
  return count;
}

bool TakesWork::busy() const { return reading_now_ || cutting_now_ || made_.working; }

void TakesWork::read_next() {
  if (reading_now_) return;
  const std::optional<motion::TakeSource> source = shop_.unread();
  if (!source) return;
  reading_now_ = true;
  reading_.ask([this, source = *source, options = shop_.options()](const std::stop_token&) {
    auto read = std::make_shared<study::ReadCapture>();
    try {
      *read = tools_.read(source, options);
    } catch (const std::exception& error) {
      *read = failed(source.file, error);
    }
    return study::WorkQueue::Result([this, source, read] {
      reading_now_ = false;
      shop_.take_in(source, std::move(*read));
    });
  });
}

void TakesWork::cut_next() {
  if (cutting_now_) return;
  std::optional<study::LoopOrder> order;
  // What is looked at is waited for.
  const std::optional<study::WalkPlace> now = walk();
  if (now && shop_.loop(*now) == nullptr) order = shop_.order_of(*now);
  if (!order || !order->review) order = shop_.uncut();
  if (!order) return;
  cutting_now_ = true;
  cutting_.ask([this, order = *order, options = shop_.options()](const std::stop_token&) {
    std::shared_ptr<const motion::LoopReview> loop;
    study::ReadCapture trouble;
    try {
      loop = std::make_shared<const motion::LoopReview>(
          tools_.cut(order.review->take, order.keys, options));
    } catch (const std::exception& error) {
      trouble = failed(order.review->take.source, error);
    }
    return study::WorkQueue::Result([this, order, loop, trouble] {
      cutting_now_ = false;
      loop ? shop_.take_in(order, loop) : shop_.refuse(order, trouble);
    });
  });
}

const std::vector<std::size_t>& TakesWork::listed() {
  if (sorted_ == shop_.revision()) return listed_;
  sorted_ = shop_.revision();
  listed_.clear();
  for (std::size_t t = 0; t < shop_.takes().size(); ++t) listed_.push_back(t);
  std::stable_sort(listed_.begin(), listed_.end(), [this](std::size_t a, std::size_t b) {
    return rank_of(shop_.verdict(a)) < rank_of(shop_.verdict(b));
  });
  return listed_;
}

void TakesWork::advance(std::int64_t now_us) {
  const double passed_s = last_us_ < 0 ? 0 : 1e-6 * static_cast<double>(now_us - last_us_);
  last_us_ = now_us;
  reading_.deliver();
  cutting_.deliver();
  maker_.deliver();
  if (making_) made_.share = making_->share;
  read_next();
  cut_next();
  constexpr double longest_step_s = 0.5;  // a pause is no walk
  if (passed_s > longest_step_s) return;
  clock_s_ += passed_s;
  const std::optional<std::size_t> now = take();
  const auto review = now ? shop_.review(*now) : nullptr;
  if (!review || !playing_) return;
  frame_ += passed_s / review->take.frame_time;
  if (frame_ > review->take.frames() - 1.0) frame_ = 0;
}

std::optional<std::size_t> TakesWork::take() const {
  const auto& takes = shop_.takes();
  for (std::size_t t = 0; t < takes.size(); ++t) {
    if (takes[t].source.file == looked_at_) return t;
  }
  // The first one that walks: what fails is read in the list.
  for (std::size_t t = 0; t < takes.size(); ++t) {
    if (shop_.verdict(t).state == TakeState::used) return t;
  }
  return takes.empty() ? std::nullopt : std::optional<std::size_t>(0);
}

std::size_t TakesWork::cycle() const {
  const std::optional<std::size_t> now = take();
  if (!now) return 0;
  const std::size_t count = shop_.takes()[*now].source.cycles.size();
  return count == 0 ? 0 : std::min(cycle_, count - 1);
}

void TakesWork::look_at(std::size_t take, std::size_t cycle) {
  const std::string& file = shop_.takes()[take].source.file;
  const bool other = file != looked_at_ || cycle != cycle_;
  looked_at_ = file;
  cycle_ = cycle;
  if (!other) return;
  const std::optional<study::WalkPlace> now = walk();
  const study::LoopOrder order = now ? shop_.order_of(*now) : study::LoopOrder{};
  frame_ = order.review ? order.keys.front() : 0;
}

std::optional<study::WalkPlace> TakesWork::walk() const {
  const std::optional<std::size_t> now = take();
  if (!now || shop_.takes()[*now].source.cycles.empty() || !shop_.review(*now)) return std::nullopt;
  if (shop_.verdict(*now).state == TakeState::unreadable) return std::nullopt;
  return study::WalkPlace{*now, cycle()};
}

std::shared_ptr<const motion::LoopReview> TakesWork::loop(const study::WalkPlace& walk) const {
  auto& last = loops_[{shop_.takes()[walk.take].source.file, walk.cycle}];
  if (auto now = shop_.loop(walk)) last = std::move(now);
  return last;
}

void TakesWork::step(int by) {
  const std::vector<std::size_t>& list = listed();
  if (list.empty()) return;
  const std::optional<std::size_t> now = take();
  const auto at = std::find(list.begin(), list.end(), now.value_or(0)) - list.begin();
  const auto last = static_cast<std::ptrdiff_t>(list.size()) - 1;
  look_at(list[static_cast<std::size_t>(std::clamp(at + by, std::ptrdiff_t{0}, last))]);
}

void TakesWork::scrub(double frame) {
  const std::optional<std::size_t> now = take();
  const auto review = now ? shop_.review(*now) : nullptr;
  if (review) frame_ = std::clamp(frame, 0.0, review->take.frames() - 1.0);
}

void TakesWork::make(const std::string& set_file) {
  if (made_.working) return;
  made_ = {.working = true, .file = set_file, .trouble = {}};
  const std::string recipe = study::recipe_beside(set_file);
  making_ = std::make_shared<Making>();
  making_->step = shop_.step();
  made_of_ = study::recipe_text(shop_, recipe);
  compared_ = -1;
  maker_.ask([this, set_file, recipe, text = made_of_,
              making = making_](const std::stop_token& ended) {
    MadeSet& result = making->result;
    result.file = set_file;
    try {
      write_file(recipe, text);
      const motion::BuiltSet built = study::make_set(recipe, set_file, [&](int step, int steps) {
        making->share = static_cast<double>(step) / steps;
        if (making->stop || ended.stop_requested()) throw Stopped();
      });
      result.walks = built.set.size();
      for (const motion::CycleReport& report : built.reports) {
        result.refused += report.cycle.empty() ? 1 : 0;
      }
    } catch (const Stopped&) {
      result.stopped = true;
    } catch (const InputError& error) {
      result.trouble = said(error);
    } catch (const std::exception& error) {
      result.trouble = error.what();
    }
    return study::WorkQueue::Result([this] { finish_making(); });
  });
}

void TakesWork::save(const std::string& set_file) {
  if (made_.working) return;  // which writes the same file
  const std::string recipe = study::recipe_beside(set_file);
  try {
    write_file(recipe, study::recipe_text(shop_, recipe));
    kept_ = shop_.step();
    if (made_.file.empty()) made_.trouble.clear();
  } catch (const std::exception& error) {
    made_ = {};
    made_.trouble = error.what();
  }
}

bool TakesWork::changed_since_made() {
  if (compared_ == shop_.revision()) return changed_;
  compared_ = shop_.revision();
  changed_ = study::recipe_text(shop_, study::recipe_beside(made_.file)) != made_of_;
  return changed_;
}

void TakesWork::finish_making() {
  made_ = making_->result;
  if (made_.done()) kept_ = making_->step;
  making_.reset();
}

void TakesWork::stop_making() {
  if (making_) making_->stop = true;
}

}  // namespace promenade::app
