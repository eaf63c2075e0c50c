#include "motion/graph/graph_walk.h"

#include <cassert>
#include <cmath>

namespace promenade::motion {
namespace {

const Pose& pose_of(const MotionGraph& graph, const GraphNode& node, int frames_later = 0) {
  return graph.take(node.take).take.poses[static_cast<std::size_t>(node.frame + frames_later)];
}

// What an edge shows at a step, where the take that it leaves lies.
const Pose& pose_of(const MotionGraph& graph, const GraphEdge& edge, int step) {
  if (edge.transition < 0) return pose_of(graph, graph.node(edge.from), step);
  return graph.transition(edge.transition).poses[static_cast<std::size_t>(step)];
}

PlanarMove move_of(const MotionGraph& graph, const GraphEdge& edge) {
  if (edge.transition < 0) return {};
  return graph.transition(edge.transition).move;
}

// Of two quaternions that turn alike, the one that can be interpolated with those before.
void follow(const Pose& before, Pose& pose) {
  for (std::size_t j = 0; j < pose.rotations.size(); ++j) {
    if (pose.rotations[j].dot(before.rotations[j]) < 0) pose.rotations[j].coeffs() *= -1;
  }
}

void add(Pose pose, Take& take) {
  if (!take.poses.empty()) follow(take.poses.back(), pose);
  take.poses.push_back(std::move(pose));
}

}  // namespace

bool holds_together(const MotionGraph& graph, const std::vector<int>& edges) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e] < 0 || edges[e] >= static_cast<int>(graph.edges.size())) return false;
    if (e > 0 && graph.edge(edges[e - 1]).to != graph.edge(edges[e]).from) return false;
  }
  return true;
}

int walk_frames(const MotionGraph& graph, const std::vector<int>& edges) {
  int frames = edges.empty() ? 0 : 1;
  for (const int e : edges) frames += graph.edge(e).frames;
  return frames;
}

PlanarMove start_at_origin(const MotionGraph& graph, const std::vector<int>& edges) {
  if (edges.empty()) return {};
  const Take walk = walk_take(graph, {edges, {}});
  const Eigen::Vector3d from = walk.poses.front().root;
  // Half a second shows where somebody goes, and not how the pelvis sways.
  const auto ahead = static_cast<std::size_t>(std::lround(0.5 / graph.frame_time));
  const Eigen::Vector3d way = walk.poses[std::min(ahead, walk.poses.size() - 1)].root - from;
  const double theta = std::hypot(way.x(), way.z()) > 1e-6 ? -std::atan2(way.x(), way.z()) : 0;
  return after({theta, 0, 0}, {0, -from.x(), -from.z()});
}

Take walk_take(const MotionGraph& graph, const GraphWalk& walk) {
  assert(holds_together(graph, walk.edges) && "a walk of this graph");
  const Take& model = graph.takes.front().take;
  Take take{graph.name, model.skeleton, model.body, graph.frame_time, {}, 0, 0};
  PlanarMove place = walk.start;
  for (const int e : walk.edges) {
    const GraphEdge& edge = graph.edge(e);
    for (int step = 0; step < edge.frames; ++step) {
      add(moved(place, pose_of(graph, edge, step)), take);
    }
    place = after(place, move_of(graph, edge));
  }
  if (!walk.edges.empty()) {
    const int last = graph.edge(walk.edges.back()).to;
    add(moved(place, pose_of(graph, graph.node(last))), take);
  }
  return take;
}

std::vector<LabelledPart> labelled_parts(const MotionGraph& graph, const std::vector<int>& edges) {
  std::vector<LabelledPart> parts;
  int frame = 0;
  for (const int e : edges) {
    const GraphEdge& edge = graph.edge(e);
    const std::string& label = graph.label(edge);
    if (parts.empty() || parts.back().label != label) parts.push_back({frame, frame, label});
    frame += edge.frames;
    parts.back().to = frame;
  }
  return parts;
}

std::vector<EdgeCourse> edge_courses(const MotionGraph& graph) {
  std::vector<EdgeCourse> courses;
  courses.reserve(graph.edges.size());
  for (const GraphEdge& edge : graph.edges) {
    EdgeCourse course{Eigen::Matrix2Xd(2, edge.frames), move_of(graph, edge)};
    for (int step = 0; step < edge.frames; ++step) {
      const Eigen::Vector3d& root = pose_of(graph, edge, step).root;
      course.pelvis.col(step) << root.x(), root.z();
    }
    courses.push_back(std::move(course));
  }
  return courses;
}

}  // namespace promenade::motion
