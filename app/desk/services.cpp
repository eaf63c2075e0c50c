#include "app/desk/services.h"

#include <algorithm>
#include <utility>

#include "motion/problem.h"

namespace promenade::app {

std::string_view to_text(DeskPlace place) {
  constexpr std::string_view names[desk_places] = {"studies",  "takes", "edit",  "plan",
                                                   "rehearse", "run",   "watch", "results"};
  return names[static_cast<std::size_t>(place)];
}

DeskJobs::~DeskJobs() {
  for (const DeskJob& one : jobs_) {
    if (one.kind != JobKind::session && one.job->running()) one.job->stop();
  }
}

void DeskJobs::start(const std::string& name, const std::vector<std::string>& arguments,
                     std::function<void(const Job& job)> ended, JobKind kind) {
  trouble_.clear();
  try {
    DeskJob one;
    one.name = name;
    one.job = std::make_unique<Job>(program_, arguments);
    one.ended = std::move(ended);
    one.kind = kind;
    jobs_.push_back(std::move(one));
  } catch (const OutsideError& error) {
    trouble_ = error.what();
  }
}

// What is told may start the next one, so that jobs_ moves.
void DeskJobs::look() {
  std::vector<std::function<void()>> to_tell;
  for (DeskJob& one : jobs_) {
    one.job->look();
    if (one.job->running() || one.told) continue;
    one.told = true;
    if (!one.ended) continue;
    to_tell.emplace_back([tell = std::move(one.ended), job = one.job.get()] { tell(*job); });
  }
  for (const std::function<void()>& tell : to_tell) tell();
  // What failed waits to be seen; of what ended well the last is enough.
  const auto well = [this](const DeskJob& one) {
    return &one != &jobs_.back() && one.told && (one.job->exit_code() == 0 || one.job->stopped());
  };
  jobs_.erase(std::remove_if(jobs_.begin(), jobs_.end(), well), jobs_.end());
}

bool DeskJob::failed() const { return !job->running() && job->exit_code() != 0 && !job->stopped(); }

const DeskJob* DeskJobs::shown() const {
  const auto running = std::find_if(jobs_.begin(), jobs_.end(), [](const DeskJob& one) {
    return one.job->running() && one.kind != JobKind::session;
  });
  if (running != jobs_.end()) return &*running;
  const auto failed =
      std::find_if(jobs_.begin(), jobs_.end(), [](const DeskJob& one) { return one.failed(); });
  if (failed != jobs_.end()) return &*failed;
  return jobs_.empty() ? nullptr : &jobs_.back();
}

bool DeskJobs::busy() const {
  return std::any_of(jobs_.begin(), jobs_.end(), [](const DeskJob& one) {
    return one.kind != JobKind::session && one.job->running();
  });
}

bool DeskJobs::session() const {
  return std::any_of(jobs_.begin(), jobs_.end(), [](const DeskJob& one) {
    return one.kind == JobKind::session && one.job->running();
  });
}

bool DeskJobs::quiet() const {
  return std::any_of(jobs_.begin(), jobs_.end(), [](const DeskJob& one) {
    return one.kind != JobKind::work && one.job->running();
  });
}

void DeskJobs::stop_shown() {
  if (const DeskJob* one = shown()) one->job->stop();
}

void DeskJobs::dismiss() {
  if (!std::exchange(trouble_, {}).empty()) return;
  const DeskJob* const seen = shown();
  std::erase_if(jobs_, [seen](const DeskJob& one) {
    return !one.job->running() && one.told && (&one == seen || !one.failed());
  });
}

std::vector<std::string> DeskServices::display_options() const {
  if (display >= displays.size()) return {"--windowed"};
  return {"--screen", std::to_string(display + 1)};
}

}  // namespace promenade::app
