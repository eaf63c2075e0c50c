#include "motion/graph/walk_search.h"

#include <gtest/gtest.h>

#include "motion/graph/graph_walk.h"
#include "tests/motion/graph/arc_graph.h"
#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

// What an edge costs depends on how many edges came before: on the state, therefore.
class ToyObjective : public WalkObjective {
 public:
  ToyObjective(const MotionGraph& graph, std::uint64_t seed, double done_after = 1e9)
      : graph_(graph), seed_(seed), done_after_(done_after) {}

  WalkState after(const WalkState& state, int edge, int frames) const override {
    WalkState next = state;
    next.node = graph_.edge(edge).to;
    next.frames += frames;
    next.travelled_m += 1;
    Random random(seed_ + 97 * static_cast<std::uint64_t>(edge) +
                  7919 * static_cast<std::uint64_t>(state.travelled_m));
    next.cost += frames * random.uniform();
    next.done = next.travelled_m >= done_after_;
    return next;
  }
  // Misleads, on purpose.
  double outlook(const WalkState& state, int frames) const override {
    return Random(seed_ + static_cast<std::uint64_t>(state.node)).uniform() * frames;
  }

 private:
  const MotionGraph& graph_;
  std::uint64_t seed_;
  double done_after_;
};

// Every node has one to three edges.
MotionGraph random_graph(std::uint64_t seed) {
  Random random(seed);
  ArcGraph toy;
  const int take = toy.add_take("plain");
  const int nodes = 1 + static_cast<int>(random.uniform() * 6);
  for (int node = 0; node < nodes; ++node) toy.add_node(take);
  for (int node = 0; node < nodes; ++node) {
    for (int e = static_cast<int>(random.uniform() * 3); e >= 0; --e) {
      toy.add_arc(node, static_cast<int>(random.uniform() * nodes),
                  1 + static_cast<int>(random.uniform() * 5), 1, 0);
    }
  }
  return toy.graph;
}

struct Exhaustive {
  const MotionGraph& graph;
  const WalkObjective& objective;
  int last_frame;
  std::vector<int> edges, best_edges;
  double best = 1e300;

  void visit(const WalkState& state) {
    if (state.done || state.frames >= last_frame) {
      if (state.cost < best) best_edges = edges;
      best = std::min(best, state.cost);
      return;
    }
    for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
      const GraphEdge& edge = graph.edge(e);
      if (edge.from != state.node) continue;
      edges.push_back(e);
      visit(objective.after(state, e, std::min(edge.frames, last_frame - state.frames)));
      edges.pop_back();
    }
  }
};

Exhaustive enumerate(const MotionGraph& graph, const WalkObjective& objective, int horizon) {
  Exhaustive all{graph, objective, horizon, {}, {}};
  all.visit({});
  return all;
}

constexpr std::int64_t no_limit = 1'000'000'000;

TEST(WithinHorizon, NoWalkCostsLess) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const MotionGraph graph = random_graph(seed);
    const ToyObjective objective(graph, seed, seed % 3 == 0 ? 4 : 1e9);
    const int horizon = 1 + static_cast<int>(seed % 17);
    const Exhaustive all = enumerate(graph, objective, horizon);
    const FoundWalk found = WalkSearch(graph, objective).within_horizon({}, {horizon, 1, no_limit});
    EXPECT_EQ(found.end.cost, all.best) << "seed " << seed;
    EXPECT_EQ(found.edges, all.best_edges) << "seed " << seed;
    EXPECT_TRUE(found.complete);
  }
}

TEST(WithinHorizon, EdgesCountToTheHorizonAndNoFurther) {
  const MotionGraph graph = random_graph(7);
  const ToyObjective objective(graph, 7);
  const FoundWalk found = WalkSearch(graph, objective).within_horizon({}, {10, 1, no_limit});
  EXPECT_EQ(found.end.frames, 10);
  EXPECT_GE(walk_frames(graph, found.edges), 10);
}

TEST(WithinHorizon, AHintChangesNothingButTheEffort) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const MotionGraph graph = random_graph(seed);
    const ToyObjective objective(graph, seed);
    const WalkSearch search(graph, objective);
    const FoundWalk plain = search.within_horizon({}, {14, 1, no_limit});
    const FoundWalk hinted = search.within_horizon({{}, plain.edges}, {14, 1, no_limit});
    EXPECT_EQ(hinted.edges, plain.edges);
    EXPECT_LE(hinted.visited, plain.visited + static_cast<std::int64_t>(plain.edges.size()));
    const FoundWalk half =
        search.within_horizon({{}, std::span(plain.edges).first(1)}, {14, 1, no_limit});
    EXPECT_EQ(half.end.cost, plain.end.cost);
  }
}

TEST(WithinHorizon, WhatIsNotBelowABoundIsNoAnswer) {
  const MotionGraph graph = random_graph(3);
  const ToyObjective objective(graph, 3);
  const WalkSearch search(graph, objective);
  const double best = search.within_horizon({}, {12, 1, no_limit}).end.cost;
  EXPECT_TRUE(search.within_horizon({{}, {}, best}, {12, 1, no_limit}).edges.empty());
  EXPECT_EQ(search.within_horizon({{}, {}, best + 1e-9}, {12, 1, no_limit}).end.cost, best);
}

// Two edges from one node to itself, both of one frame: 2^horizon walks.
MotionGraph fork() {
  ArcGraph toy;
  const int node = toy.add_node(toy.add_take("plain"));
  for (int i = 0; i < 2; ++i) toy.add_arc(node, node, 1, 1, 0);
  return toy.graph;
}

TEST(WithinHorizon, AtTheLimitTheBestSoFarIsTaken) {
  const MotionGraph graph = fork();
  const ToyObjective objective(graph, 1);
  const FoundWalk found = WalkSearch(graph, objective).within_horizon({}, {40, 1, 1000});
  EXPECT_FALSE(found.complete);
  EXPECT_EQ(found.edges.size(), 40u);
  EXPECT_LT(found.visited, 1003);  // the last node's edges are looked at together
}

TEST(WithinHorizon, MoreEffortIsNeverWorse) {
  const MotionGraph graph = fork();
  const ToyObjective objective(graph, 5);
  double before = 1e300;
  for (const std::int64_t most : {1, 10, 100, 1000, 10000, 100000}) {
    const FoundWalk found = WalkSearch(graph, objective).within_horizon({}, {30, 1, most});
    EXPECT_LE(found.end.cost, before);
    before = found.end.cost;
  }
}

TEST(WithinHorizon, ADeepHorizonNeedsNoDeepStack) {
  ArcGraph ring;
  const int node = ring.add_node(ring.add_take("plain"));
  ring.add_arc(node, node, 1, 1, 0);
  const ToyObjective objective(ring.graph, 1);
  const FoundWalk found = WalkSearch(ring.graph, objective).within_horizon({}, {300'000, 1, 10});
  EXPECT_EQ(found.edges.size(), 300'000u);
  EXPECT_TRUE(found.complete);
}

TEST(WithinHorizon, AWalkThatCannotGoOnIsNoAnswer) {
  ArcGraph toy;
  const int take = toy.add_take("plain");
  for (int i = 0; i < 3; ++i) toy.add_node(take);
  toy.add_arc(0, 1, 1, 1, 0);  // a dead end
  toy.add_arc(0, 2, 1, 1, 0);
  toy.add_arc(2, 2, 1, 1, 0);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const ToyObjective objective(toy.graph, seed);
    const WalkSearch search(toy.graph, objective);
    EXPECT_EQ(search.within_horizon({}, {5, 1, no_limit}).edges.front(), 1);
    WalkState dead_end;
    dead_end.node = 1;
    EXPECT_TRUE(search.within_horizon({dead_end}, {5, 1, 9}).edges.empty());
  }
}

TEST(WholeWalk, StaysOnTheGraphUntilItIsDone) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const MotionGraph graph = random_graph(seed);
    const ToyObjective objective(graph, seed, 60);
    const FoundWalk found = WalkSearch(graph, objective).whole_walk({}, {9, 3, no_limit});
    EXPECT_TRUE(holds_together(graph, found.edges));
    EXPECT_EQ(graph.edge(found.edges.front()).from, 0);
    EXPECT_EQ(found.edges.size(), 60u);
    EXPECT_TRUE(found.end.done && found.complete);
  }
}

TEST(WholeWalk, OfOneHorizonIsTheBest) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const MotionGraph graph = random_graph(seed);
    const ToyObjective objective(graph, seed, 4);
    const FoundWalk found = WalkSearch(graph, objective).whole_walk({}, {20, 3, no_limit});
    EXPECT_EQ(found.end.cost, enumerate(graph, objective, 20).best) << "seed " << seed;
  }
}

TEST(WholeWalk, EndsWhereItHasFramesEnough) {
  const MotionGraph graph = fork();
  const ToyObjective objective(graph, 1);
  const FoundWalk found = WalkSearch(graph, objective).whole_walk({}, {8, 2, no_limit, 101});
  EXPECT_EQ(found.end.frames, 102);  // two at a time
  EXPECT_FALSE(found.end.done);
}

TEST(WholeWalk, CanBeStoppedAndKeepsTheBestSoFar) {
  const MotionGraph graph = fork();
  const ToyObjective objective(graph, 1, 1000);
  int asked = 0;
  std::size_t told = 0;
  const FoundWalk found =
      WalkSearch(graph, objective).whole_walk({}, {8, 2, no_limit}, [&](const FoundWalk& best) {
        told = best.edges.size();
        return ++asked < 5;
      });
  EXPECT_TRUE(found.stopped && !found.complete);
  EXPECT_EQ(found.edges.size(), told);
  EXPECT_EQ(told, 16u);  // four times two are kept, and a horizon of eight
}

TEST(WithinHorizon, CanBeStopped) {
  const MotionGraph graph = fork();
  const ToyObjective objective(graph, 1);
  const FoundWalk found =
      WalkSearch(graph, objective).within_horizon({}, {60, 1, no_limit}, [](const FoundWalk&) {
        return false;
      });
  EXPECT_TRUE(found.stopped && !found.complete);
  EXPECT_EQ(found.edges.size(), 60u);
}

}  // namespace
}  // namespace promenade::motion
