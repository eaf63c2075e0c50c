#include "app/path_worker.h"

#include <utility>

#include "motion/problem.h"

namespace promenade::app {
namespace {

std::shared_ptr<const study::Stimulus> motion_of(
    const std::shared_ptr<const motion::MotionGraph>& graph, const motion::GraphWalk& walk) {
  auto made = std::make_shared<study::Stimulus>();
  made->name = graph->name;
  made->graph = graph;
  made->edges = walk.edges;
  made->labels = motion::labelled_parts(*graph, walk.edges);
  made->take = motion::walk_take(*graph, walk);
  return made;
}

// Without what its last edge goes on beyond the end of the path.
std::shared_ptr<const study::Stimulus> motion_of(
    const std::shared_ptr<const motion::MotionGraph>& graph, const motion::PathWalk& found) {
  auto made = std::make_shared<study::Stimulus>(*motion_of(graph, found.walk));
  const int last = std::clamp(found.frames, 1, made->take.frames() - 1);
  made->take.poses.resize(static_cast<std::size_t>(last) + 1);
  std::erase_if(made->labels, [&](const motion::LabelledPart& part) { return part.from > last; });
  made->labels.back().to = std::min(made->labels.back().to, last + 1);
  return made;
}

}  // namespace

PathWorker::PathWorker(std::shared_ptr<const motion::MotionGraph> graph,
                       motion::PathWalkOptions options)
    : graph_(std::move(graph)),
      options_(std::move(options)),
      thread_([this](const std::stop_token& ended) { run(ended); }) {}

PathWorker::~PathWorker() { thread_.request_stop(); }  // and is waited for

void PathWorker::ask(std::optional<WantedPath> path) {
  const std::lock_guard lock(mutex_);
  ++newest_;
  stopped_ = false;
  share_ = 0;
  working_ = path.has_value();
  news_.reset();
  trouble_.clear();
  waiting_.reset();
  if (path) waiting_ = Job{newest_, std::move(*path)};
  asked_.notify_one();
}

void PathWorker::start(WantedPath path) { ask(std::move(path)); }

void PathWorker::forget() { ask({}); }

void PathWorker::stop() { stopped_ = true; }

std::shared_ptr<const WalkedPath> PathWorker::news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, nullptr);
}

bool PathWorker::told() const {
  const std::lock_guard lock(mutex_);
  return news_ == nullptr;
}

std::string PathWorker::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

std::optional<PathWorker::Job> PathWorker::next(const std::stop_token& ended) {
  std::unique_lock lock(mutex_);
  asked_.wait(lock, ended, [this] { return waiting_.has_value(); });
  if (ended.stop_requested()) return {};
  return std::exchange(waiting_, {});
}

void PathWorker::run(const std::stop_token& ended) {
  while (const std::optional<Job> job = next(ended)) work(*job, ended);
}

void PathWorker::work(const Job& job, const std::stop_token& ended) {
  try {
    motion::PathWalk found = search(job, ended);
    if (found.walk.edges.empty()) return finish(job, "Stopped before a walk was found");
    publish(job, {motion_of(graph_, found), std::move(found)});
    finish(job, "");
  } catch (const InputError& error) {
    finish(job, error.problems().front().message);
  }
}

motion::PathWalk PathWorker::search(const Job& job, const std::stop_token& ended) {
  if (ways_.empty()) ways_ = motion::edge_ways(*graph_, motion::edge_courses(*graph_));
  motion::PathWalkOptions options = options_;
  options.parts = job.path.parts;
  std::vector<int> published;
  const auto heard = [&](const motion::GraphWalk& walk, double share) {
    if (job.number == newest_) share_ = share;
    // What nobody has looked at yet is not worth a new motion.
    if (!walk.edges.empty() && walk.edges != published && told()) {
      publish(job, {motion_of(graph_, walk), {}});
      published = walk.edges;
    }
    return !ended.stop_requested() && !stopped_ && job.number == newest_;
  };
  return motion::walk_along(*graph_, ways_, motion::GroundPath(job.path.points), options, heard);
}

void PathWorker::publish(const Job& job, WalkedPath found) {
  const std::lock_guard lock(mutex_);
  if (job.number == newest_) news_ = std::make_shared<const WalkedPath>(std::move(found));
}

void PathWorker::finish(const Job& job, const std::string& trouble) {
  const std::lock_guard lock(mutex_);
  if (job.number != newest_) return;
  trouble_ = trouble;
  working_ = false;
}

}  // namespace promenade::app
