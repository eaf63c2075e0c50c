// Small motion graphs, cut by hand out of takes that stand still: what matters is where edges
// lead.
#pragma once

#include "motion/graph/cut_graph.h"

namespace promenade::motion {

// One joint that walks along +Z, a metre each second, ten frames a second.
inline Take toy_take(const std::string& name, int frames) {
  Take take;
  take.source = name;
  take.skeleton.joints = {{"hips", -1, Eigen::Vector3d::Zero()}};
  take.frame_time = 0.1;
  for (int f = 0; f < frames; ++f) {
    take.poses.push_back({Eigen::Vector3d(0, 1, 0.1 * f), {Eigen::Quaterniond::Identity()}});
  }
  return take;
}

// A transition of k frames that shows where its first take would be, then turns and moves.
inline Passage toy_passage(const GraphNode& from, const GraphNode& to, int k,
                           const PlanarMove& move = {}, double rms = 0.01) {
  Passage passage{from.take, to.take, {}};
  passage.transition.frames = {from.frame, to.frame, k};
  passage.transition.rms_m = rms;
  passage.transition.move = move;
  for (int p = 0; p < k - 1; ++p) {
    passage.transition.poses.push_back(
        {Eigen::Vector3d(0, 1, 0.1 * (from.frame + p)), {Eigen::Quaterniond::Identity()}});
  }
  return passage;
}

inline MotionGraph toy_graph(const std::vector<int>& frames_of_takes,
                             std::vector<Passage> passages) {
  MotionGraph graph;
  graph.name = "toy";
  graph.frame_time = 0.1;
  graph.window = 3;
  for (std::size_t t = 0; t < frames_of_takes.size(); ++t) {
    const std::string name(1, static_cast<char>('a' + t));
    graph.takes.push_back({toy_take(name + ".bvh", frames_of_takes[t]), name});
  }
  cut_at(std::move(passages), graph);
  return graph;
}

}  // namespace promenade::motion
