#include "motion/graph/label_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "motion/graph/cut_graph.h"
#include "motion/graph/graph_labels.h"
#include "motion/rng.h"

namespace promenade::motion {
namespace {

// A frame with another label than the one wanted weighs more than anything else can.
constexpr double price_of_frame = 1000;
// What one beyond the wanted seconds does: less, or a walk would leave a label too early.
constexpr double price_beyond = 500;
// Luck that decides between walks which are nearly as good: where they begin, and what else a
// transition costs beside its rms, up to so many metres.
constexpr double most_luck = 0.01;
// So long a walk is looked at as a whole; of a longer one its first half is kept.
constexpr double horizon_s = 20;

// The label that is wanted at each frame.
std::vector<int> wanted_frames(const MotionGraph& graph, const std::vector<WantedLabel>& wanted) {
  std::vector<int> frames;
  double until = 0;
  for (std::size_t w = 0; w < wanted.size(); ++w) {
    until += wanted[w].seconds;
    frames.resize(static_cast<std::size_t>(std::lround(until / graph.frame_time)),
                  static_cast<int>(w));
  }
  return frames;
}

// The best walk through labels over some frames, by dynamic programming: every frame at every
// node is reached at the least price, so that no walk of the graph is better.
class LabelPlan {
 public:
  LabelPlan(const MotionGraph& graph, const std::vector<WantedLabel>& wanted, std::uint64_t seed)
      : graph_(graph), wanted_(wanted), frames_(wanted_frames(graph, wanted)) {
    Rng rng(seed, 0, "walk through labels");
    for (const GraphEdge& edge : graph.edges) {
      if (edge.transition < 0) {
        price_.push_back(0);
        continue;
      }
      const double rms = graph.transition(edge.transition).rms_m;
      price_.push_back(rms + most_luck * rng.uniform());
    }
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
      price_of_start_.push_back(most_luck * rng.uniform());
    }
    count_matches();
  }

  LabelWalk walk() {
    LabelWalk found;
    const int all = static_cast<int>(frames_.size());
    const int horizon =
        std::max(static_cast<int>(std::lround(horizon_s / graph_.frame_time)), longest_edge() + 1);
    int from = 0, node = -1;
    while (from < all) {
      const std::vector<int> edges = plan(from, std::min(from + horizon, all), node);
      if (edges.empty()) break;
      const bool last = from + horizon >= all;
      const int keep_until = last ? std::numeric_limits<int>::max() : from + horizon / 2;
      for (const int e : edges) {
        if (from >= keep_until) break;
        found.edges.push_back(e);
        found.other_label += others(e, from);
        from += edge(e).frames;
        node = edge(e).to;
      }
    }
    return found;
  }

 private:
  const GraphEdge& edge(int e) const { return graph_.edge(e); }

  int longest_edge() const {
    int most = 0;
    for (const GraphEdge& one : graph_.edges) most = std::max(most, one.frames);
    return most;
  }

  // For each wanted label, in how many of the first f frames another entry with the same label
  // is wanted: any sum over frames is then one difference.
  void count_matches() {
    for (const WantedLabel& one : wanted_) {
      if (matches_.count(one.label) > 0) continue;
      std::vector<int>& sums = matches_[one.label];
      sums.push_back(0);
      for (const int w : frames_) {
        const bool same = wanted_[static_cast<std::size_t>(w)].label == one.label;
        sums.push_back(sums.back() + (same ? 1 : 0));
      }
    }
    for (const GraphEdge& one : graph_.edges) {
      const auto found = matches_.find(graph_.label(one));
      sums_of_edge_.push_back(found == matches_.end() ? nullptr : &found->second);
    }
  }

  // Frames of an edge from frame `from` on that show another label than the one wanted.
  int others(int e, int from) const {
    const int to = std::min(from + edge(e).frames, static_cast<int>(frames_.size()));
    const std::vector<int>* sums = sums_of_edge_[static_cast<std::size_t>(e)];
    if (sums == nullptr) return to - from;
    return to - from -
           ((*sums)[static_cast<std::size_t>(to)] - (*sums)[static_cast<std::size_t>(from)]);
  }

  double price(int e, int from) const {
    const int beyond = std::max(from + edge(e).frames - static_cast<int>(frames_.size()), 0);
    return price_of_frame * others(e, from) + price_beyond * beyond +
           price_[static_cast<std::size_t>(e)];
  }

  // Edges from `node` (any: -1) at frame `from` that reach `to` at the least price.
  std::vector<int> plan(int from, int to, int node) const {
    const auto nodes = graph_.nodes.size();
    const auto rows = static_cast<std::size_t>(to - from);
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> reached(rows * nodes, never);
    std::vector<int> by(rows * nodes, -1);
    for (std::size_t n = 0; n < nodes; ++n) {
      if (node < 0) reached[n] = price_of_start_[n];
      if (static_cast<int>(n) == node) reached[n] = 0;
    }
    double best = std::numeric_limits<double>::infinity();
    int last = -1;
    std::size_t last_row = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
        const GraphEdge& one = graph_.edges[e];
        const double before = reached[row * nodes + static_cast<std::size_t>(one.from)];
        if (before == never) continue;
        const double total = before + price(static_cast<int>(e), from + static_cast<int>(row));
        const std::size_t next = row + static_cast<std::size_t>(one.frames);
        if (next < rows) {
          const std::size_t cell = next * nodes + static_cast<std::size_t>(one.to);
          if (total >= reached[cell]) continue;
          reached[cell] = total;
          by[cell] = static_cast<int>(e);
        } else if (total < best) {
          best = total;
          last = static_cast<int>(e);
          last_row = row;
        }
      }
    }
    return traced(by, last, last_row);
  }

  std::vector<int> traced(const std::vector<int>& by, int last, std::size_t row) const {
    std::vector<int> edges;
    for (int e = last; e >= 0;) {
      edges.push_back(e);
      const int before = by[row * graph_.nodes.size() + static_cast<std::size_t>(edge(e).from)];
      if (row == 0 || before < 0) break;
      row -= static_cast<std::size_t>(edge(before).frames);
      e = before;
    }
    std::reverse(edges.begin(), edges.end());
    return edges;
  }

  const MotionGraph& graph_;
  const std::vector<WantedLabel>& wanted_;
  std::vector<int> frames_;             // the entry of wanted_ for each frame
  std::vector<double> price_;           // of each edge, beside its frames
  std::vector<double> price_of_start_;  // of each node
  std::map<std::string, std::vector<int>> matches_;
  std::vector<const std::vector<int>*> sums_of_edge_;  // null: nobody wants its label
};

}  // namespace

std::vector<int> random_walk(const MotionGraph& graph, std::uint64_t seed, int frames) {
  std::vector<int> edges;
  if (graph.nodes.empty()) return edges;
  const Digraph ways = digraph_of(graph);
  std::vector<int> walked(graph.edges.size(), 0);
  Rng rng(seed, 0, "random walk");
  int node = static_cast<int>(rng.below(graph.nodes.size()));
  for (int done = 1; done < frames && !ways.leaving(node).empty();) {
    // By lot among those that were walked least: no walk circles in one loop.
    int least = std::numeric_limits<int>::max();
    for (const int e : ways.leaving(node))
      least = std::min(least, walked[static_cast<std::size_t>(e)]);
    std::vector<int> fresh;
    for (const int e : ways.leaving(node)) {
      if (walked[static_cast<std::size_t>(e)] == least) fresh.push_back(e);
    }
    const int e = fresh[rng.below(fresh.size())];
    ++walked[static_cast<std::size_t>(e)];
    edges.push_back(e);
    done += graph.edge(e).frames;
    node = graph.edge(e).to;
  }
  return edges;
}

LabelWalk walk_through_labels(const MotionGraph& graph, const std::vector<WantedLabel>& wanted,
                              std::uint64_t seed) {
  for (const WantedLabel& one : wanted) require_label(graph, one.label);
  return LabelPlan(graph, wanted, seed).walk();
}

}  // namespace promenade::motion
