#include "app/desk/edit/study_check.h"

#include <filesystem>
#include <utility>

#include "motion/problem.h"
#include "motion/set_file.h"
#include "study/identity.h"
#include "study/toml_spans.h"

namespace promenade::app {
namespace {

constexpr std::int64_t calm_us = 300'000;

// The motion set of the check before, which most texts name again: a large one takes a while.
class SetMemory {
 public:
  motion::MotionSet load(const std::string& name, const std::string& folder) {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    const auto time = std::filesystem::last_write_time(path, error);
    if (!set_ || name != name_ || time != time_) {
      set_ = study::load_motion_set(name, folder);
      name_ = name;
      time_ = time;
    }
    return *set_;
  }

 private:
  std::string name_;
  std::filesystem::file_time_type time_;
  std::optional<motion::MotionSet> set_;
};

std::vector<PlacedProblem> placed(const std::string& file, const std::string& text,
                                  const std::vector<Problem>& problems) {
  const study::TomlSpans spans = study::scan_toml(text);
  std::vector<PlacedProblem> found;
  for (const Problem& problem : problems) {
    PlacedProblem one{problem, {}, 0};
    if (problem.file == file && problem.line > 0) {
      one.line = problem.line;
      one.path = study::path_at(spans, study::byte_at(text, {problem.line, problem.column}));
    }
    found.push_back(std::move(one));
  }
  return found;
}

std::shared_ptr<const study::StudyBundle> motions_of(motion::MotionSet set) {
  auto motions = std::make_shared<study::StudyBundle>();
  motions->set_sha256 = study::sha256_hex(motion::to_bytes(set));
  motions->space = motion::make_motion_space(std::move(set));
  motions->bank = motion::make_pose_bank(motions->space);
  return motions;
}

}  // namespace

StudyCheck check_study(const std::string& file, const std::string& text,
                       const study::InterfaceRegistry& registry, const study::SetLoader& load_set) {
  StudyCheck check{text, {}, {}, {}};
  std::optional<motion::MotionSet> set;
  const study::SetLoader keep = [&](const std::string& name, const std::string& folder) {
    set = load_set(name, folder);
    return *set;
  };
  try {
    auto bundle =
        std::make_shared<study::StudyBundle>(study::read_study(file, text, registry, keep));
    check.problems = placed(file, text, bundle->warnings);
    check.bundle = check.motions = std::move(bundle);
  } catch (const InputError& error) {
    check.problems = placed(file, text, error.problems());
  } catch (const std::exception& error) {  // a disk that fails, no memory: the window lives on
    check.problems = placed(file, text, {{file, 0, 0, error.what(), Severity::error}});
  }
  if (!check.motions && set) check.motions = motions_of(std::move(*set));
  return check;
}

StudyChecker::StudyChecker(std::string file, const study::InterfaceRegistry& registry)
    : file_(std::move(file)),
      registry_(registry),
      thread_([this](const std::stop_token& ended) { run(ended); }) {}

StudyChecker::~StudyChecker() { thread_.request_stop(); }  // and is waited for

void StudyChecker::see(const std::string& text, std::int64_t now_us) {
  if (first_ || text != seen_) {
    seen_ = text;
    same_since_us_ = now_us;
    pending_ = true;
  }
  // The first text was read from the disk: nobody types in it.
  if (!pending_ || (!first_ && now_us - same_since_us_ < calm_us)) return;
  pending_ = first_ = false;
  const std::lock_guard lock(mutex_);
  asked_ = text;
  changed_.notify_all();
}

std::shared_ptr<const StudyCheck> StudyChecker::found() const {
  const std::lock_guard lock(mutex_);
  return found_;
}

bool StudyChecker::working() const {
  const std::lock_guard lock(mutex_);
  return pending_ || busy_ || asked_.has_value();
}

void StudyChecker::wait() const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !busy_ && !asked_; });
}

void StudyChecker::run(const std::stop_token& ended) {
  SetMemory memory;
  const study::SetLoader load = [&memory](const std::string& name, const std::string& folder) {
    return memory.load(name, folder);
  };
  while (true) {
    std::unique_lock lock(mutex_);
    if (!changed_.wait(lock, ended, [this] { return asked_.has_value(); })) return;
    if (ended.stop_requested()) return;
    const std::string text = *std::exchange(asked_, {});
    busy_ = true;
    lock.unlock();
    auto found = std::make_shared<const StudyCheck>(check_study(file_, text, registry_, load));
    lock.lock();
    busy_ = false;
    found_ = std::move(found);
    changed_.notify_all();
  }
}

}  // namespace promenade::app
