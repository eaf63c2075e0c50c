// The thread that searches walks, without a window.
#include "app/path_worker.h"

#include <gtest/gtest.h>

#include "motion/graph/graph_walk.h"
#include "tests/app/path_bench.h"

namespace promenade::app {
namespace {

using bench::last_news;
using bench::patient;
using bench::shared_walks_graph;
using bench::straight_path;

TEST(PathWorker, FindsTheWalkAlongAPath) {
  PathWorker worker(shared_walks_graph(), {});
  EXPECT_FALSE(worker.working());
  worker.start(straight_path(3, "sad"));
  EXPECT_TRUE(worker.working());
  const auto found = last_news(worker);
  ASSERT_TRUE(found && found->result);
  EXPECT_NEAR(found->result->walked_m, 3, 0.1);
  EXPECT_EQ(found->result->other_label, 0);
  EXPECT_EQ(found->motion->take.frames(), found->result->frames + 1) << "to the end of the path";
  EXPECT_EQ(found->motion->labels.front().label, "sad");
  EXPECT_EQ(worker.trouble(), "");
  EXPECT_EQ(worker.news(), nullptr) << "that was all";
}

TEST(PathWorker, FindsWhatTheSearchFindsWithoutIt) {
  const WantedPath path = straight_path(3);
  PathWorker worker(shared_walks_graph(), {});
  worker.start(path);
  const motion::PathWalk alone =
      motion::walk_along(*shared_walks_graph(), motion::GroundPath(path.points));
  EXPECT_EQ(last_news(worker)->motion->edges, alone.walk.edges);
}

TEST(PathWorker, TellsTheBestSoFarAndKeepsItWhenItIsStopped) {
  PathWorker worker(shared_walks_graph(), patient());
  worker.start(straight_path(400));
  std::shared_ptr<const WalkedPath> so_far;
  while (so_far == nullptr && worker.working()) so_far = worker.news();
  ASSERT_TRUE(so_far);
  EXPECT_FALSE(so_far->result) << "it is still searched";
  EXPECT_LT(worker.share(), 1);
  EXPECT_TRUE(motion::holds_together(*shared_walks_graph(), so_far->motion->edges));
  worker.stop();
  const auto found = last_news(worker);
  ASSERT_TRUE(found && found->result);
  EXPECT_TRUE(found->result->stopped);
  EXPECT_GT(found->motion->take.frames(), 1);
}

TEST(PathWorker, TurnsToTheLastPathThatWasAskedFor) {
  PathWorker worker(shared_walks_graph(), patient());
  worker.start(straight_path(400));
  worker.start(straight_path(500));
  worker.start(straight_path(1));
  const auto found = last_news(worker);
  ASSERT_TRUE(found && found->result);
  EXPECT_NEAR(found->result->walked_m, 1, 0.1);
}

TEST(PathWorker, ForgetsWhatWasAskedFor) {
  PathWorker worker(shared_walks_graph(), patient());
  worker.start(straight_path(400));
  worker.forget();
  EXPECT_FALSE(worker.working());
  EXPECT_EQ(worker.news(), nullptr);
}

TEST(PathWorker, EndsInTheMiddleOfASearch) {
  for (const bool has_begun : {false, true}) {
    PathWorker worker(shared_walks_graph(), patient());
    worker.start(straight_path(400));
    while (has_begun && worker.news() == nullptr) bench::rest();
  }
}

TEST(PathWorker, SaysThatNobodyWalksLikeThat) {
  PathWorker worker(shared_walks_graph(), {});
  worker.start(straight_path(2, "proud"));
  EXPECT_EQ(last_news(worker), nullptr);
  EXPECT_NE(worker.trouble().find("proud"), std::string::npos) << worker.trouble();
}

}  // namespace
}  // namespace promenade::app
