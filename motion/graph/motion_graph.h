// A motion graph ([K] 3): captured takes cut at the places where they can be left or entered, and
// transitions between them. Any walk along its edges is a motion. Start here to understand
// motion/graph.
//
// A node is a frame of a take. An edge leads from node to node in `frames` steps of time: along
// its take, or by a transition into another place. Everything a walk shows lies in `takes` and
// in the poses of the transitions; nodes without a way on were pruned.
#pragma once

#include <cstdint>

#include "motion/graph/matches.h"
#include "motion/graph/transition.h"

namespace promenade::motion {

struct GraphTake {
  Take take;                // on the graph's skeleton
  std::string label;        // its style
  std::string sha256 = {};  // of the file; empty: not known
};

// Each label once, in order of the alphabet.
std::vector<std::string> labels_of(const std::vector<GraphTake>& takes);

struct GraphNode {
  int take = 0, frame = 0;
};

struct GraphEdge {
  int from = 0, to = 0;  // nodes
  int frames = 0;        // steps from one to the other, at least 1
  int transition = -1;   // in MotionGraph::transitions; -1: along the take
};

struct GraphTransition {
  TransitionFrames frames;  // of the takes of its edge's nodes
  double rms_m = 0;         // of the match
  PlanarMove move;          // lays the take entered over the take left
  // Frames 0 .. k - 2, where the take left is. Rounded to single precision: they are most of a
  // graph, and a file of half the size shows the same to a hundredth of a millimetre.
  std::vector<Pose> poses;
  TransitionQuality quality;
};

struct MotionGraph {
  std::string name;
  std::vector<GraphTake> takes;
  std::vector<GraphNode> nodes;  // in order of takes and frames
  std::vector<GraphEdge> edges;  // by `from`; along the take first, then transitions by rms
  std::vector<GraphTransition> transitions;
  MatchOptions options;
  double threshold_m = 0;  // that was used
  double frame_time = 0;   // seconds, of all takes
  int window = 0;          // frames

  const GraphNode& node(int number) const { return nodes[static_cast<std::size_t>(number)]; }
  const GraphEdge& edge(int number) const { return edges[static_cast<std::size_t>(number)]; }
  const GraphTake& take(int number) const { return takes[static_cast<std::size_t>(number)]; }
  const GraphTransition& transition(int number) const {
    return transitions[static_cast<std::size_t>(number)];
  }

  const Skeleton& skeleton() const { return takes.front().take.skeleton; }
  const BodyMap& body() const { return takes.front().take.body; }
  // The label of what is seen along an edge: that of the take it leads to.
  const std::string& label(const GraphEdge& edge) const {
    return takes[static_cast<std::size_t>(nodes[static_cast<std::size_t>(edge.to)].take)].label;
  }
};

// What became of the takes on the way to the graph.
struct GraphStatistics {
  int frames = 0;                    // of all takes
  int minima = 0, matches = 0;       // local minima of the maps; those below the threshold
  int refused = 0;                   // transitions whose feet or seams are not good enough
  int nodes_cut = 0, edges_cut = 0;  // before pruning
  int nodes = 0, edges = 0, transitions = 0;
  double seconds_kept = 0;        // of captured motion that a walk can show
  std::vector<std::string> lost;  // labels of which nothing is left
};

// A transition that was not good enough.
struct RefusedTransition {
  int from_take = 0, to_take = 0;
  TransitionFrames frames;
  double rms_m = 0;
  TransitionQuality quality;
  std::string reason;
};

struct BuiltGraph {
  MotionGraph graph;  // without nodes: see `trouble`
  GraphStatistics statistics;
  std::string trouble;  // why there is no walk, and a way out; empty: there are walks
  std::vector<RefusedTransition> refusals;
};

// Takes share joints and frame time (checked by whoever reads them). `progress` is told what is
// done and how much of it, and returns false to stop: then an OutsideError.
BuiltGraph build_graph(std::vector<GraphTake> takes, const MatchOptions& options,
                       const std::function<bool(const std::string&, double)>& progress = {});

// The part of a graph in which these labels can be walked forever, transitions among them
// included. Nodes and edges keep their order; without nodes: there is no such walk.
MotionGraph part_with_labels(const MotionGraph& graph, const std::vector<std::string>& labels);

}  // namespace promenade::motion
