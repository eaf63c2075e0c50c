// A motion graph of two walks of builtin:A: "happy" and "sad" can each go on forever and pass into
// the other, once in a cycle. No captures are needed.
#pragma once

#include "motion/builtin.h"
#include "motion/graph/cut_graph.h"
#include "motion/graph/graph_takes.h"

namespace promenade::app::bench {

constexpr double graph_rate = 30;  // frames a second

// From where cycle `exit` of one take begins to where cycle `entry` of the other does.
inline motion::Passage passage(const motion::MotionGraph& graph, const motion::MotionSet& set,
                               int from, int exit, int to, int entry) {
  constexpr int k = 11;  // a third of a second
  const auto at = [&](int take, int cycle) {
    const int index = motion::find_cycle(set, graph.take(take).label);
    return static_cast<int>(
        std::lround(cycle * set.cycles[static_cast<std::size_t>(index)].seconds * graph_rate));
  };
  const int i = at(from, exit), window = at(to, entry);
  const auto pose = [&](int take, int frame) {
    return graph.take(take).take.poses[static_cast<std::size_t>(frame)];
  };
  const Eigen::Vector3d off = pose(from, i + k / 2).root - pose(to, window + k / 2).root;
  motion::Passage made{from, to, {}};
  made.transition.frames = {i, window + k - 1, k};
  made.transition.move = {0, off.x(), off.z()};
  for (int p = 0; p < k - 1; ++p) {
    made.transition.poses.push_back(
        motion::mix(pose(from, i + p), motion::moved(made.transition.move, pose(to, window + p)),
                    1 - motion::weight_of_first(p, k)));
  }
  return made;
}

inline motion::MotionGraph walks_graph() {
  const motion::MotionSet set = *motion::builtin_set("A");
  motion::MotionGraph graph;
  graph.name = "walks";
  graph.frame_time = 1 / graph_rate;
  graph.window = 11;
  for (motion::GraphTake& take : motion::takes_of_set(set, graph_rate, 5)) {
    if (take.label == "happy" || take.label == "sad") graph.takes.push_back(std::move(take));
  }
  std::vector<motion::Passage> passages;
  for (const int from : {0, 1}) {
    for (const int exit : {2, 3, 4}) {
      passages.push_back(passage(graph, set, from, exit, 1 - from, 1));
    }
    passages.push_back(passage(graph, set, from, 4, from, 1));
  }
  motion::cut_at(std::move(passages), graph);
  return graph;
}

}  // namespace promenade::app::bench
