// Motion graphs of arcs over the ground, made by hand, for tests that need no poses.
#pragma once

#include <cmath>

#include "motion/graph/graph_walk.h"

namespace promenade::motion {

struct ArcGraph {
  MotionGraph graph;
  std::vector<EdgeCourse> courses;

  explicit ArcGraph(double frames_per_second = 30) {
    graph.name = "toy";
    graph.frame_time = 1 / frames_per_second;
  }

  int add_take(const std::string& label) {
    graph.takes.push_back({{}, label});
    return static_cast<int>(graph.takes.size()) - 1;
  }
  int add_node(int take) {
    graph.nodes.push_back({take, static_cast<int>(graph.nodes.size())});
    return static_cast<int>(graph.nodes.size()) - 1;
  }

  // An edge that walks along an arc, from the origin, at first along +Z; `turn` radians to the
  // figure's left (about +Y) in all. Edges are to be added in order of `from`.
  void add_arc(int from, int to, int frames, double metres, double turn, double rms = 0.01) {
    graph.edges.push_back({from, to, frames, static_cast<int>(graph.transitions.size())});
    graph.transitions.emplace_back().rms_m = rms;
    EdgeCourse course{Eigen::Matrix2Xd(2, frames), at(metres, turn, 1)};
    for (int i = 0; i < frames; ++i) {
      const PlanarMove there = at(metres, turn, double(i) / frames);
      course.pelvis.col(i) << there.x0, there.z0;
    }
    courses.push_back(course);
  }

 private:
  static PlanarMove at(double metres, double turn, double share) {
    const double way = metres * share, angle = turn * share;
    if (turn == 0) return {0, 0, way};
    const double radius = metres / turn;
    return {angle, radius * (1 - std::cos(angle)), radius * std::sin(angle)};
  }
};

// One place from which 15 frames (half a second) lead 0.65 m straight on, or in a turn to
// either side.
inline ArcGraph straight_left_right(double turn = 0.5) {
  ArcGraph toy;
  const int node = toy.add_node(toy.add_take("plain"));
  for (const double angle : {0.0, turn, -turn}) toy.add_arc(node, node, 15, 0.65, angle);
  return toy;
}

}  // namespace promenade::motion
