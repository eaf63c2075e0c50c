// A walk along the edges of a motion graph, as a motion.
#pragma once

#include "motion/graph/motion_graph.h"

namespace promenade::motion {

struct GraphWalk {
  std::vector<int> edges;  // each begins where the one before ends
  PlanarMove start;        // where the first node's take lies in the world
};

// Whether each edge leaves where the one before arrived.
bool holds_together(const MotionGraph& graph, const std::vector<int>& edges);

int walk_frames(const MotionGraph& graph, const std::vector<int>& edges);  // with the last pose

// The start at which the pelvis stands over the origin and moves along +Z.
PlanarMove start_at_origin(const MotionGraph& graph, const std::vector<int>& edges);

// All poses, metres, in the world of `walk.start`.
Take walk_take(const MotionGraph& graph, const GraphWalk& walk);

// What is seen when: [from, to) frames with the label of their edge.
struct LabelledPart {
  int from = 0, to = 0;
  std::string label;
};
std::vector<LabelledPart> labelled_parts(const MotionGraph& graph, const std::vector<int>& edges);

// The way of the pelvis over the ground along an edge, where its first take lies: 2 x frames
// (x, z; metres), and the move to apply to what follows. Worked out once for all edges, so that
// searches need no poses.
struct EdgeCourse {
  Eigen::Matrix2Xd pelvis;
  PlanarMove move;
};
std::vector<EdgeCourse> edge_courses(const MotionGraph& graph);

}  // namespace promenade::motion
