#include "motion/graph/label_walk.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "motion/graph/cut_graph.h"
#include "motion/graph/passages.h"
#include "motion/rng.h"

namespace promenade::motion {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

double rms_of(const MotionGraph& graph, int edge) {
  const int transition = graph.edges[at(edge)].transition;
  return transition < 0 ? 0 : graph.transitions[at(transition)].rms_m;
}

// Draws edges; what was walked less often is more likely.
class Lot {
 public:
  Lot(const MotionGraph& graph, std::uint64_t seed, std::uint64_t stream)
      : rng_(seed, stream, "walk"), walked_(graph.edges.size(), 0) {}

  int below(int bound) { return static_cast<int>(rng_.below(static_cast<std::uint64_t>(bound))); }

  // One of these edges, at least one.
  int draw(const std::vector<int>& edges) {
    double left = 0;
    for (const int edge : edges) left += weight(edge);
    left *= rng_.uniform();
    for (const int edge : edges) {
      if ((left -= weight(edge)) < 0) return take(edge);
    }
    return take(edges.back());
  }

 private:
  double weight(int edge) const {
    const double often = 1 + walked_[at(edge)];
    return 1 / (often * often);
  }
  int take(int edge) {
    ++walked_[at(edge)];
    return edge;
  }

  Rng rng_;
  std::vector<int> walked_;  // how often, of each edge
};

// For each node, whether edges of the label alone lead on without end.
std::vector<bool> stays(const MotionGraph& graph, const std::string& label) {
  std::vector<int> ways(graph.nodes.size(), 0);
  std::vector<std::vector<int>> before(graph.nodes.size());
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
    if (!shows(graph, e, label)) continue;
    ++ways[at(graph.edges[at(e)].from)];
    before[at(graph.edges[at(e)].to)].push_back(graph.edges[at(e)].from);
  }
  std::vector<int> dead;
  for (int n = 0; n < static_cast<int>(ways.size()); ++n) {
    if (ways[at(n)] == 0) dead.push_back(n);
  }
  for (std::size_t d = 0; d < dead.size(); ++d) {
    for (const int n : before[at(dead[d])]) {
      if (--ways[at(n)] == 0) dead.push_back(n);
    }
  }
  std::vector<bool> stays(ways.size());
  for (std::size_t n = 0; n < ways.size(); ++n) stays[n] = ways[n] > 0;
  return stays;
}

// What walks need to know about one label.
struct Region {
  Passages passages;
  std::vector<std::vector<int>> edges;  // of each node, those with the label; first of all those
                                        // from which the label goes on
};

Region region_of(const MotionGraph& graph, const std::string& label) {
  Region region{passages_to(graph, label), std::vector<std::vector<int>>(graph.nodes.size())};
  const std::vector<bool> stay = stays(graph, label);
  std::vector<std::vector<int>> leaving(graph.nodes.size());
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
    if (!shows(graph, e, label)) continue;
    const GraphEdge& edge = graph.edges[at(e)];
    leaving[at(edge.from)].push_back(e);
    if (stay[at(edge.to)]) region.edges[at(edge.from)].push_back(e);
  }
  for (std::size_t n = 0; n < leaving.size(); ++n) {
    if (region.edges[n].empty()) region.edges[n] = std::move(leaving[n]);
  }
  return region;
}

// One walk by lot through all labels.
class LabelLot {
 public:
  LabelLot(const MotionGraph& graph, const std::vector<WantedLabel>& wanted,
           const std::vector<Region>& regions, const std::vector<int>& frames, Lot lot)
      : graph_(graph), wanted_(wanted), regions_(regions), frames_(frames), lot_(std::move(lot)) {}

  void run() {
    std::vector<int> begins;
    for (int n = 0; n < static_cast<int>(graph_.nodes.size()); ++n) {
      if (regions_.front().passages.frames[at(n)] == 0) begins.push_back(n);
    }
    node_ = begins[at(lot_.below(static_cast<int>(begins.size())))];
    for (std::size_t r = 0; r < regions_.size(); ++r) show(r);
  }

  const LabelWalk& walk() const { return walk_; }
  // The smaller the better: frames, and less than one for the transitions.
  double score() const { return walk_.other_label + beside_ + rms_ / (1 + rms_); }

 private:
  // Goes on in a label, and back to where leaving was best.
  void show(std::size_t r) {
    const Region& region = regions_[r];
    const bool last = r + 1 == regions_.size();
    const int wanted = frames_[r], slack = last ? 0 : wanted / 4;
    std::vector<int> edges = passage_from(graph_, region.passages, node_);
    Leaving best;
    for (int shown = 0; best.score < 0 || shown < wanted + slack;) {
      int node = edges.empty() ? node_ : end_of(edges.back());
      if (region.edges[at(node)].empty()) {
        const std::vector<int> back = passage_from(graph_, region.passages, node);
        edges.insert(edges.end(), back.begin(), back.end());
        node = end_of(edges.back());
      }
      edges.push_back(lot_.draw(region.edges[at(node)]));
      shown += graph_.edges[at(edges.back())].frames;
      const int on = last ? 0 : regions_[r + 1].passages.frames[at(end_of(edges.back()))];
      const int score = std::abs(shown - wanted) + on;
      if (on < 0 || shown + slack < wanted || (best.score >= 0 && score >= best.score)) continue;
      best = {score, shown, edges.size()};
    }
    edges.resize(best.edges);
    add(edges, r, std::abs(best.shown - wanted));
  }

  void add(const std::vector<int>& edges, std::size_t r, int beside) {
    for (const int edge : edges) {
      if (graph_.label(graph_.edges[at(edge)]) != wanted_[r].label) {
        walk_.other_label += graph_.edges[at(edge)].frames;
      }
      rms_ += rms_of(graph_, edge);
      walk_.edges.push_back(edge);
    }
    beside_ += beside;
    node_ = end_of(walk_.edges.back());
  }

  int end_of(int edge) const { return graph_.edges[at(edge)].to; }

  struct Leaving {
    int score = -1;  // frames beside the wanted ones and of the passage; -1: none yet
    int shown = 0;
    std::size_t edges = 0;
  };

  const MotionGraph& graph_;
  const std::vector<WantedLabel>& wanted_;
  const std::vector<Region>& regions_;
  const std::vector<int>& frames_;
  Lot lot_;
  LabelWalk walk_;
  int node_ = 0;
  int beside_ = 0;  // frames more or fewer than wanted
  double rms_ = 0;  // sum over transitions, metres
};

}  // namespace

std::vector<int> random_walk(const MotionGraph& graph, std::uint64_t seed, int frames) {
  Lot lot(graph, seed, 0);
  const Digraph ways = digraph_of(graph);
  std::vector<int> edges;
  int node = lot.below(static_cast<int>(graph.nodes.size()));
  for (int walked = 0; walked < frames && !ways.leaving(node).empty();) {
    const std::span<const int> leaving = ways.leaving(node);
    edges.push_back(lot.draw({leaving.begin(), leaving.end()}));
    walked += graph.edges[at(edges.back())].frames;
    node = graph.edges[at(edges.back())].to;
  }
  return edges;
}

LabelWalk walk_through_labels(const MotionGraph& graph, const std::vector<WantedLabel>& wanted,
                              std::uint64_t seed) {
  constexpr std::uint64_t tries = 64;
  std::vector<Region> regions;
  std::vector<int> frames;
  for (const WantedLabel& part : wanted) {
    require_label(graph, part.label);
    regions.push_back(region_of(graph, part.label));
    frames.push_back(std::max(1, static_cast<int>(std::lround(part.seconds / graph.frame_time))));
  }
  if (wanted.empty()) return {};
  std::optional<LabelLot> best;
  for (std::uint64_t i = 0; i < tries; ++i) {
    LabelLot one(graph, wanted, regions, frames, Lot(graph, seed, i + 1));
    one.run();
    if (!best || one.score() < best->score()) best.emplace(std::move(one));
  }
  return best->walk();
}

}  // namespace promenade::motion
