// A worker that is waited for.
#pragma once

#include <chrono>
#include <thread>

#include "app/path_worker.h"
#include "tests/app/walks_graph.h"

namespace promenade::app::bench {

inline void rest() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

// The last news, when nothing more will come.
inline std::shared_ptr<const WalkedPath> last_news(PathWorker& worker) {
  std::shared_ptr<const WalkedPath> last;
  while (worker.working()) rest();
  if (const auto news = worker.news()) last = news;
  return last;
}

inline std::shared_ptr<const motion::MotionGraph> shared_walks_graph() {
  static const auto graph = std::make_shared<const motion::MotionGraph>(walks_graph());
  return graph;
}

inline WantedPath straight_path(double metres, const std::string& label = "") {
  return path_through({{{0, 0}, label}, {{0, metres}, label}});
}

// With a path of hundreds of metres, a search that is not done before it is stopped.
inline motion::PathWalkOptions patient() {
  motion::PathWalkOptions options;
  options.horizon_s = 20;
  options.most_edges = 500'000;
  return options;
}

}  // namespace promenade::app::bench
