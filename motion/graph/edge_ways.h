// What a search needs to know of the edges of a motion graph: where the pelvis is at each frame,
// and how far somebody has walked.
//
// The pelvis sways from step to step, so its own way is longer than the way walked. A step of time
// therefore counts as far as it leads in the direction of travel, which is that from half a
// second before to half a second after (ours; [K] projects the root, whose sway it does not
// mention). On a circle this is the whole way, whatever the radius. Who stands still is taken to
// walk very slowly, so that every walk comes to an end ([K] 5.1: a least progress).
#pragma once

#include "motion/graph/graph_walk.h"

namespace promenade::motion {

struct EdgeWay {
  Eigen::Matrix3Xd frames;  // 3 x frames: x, z of the pelvis where the first take lies, and
                            // metres walked since the edge began
  double metres = 0;        // walked along the whole edge
  PlanarMove move;          // to apply to what follows
  Eigen::Vector2d direction = Eigen::Vector2d::Zero();  // of travel as it begins, length 1
};

inline constexpr double least_speed_m_s = 0.1;

// One for each edge of the graph; `courses` are edge_courses(graph).
std::vector<EdgeWay> edge_ways(const MotionGraph& graph, const std::vector<EdgeCourse>& courses);

}  // namespace promenade::motion
