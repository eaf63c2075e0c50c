#include "motion/graph/motion_graph.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <set>

#include "motion/decimal.h"
#include "motion/graph/all_cores.h"
#include "motion/graph/cut_graph.h"
#include "motion/graph/graph_labels.h"

namespace promenade::motion {
namespace {

constexpr int most_matches = 100'000;  // some gigabytes of transitions

using Progress = std::function<bool(const std::string&, double)>;

[[noreturn]] void stop() {
  throw OutsideError("stopped before the graph was built; nothing is written");
}

std::vector<LabelledClouds> clouds_of(const std::vector<GraphTake>& takes) {
  std::vector<LabelledClouds> clouds;
  const Eigen::VectorXd weights =
      joint_weights(takes.front().take.skeleton, takes.front().take.body);
  for (const GraphTake& one : takes) {
    clouds.push_back({joint_clouds(one.take, weights), one.label});
  }
  return clouds;
}

// Both ways that a match offers, the transitions not yet made.
std::vector<Passage> offered(const Matches& matches) {
  std::vector<Passage> passages;
  const int k = matches.window;
  for (const Match& match : matches.found) {
    Passage there{match.take_a, match.take_b, {}}, back{match.take_b, match.take_a, {}};
    there.transition.frames = {match.start_a, match.start_b + k - 1, k};
    there.transition.move = match.move;
    back.transition.frames = {match.start_b, match.start_a + k - 1, k};
    back.transition.move = inverse(match.move);
    there.transition.rms_m = back.transition.rms_m = match.rms_m;
    passages.push_back(std::move(there));
    passages.push_back(std::move(back));
  }
  return passages;
}

void round_to_single(std::vector<Pose>& poses) {
  for (Pose& pose : poses) {
    pose.root = pose.root.cast<float>().cast<double>();
    for (Eigen::Quaterniond& q : pose.rotations) q = q.cast<float>().cast<double>();
  }
}

// Makes the transitions that are only placed so far; of each it says why it cannot be used, or
// nothing.
std::vector<std::string> make_transitions(const std::vector<GraphTake>& takes,
                                          std::vector<Passage>& passages,
                                          const Progress& progress) {
  std::vector<FootedTake> footed;
  footed.reserve(takes.size());
  for (const GraphTake& one : takes) footed.push_back(make_footed(one.take));
  std::vector<std::string> refusals(passages.size());
  const auto make = [&](int number) {
    const auto p = static_cast<std::size_t>(number);
    GraphTransition& placed = passages[p].transition;
    Transition made = make_transition(footed[static_cast<std::size_t>(passages[p].from_take)],
                                      footed[static_cast<std::size_t>(passages[p].to_take)],
                                      placed.frames, placed.move);
    placed.move = made.move;
    placed.quality = made.quality;
    refusals[p] = std::move(made.refusal);
    if (!refusals[p].empty()) return;
    placed.poses = std::move(made.poses);
    round_to_single(placed.poses);
  };
  const bool finished = for_each_piece(static_cast<int>(passages.size()), make, [&](double share) {
    return !progress || progress("making transitions", share);
  });
  if (!finished) stop();
  return refusals;
}

void drop_refused(const std::vector<std::string>& refusals, std::vector<Passage>& passages,
                  BuiltGraph& built) {
  std::vector<Passage> kept;
  for (std::size_t p = 0; p < passages.size(); ++p) {
    if (refusals[p].empty()) {
      kept.push_back(std::move(passages[p]));
    } else {
      built.refusals.push_back({passages[p].from_take, passages[p].to_take,
                                passages[p].transition.frames, passages[p].transition.rms_m,
                                passages[p].transition.quality, refusals[p]});
    }
  }
  passages = std::move(kept);
}

void prune(MotionGraph& graph) {
  keep_nodes(largest_component(digraph_of(graph)), graph);
  join_straight_nodes(graph);
}

void count_what_is_left(BuiltGraph& built) {
  const MotionGraph& graph = built.graph;
  GraphStatistics& statistics = built.statistics;
  statistics.nodes = static_cast<int>(graph.nodes.size());
  statistics.edges = static_cast<int>(graph.edges.size());
  statistics.transitions = static_cast<int>(graph.transitions.size());
  for (const GraphEdge& edge : graph.edges) {
    if (edge.transition < 0) statistics.seconds_kept += edge.frames * graph.frame_time;
  }
  const std::vector<std::string> all = labels_of(graph.takes), left = edge_labels(graph);
  std::set_difference(all.begin(), all.end(), left.begin(), left.end(),
                      std::back_inserter(statistics.lost));
}

std::string metres(double value) { return short_number(value, 2) + " m"; }

// Why there is no walk, and what to do.
std::string trouble_of(const BuiltGraph& built, const Matches& matches) {
  const GraphStatistics& statistics = built.statistics;
  if (!built.graph.nodes.empty()) return {};
  if (statistics.minima == 0) {
    return "has no two windows to compare: takes shorter than " + std::to_string(matches.window) +
           " frames give none; use longer takes or a shorter window";
  }
  if (statistics.matches == 0) {
    return "has no two moments within " + metres(matches.threshold_m) + "; raise the threshold";
  }
  if (statistics.refused == 2 * statistics.matches) {
    const auto best =
        std::min_element(built.refusals.begin(), built.refusals.end(),
                         [](const auto& a, const auto& b) { return a.rms_m < b.rms_m; });
    return "has no transition that can be used; of the best it is said: " + best->reason;
  }
  return "has transitions but no way back along them, so no walk goes on; raise the threshold or "
         "add takes";
}

}  // namespace

std::vector<std::string> labels_of(const std::vector<GraphTake>& takes) {
  std::set<std::string> labels;
  for (const GraphTake& one : takes) labels.insert(one.label);
  return {labels.begin(), labels.end()};
}

BuiltGraph build_graph(std::vector<GraphTake> takes, const MatchOptions& options,
                       const Progress& progress) {
  assert(!takes.empty() && "a graph has takes");
  BuiltGraph built;
  MotionGraph& graph = built.graph;
  graph.takes = std::move(takes);
  graph.options = options;
  graph.frame_time = graph.takes.front().take.frame_time;
  for (const GraphTake& one : graph.takes) built.statistics.frames += one.take.frames();
  bool stopped = false;
  const Matches matches =
      find_matches(clouds_of(graph.takes), graph.frame_time, options, [&](double share) {
        stopped = progress && !progress("comparing frames", share);
        return !stopped;
      });
  if (stopped) stop();
  graph.threshold_m = matches.threshold_m;
  graph.window = matches.window;
  built.statistics.minima = matches.minima;
  built.statistics.matches = static_cast<int>(matches.found.size());

  if (built.statistics.matches > most_matches) {
    built.trouble = "has " + std::to_string(matches.found.size()) +
                    " moments that are alike, more than a graph can hold; lower the threshold";
    return built;
  }
  std::vector<Passage> passages = offered(matches);
  drop_refused(make_transitions(graph.takes, passages, progress), passages, built);
  built.statistics.refused = static_cast<int>(built.refusals.size());
  cut_at(std::move(passages), graph);
  built.statistics.nodes_cut = static_cast<int>(graph.nodes.size());
  built.statistics.edges_cut = static_cast<int>(graph.edges.size());
  prune(graph);
  count_what_is_left(built);
  built.trouble = trouble_of(built, matches);
  return built;
}

MotionGraph part_with_labels(const MotionGraph& graph, const std::vector<std::string>& labels) {
  std::vector<bool> wanted;
  for (const GraphNode& node : graph.nodes) {
    const std::string& label = graph.take(node.take).label;
    wanted.push_back(std::find(labels.begin(), labels.end(), label) != labels.end());
  }
  MotionGraph part = part_of(graph, wanted);
  prune(part);
  return part;
}

}  // namespace promenade::motion
