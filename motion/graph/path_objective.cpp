#include "motion/graph/path_objective.h"

#include <algorithm>
#include <cmath>

#include "motion/graph/graph_labels.h"
#include "motion/graph/index.h"

namespace promenade::motion {
namespace {

using Eigen::Vector2d;

// A move with its sine and cosine worked out.
struct Laying {
  explicit Laying(const PlanarMove& move)
      : c(std::cos(move.theta)), s(std::sin(move.theta)), shift(move.x0, move.z0) {}
  Vector2d turned(double x, double z) const { return {c * x + s * z, -s * x + c * z}; }
  Vector2d operator()(double x, double z) const { return turned(x, z) + shift; }

  double c, s;
  Vector2d shift;
};

double angle(const Vector2d& direction) { return std::atan2(direction.x(), direction.y()); }

}  // namespace

PathObjective::PathObjective(const MotionGraph& graph, const std::vector<EdgeWay>& ways,
                             const GroundPath& path, const PathWalkOptions& options)
    : graph_(graph),
      ways_(ways),
      path_(path),
      other_label_cost_(options.other_label_m * options.other_label_m),
      first_edge_(graph.nodes.size(), -1) {
  const int edges = static_cast<int>(graph.edges.size());
  for (int e = edges; e-- > 0;) first_edge_[at(graph.edge(e).from)] = e;
  for (const PathPart& part : options.parts) {
    parts_.push_back({part.from_m, part.to_m, frames_before(graph, part.label), {}});
    for (int e = 0; e < edges; ++e)
      parts_.back().shown.push_back(graph.label(graph.edge(e)) == part.label);
  }
}

WalkState PathObjective::after(const WalkState& state, int edge, int frames) const {
  const EdgeWay& way = ways_[at(edge)];
  const int count = counted(state, edge, frames);
  const Laying lay(state.place);
  WalkState next = state;
  for (int i = 0; i < count; ++i) {
    const Vector2d wanted = path_.at(state.travelled_m + way.frames(2, i));
    next.cost += (lay(way.frames(0, i), way.frames(1, i)) - wanted).squaredNorm();
  }
  next.cost += other_label_cost_ * other_label(state, edge, count);
  next.frames += count;
  next.travelled_m += count < way.frames.cols() ? way.frames(2, count) : way.metres;
  next.done = next.travelled_m >= path_.length();
  next.place = motion::after(state.place, way.move);
  next.node = graph_.edge(edge).to;
  return next;
}

double PathObjective::outlook(const WalkState& state, int frames) const {
  const int on = first_edge_[at(state.node)];
  if (on < 0) return 0;
  const EdgeWay& way = ways_[at(on)];
  const Laying lay(state.place);
  const Vector2d place = lay(way.frames(0, 0), way.frames(1, 0));
  const Vector2d off = place - path_.at(state.travelled_m);
  // A metre further on, if somebody just goes straight on.
  const Vector2d off_ahead =
      place + lay.turned(way.direction.x(), way.direction.y()) - path_.at(state.travelled_m + 1);
  double cost = 0.5 * frames * (off.squaredNorm() + off_ahead.squaredNorm());
  if (const Part* part = part_at(state.travelled_m)) {
    const int other = part->frames_before[at(state.node)];
    cost += other_label_cost_ * (other < 0 ? frames : std::min(frames, other));
  }
  return cost;
}

std::vector<WalkState> PathObjective::starts(const std::string& label) const {
  std::vector<WalkState> starts;
  const Vector2d from = path_.at(0);
  for (int node = 0; node < static_cast<int>(graph_.nodes.size()); ++node) {
    const int edge = first_edge_[at(node)];
    if (edge < 0 || ways_[at(edge)].direction.isZero()) continue;
    const auto& take = graph_.takes[at(graph_.node(node).take)];
    if (!label.empty() && take.label != label) continue;
    const double theta = angle(path_.direction(0)) - angle(ways_[at(edge)].direction);
    const Eigen::Vector2d pelvis = ways_[at(edge)].frames.col(0).head<2>();
    WalkState start;
    start.node = node;
    start.place = motion::after({theta, from.x(), from.y()}, {0, -pelvis.x(), -pelvis.y()});
    starts.push_back(start);
  }
  return starts;
}

int PathObjective::counted(const WalkState& state, int edge, int frames) const {
  const auto walked = ways_[at(edge)].frames.row(2);
  const double left = path_.length() - state.travelled_m;
  int count = frames;
  while (count > 0 && walked(count - 1) >= left) --count;
  return count;
}

double PathObjective::distance(const WalkState& state, int edge, int frame) const {
  const auto way = ways_[at(edge)].frames.col(frame);
  return (Laying(state.place)(way(0), way(1)) - path_.at(state.travelled_m + way(2))).norm();
}

int PathObjective::other_label(const WalkState& state, int edge, int frames) const {
  int count = 0;
  const auto walked = ways_[at(edge)].frames.row(2);
  for (const Part& part : parts_) {
    if (part.shown[at(edge)]) continue;
    const double from = part.from_m - state.travelled_m, to = part.to_m - state.travelled_m;
    if (frames == 0 || walked(0) >= to || walked(frames - 1) < from) continue;
    for (int i = 0; i < frames; ++i) count += walked(i) >= from && walked(i) < to;
  }
  return count;
}

const PathObjective::Part* PathObjective::part_at(double metres) const {
  for (const Part& part : parts_) {
    if (metres >= part.from_m && metres < part.to_m) return &part;
  }
  return nullptr;
}

}  // namespace promenade::motion
