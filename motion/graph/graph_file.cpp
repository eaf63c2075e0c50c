#include "motion/graph/graph_file.h"

#include <cmath>

#include "motion/skeleton_bytes.h"

namespace promenade::motion {
namespace {

const SealedKind kind{"PROMGRAF", 1, 1, "a motion graph", "promenade graph build"};

// The fields of small structs, in the order in which they stand in the file. Given to a writer
// or a reader, so that the two cannot differ.
template <typename Quality, typename Visit>
void visit_numbers(Quality& quality, const Visit& visit) {
  visit(quality.slide_m);
  visit(quality.slide_raw_m);
  visit(quality.gap_m);
  visit(quality.inside_gap_m);
  visit(quality.knee_gap);
  visit(quality.inside_knee_gap);
  visit(quality.moved_m);
}

void write(ByteWriter& out, const std::vector<Pose>& poses) {
  out.count(poses.size());
  for (const Pose& pose : poses) {
    out.numbers(pose.root.data(), 3);
    for (const Eigen::Quaterniond& q : pose.rotations) out.numbers(q.coeffs().data(), 4);
  }
}

// Transitions are most of a graph, and are kept in single precision (motion_graph.h).
void write_single(ByteWriter& out, const std::vector<Pose>& poses) {
  const auto single = [&out](const double* values, int count) {
    for (int k = 0; k < count; ++k) out.f32(static_cast<float>(values[k]));
  };
  out.count(poses.size());
  for (const Pose& pose : poses) {
    single(pose.root.data(), 3);
    for (const Eigen::Quaterniond& q : pose.rotations) single(q.coeffs().data(), 4);
  }
}

void write(ByteWriter& out, const GraphTake& one) {
  out.text(one.label);
  out.text(one.sha256);
  out.text(one.take.source);
  out.u32(static_cast<std::uint32_t>(one.take.first_frame));
  write(out, one.take.poses);
}

void write(ByteWriter& out, const GraphTransition& transition) {
  for (const int frame : {transition.frames.i, transition.frames.j, transition.frames.k}) {
    out.u32(static_cast<std::uint32_t>(frame));
  }
  for (const double value :
       {transition.rms_m, transition.move.theta, transition.move.x0, transition.move.z0}) {
    out.f64(value);
  }
  visit_numbers(transition.quality, [&out](double value) { out.f64(value); });
  write_single(out, transition.poses);
}

void write(ByteWriter& out, const MatchOptions& options) {
  out.f64(options.threshold_m);
  out.f64(options.quantile.value_or(-1));
  out.f64(options.window_s);
  out.f64(options.apart_s);
  out.u32(options.tapered ? 1 : 0);
  out.count(options.labels.size());
  for (const LabelThreshold& label : options.labels) {
    out.text(label.from);
    out.text(label.to);
    out.f64(label.rms_m);
  }
}

MatchOptions read_options(ByteReader& in) {
  MatchOptions options;
  options.threshold_m = read_finite(in);
  const double quantile = read_finite(in);
  if (quantile >= 0) options.quantile = quantile;
  options.window_s = read_finite(in);
  options.apart_s = read_finite(in);
  options.tapered = read_index(in, 2, "choice") == 1;
  options.labels.resize(in.count(16));
  for (LabelThreshold& label : options.labels) {
    label.from = in.text();
    label.to = in.text();
    label.rms_m = read_finite(in);
  }
  return options;
}

enum class Precision { single_, double_ };

void read_numbers(ByteReader& in, Precision precision, double* values, std::size_t count) {
  if (precision == Precision::double_) return read_finite(in, values, count);
  for (std::size_t k = 0; k < count; ++k) {
    values[k] = in.f32();
    if (!std::isfinite(values[k])) in.fail("holds a number that is not finite");
  }
}

std::vector<Pose> read_poses(ByteReader& in, std::size_t joints, Precision precision) {
  const std::size_t bytes = precision == Precision::single_ ? 4 : 8;
  std::vector<Pose> poses(in.count(bytes * (3 + 4 * joints)));
  Eigen::Matrix4Xd rotations(4, joints);
  for (Pose& pose : poses) {
    read_numbers(in, precision, pose.root.data(), 3);
    read_numbers(in, precision, rotations.data(), 4 * joints);
    check_rotations(in, rotations);
    pose.rotations.reserve(joints);
    for (const auto& column : rotations.colwise()) pose.rotations.emplace_back(column);
  }
  return poses;
}

GraphTake read_take(ByteReader& in, const Take& model) {
  GraphTake one;
  one.label = in.text();
  one.sha256 = in.text();
  one.take.source = in.text();
  one.take.skeleton = model.skeleton;
  one.take.body = model.body;
  one.take.frame_time = model.frame_time;
  one.take.first_frame = read_frame_number(in);
  one.take.poses = read_poses(in, model.skeleton.joints.size(), Precision::double_);
  if (one.take.poses.empty()) in.fail("has a take without frames");
  return one;
}

GraphTransition read_transition(ByteReader& in, std::size_t joints) {
  GraphTransition transition;
  for (int* frame : {&transition.frames.i, &transition.frames.j, &transition.frames.k}) {
    *frame = read_frame_number(in);
  }
  for (double* value :
       {&transition.rms_m, &transition.move.theta, &transition.move.x0, &transition.move.z0}) {
    *value = read_finite(in);
  }
  visit_numbers(transition.quality, [&in](double& value) { value = read_finite(in); });
  transition.poses = read_poses(in, joints, Precision::single_);
  return transition;
}

GraphNode read_node(ByteReader& in, const MotionGraph& graph) {
  GraphNode node;
  node.take = read_index(in, graph.takes.size(), "take");
  const Take& take = graph.take(node.take).take;
  node.frame = read_index(in, take.poses.size(), "frame");
  return node;
}

// Whether an edge shows what is there: frames of its take, or poses of its transition.
bool makes_sense(const MotionGraph& graph, const GraphEdge& edge) {
  const GraphNode& from = graph.node(edge.from);
  const GraphNode& to = graph.node(edge.to);
  if (edge.transition < 0) {
    return edge.frames > 0 && from.take == to.take && to.frame - from.frame == edge.frames;
  }
  const GraphTransition& transition = graph.transition(edge.transition);
  return edge.frames > 0 && transition.frames.k == edge.frames + 1 &&
         transition.frames.i == from.frame && transition.frames.j == to.frame &&
         transition.poses.size() == static_cast<std::size_t>(edge.frames);
}

GraphEdge read_edge(ByteReader& in, const MotionGraph& graph) {
  GraphEdge edge;
  edge.from = read_index(in, graph.nodes.size(), "node");
  edge.to = read_index(in, graph.nodes.size(), "node");
  edge.frames = read_frame_number(in);
  edge.transition = read_index(in, graph.transitions.size() + 1, "transition") - 1;
  if (!makes_sense(graph, edge)) in.fail("has an edge that does not fit its nodes");
  return edge;
}

void write_content(ByteWriter& out, const MotionGraph& graph) {
  out.text(graph.name);
  write(out, graph.options);
  out.f64(graph.threshold_m);
  out.f64(graph.frame_time);
  out.u32(static_cast<std::uint32_t>(graph.window));
  write(out, graph.skeleton());
  write(out, graph.body());
  out.count(graph.takes.size());
  for (const GraphTake& one : graph.takes) write(out, one);
  out.count(graph.nodes.size());
  for (const GraphNode& node : graph.nodes) {
    out.u32(static_cast<std::uint32_t>(node.take));
    out.u32(static_cast<std::uint32_t>(node.frame));
  }
  out.count(graph.transitions.size());
  for (const GraphTransition& transition : graph.transitions) write(out, transition);
  out.count(graph.edges.size());
  for (const GraphEdge& edge : graph.edges) {
    for (const int value : {edge.from, edge.to, edge.frames, edge.transition + 1}) {
      out.u32(static_cast<std::uint32_t>(value));
    }
  }
}

void read_takes(ByteReader& in, MotionGraph& graph) {
  Take model;
  model.skeleton = read_skeleton(in);
  model.body = read_body(in, model.skeleton.joints.size());
  model.frame_time = graph.frame_time;
  const std::size_t takes = in.count(20);
  if (takes == 0) in.fail("has no takes");
  for (std::size_t t = 0; t < takes; ++t) graph.takes.push_back(read_take(in, model));
}

void read_parts(ByteReader& in, MotionGraph& graph) {
  const std::size_t nodes = in.count(8);
  for (std::size_t n = 0; n < nodes; ++n) graph.nodes.push_back(read_node(in, graph));
  const std::size_t joints = graph.skeleton().joints.size();
  const std::size_t transitions = in.count(104);
  for (std::size_t t = 0; t < transitions; ++t) {
    graph.transitions.push_back(read_transition(in, joints));
  }
  const std::size_t edges = in.count(16);
  for (std::size_t e = 0; e < edges; ++e) graph.edges.push_back(read_edge(in, graph));
}

}  // namespace

std::string to_bytes(const MotionGraph& graph) {
  ByteWriter out;
  write_content(out, graph);
  return sealed(kind.magic, kind.newest, out.take());
}

MotionGraph graph_from_bytes(std::string_view bytes, const std::string& file) {
  ByteReader in(checked_content(kind, bytes, file).bytes, file);
  MotionGraph graph;
  graph.name = in.text();
  graph.options = read_options(in);
  graph.threshold_m = read_finite(in);
  graph.frame_time = read_finite(in);
  if (graph.frame_time <= 0) in.fail("has frames that take no time");
  graph.window = read_frame_number(in);
  read_takes(in, graph);
  read_parts(in, graph);
  if (!in.at_end()) in.fail("has more at its end than a motion graph; build it again");
  return graph;
}

}  // namespace promenade::motion
