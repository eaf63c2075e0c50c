#include "motion/graph/edge_ways.h"

#include <algorithm>
#include <cmath>

#include "motion/graph/index.h"

namespace promenade::motion {
namespace {

using Eigen::Matrix2Xd;
using Eigen::Vector2d;

Vector2d on_ground(const PlanarMove& move, const Vector2d& point) {
  const Eigen::Vector3d there = moved(move, Eigen::Vector3d(point.x(), 0, point.y()));
  return {there.x(), there.z()};
}

// The pelvis along an edge with what its takes show before and after.
class Surroundings {
 public:
  Surroundings(const MotionGraph& graph, const std::vector<EdgeCourse>& courses)
      : graph_(graph),
        courses_(courses),
        along_to_(graph.nodes.size(), -1),
        along_from_(graph.nodes.size(), -1),
        any_from_(graph.nodes.size(), -1),
        most_(std::max(1, static_cast<int>(std::lround(0.5 / graph.frame_time)))) {
    for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
      const GraphEdge& edge = graph.edge(e);
      if (any_from_[at(edge.from)] < 0) any_from_[at(edge.from)] = e;
      if (edge.transition >= 0) continue;
      along_to_[at(edge.to)] = e;
      along_from_[at(edge.from)] = e;
    }
  }

  EdgeWay way(int e) {
    const EdgeCourse& course = courses_[at(e)];
    gather(e);
    EdgeWay way;
    way.frames.resize(3, course.pelvis.cols());
    way.move = course.move;
    way.direction = direction(before_, before_);
    const double least = least_speed_m_s * graph_.frame_time;
    for (int i = 0; i < static_cast<int>(course.pelvis.cols()); ++i) {
      way.frames.col(i) << course.pelvis.col(i), way.metres;
      way.metres += std::max(least, advance(before_ + i));
    }
    return way;
  }

 private:
  // points_: at most half a second before the edge, the edge, and more than that after it.
  void gather(int e) {
    points_.clear();
    for (int b = along_to_[at(graph_.edge(e).from)]; b >= 0 && missing(most_);
         b = along_to_[at(graph_.edge(b).from)]) {
      add_backwards(courses_[at(b)].pelvis);
    }
    std::reverse(points_.begin(), points_.end());
    before_ = static_cast<int>(points_.size());
    add(courses_[at(e)].pelvis, {});
    const int all = static_cast<int>(points_.size()) + most_ + 1;
    const PlanarMove& move = courses_[at(e)].move;
    int node = graph_.edge(e).to;
    for (int a = along_from_[at(node)]; a >= 0 && missing(all); a = along_from_[at(node)]) {
      add(courses_[at(a)].pelvis, move);
      node = graph_.edge(a).to;
    }
    // Where a take ends, any way on shows where its node is.
    const int on = any_from_[at(node)];
    if (missing(all) && on >= 0) add(courses_[at(on)].pelvis.leftCols(1), move);
  }

  bool missing(int all) const { return static_cast<int>(points_.size()) < all; }

  void add_backwards(const Matrix2Xd& pelvis) {
    for (Eigen::Index i = pelvis.cols(); i-- > 0 && missing(most_);) {
      points_.push_back(pelvis.col(i));
    }
  }

  void add(const Matrix2Xd& pelvis, const PlanarMove& move) {
    for (Eigen::Index i = 0; i < pelvis.cols(); ++i)
      points_.push_back(on_ground(move, pelvis.col(i)));
  }

  // Of travel between two points, from as long before the one as after the other.
  Vector2d direction(int from, int to) const {
    const int last = static_cast<int>(points_.size()) - 1;
    const int around = std::max(from == to ? 1 : 0, std::min({from, last - to, most_}));
    const Vector2d way =
        points_[at(std::min(to + around, last))] - points_[at(std::max(from - around, 0))];
    return way.norm() > 0 ? Vector2d(way.normalized()) : Vector2d::Zero();
  }

  // From a point to the next, metres in the direction of travel.
  double advance(int i) const {
    if (i + 1 >= static_cast<int>(points_.size())) return 0;
    return (points_[at(i + 1)] - points_[at(i)]).dot(direction(i, i + 1));
  }

  const MotionGraph& graph_;
  const std::vector<EdgeCourse>& courses_;
  std::vector<int> along_to_, along_from_;  // of each node, the edge along its take; -1: none
  std::vector<int> any_from_;
  const int most_;  // frames of half a second
  std::vector<Vector2d> points_;
  int before_ = 0;  // points before the edge
};

}  // namespace

std::vector<EdgeWay> edge_ways(const MotionGraph& graph, const std::vector<EdgeCourse>& courses) {
  Surroundings surroundings(graph, courses);
  std::vector<EdgeWay> ways;
  ways.reserve(courses.size());
  for (int e = 0; e < static_cast<int>(courses.size()); ++e) ways.push_back(surroundings.way(e));
  return ways;
}

}  // namespace promenade::motion
