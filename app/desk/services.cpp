#include "app/desk/services.h"

#include <algorithm>

#include "motion/problem.h"

namespace promenade::app {

std::string_view to_text(DeskPlace place) {
  constexpr std::string_view names[desk_places] = {"studies",  "takes", "edit",  "plan",
                                                   "rehearse", "run",   "watch", "results"};
  return names[static_cast<std::size_t>(place)];
}

DeskJobs::~DeskJobs() {
  for (DeskJob& one : jobs_) {
    if (one.kind != JobKind::session && one.job->running()) one.job->stop();
  }
}

void DeskJobs::start(const std::string& name, const std::vector<std::string>& arguments,
                     std::function<void(const Job& job)> ended, JobKind kind) {
  trouble_.clear();
  try {
    jobs_.push_back({.name = name,
                     .job = std::make_unique<Job>(program_, arguments),
                     .ended = std::move(ended),
                     .kind = kind});
  } catch (const OutsideError& error) {
    trouble_ = error.what();
  }
}

// What is told may start the next one, so that jobs_ moves.
void DeskJobs::look() {
  for (std::size_t i = 0; i < jobs_.size(); ++i) {
    jobs_[i].job->look();
    if (jobs_[i].job->running() || jobs_[i].told) continue;
    jobs_[i].told = true;
    const std::function<void(const Job&)> ended = std::move(jobs_[i].ended);
    if (ended) ended(*jobs_[i].job);
  }
  // What failed waits to be seen; of the others the last is enough.
  while (jobs_.size() > 1 && !jobs_.front().job->running()) jobs_.erase(jobs_.begin());
}

const DeskJob* DeskJobs::shown() const {
  const auto running = std::find_if(jobs_.begin(), jobs_.end(), [](const DeskJob& one) {
    return one.job->running() && one.kind != JobKind::session;
  });
  if (running != jobs_.end()) return &*running;
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
  trouble_.clear();
  std::erase_if(jobs_, [](const DeskJob& one) { return !one.job->running() && one.told; });
}

std::vector<std::string> DeskServices::display_options() const {
  if (display >= displays.size()) return {"--windowed"};
  return {"--screen", std::to_string(display + 1)};
}

}  // namespace promenade::app
