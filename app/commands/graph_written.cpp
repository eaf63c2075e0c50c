// A walk along a motion graph as files and as words.
#include <fmt/format.h>

#include "analysis/pictures/way_picture.h"
#include "app/commands/graph_parts.h"
#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/take_clip.h"

namespace promenade::app {
namespace {

Json place_json(const motion::MotionGraph& graph, int number) {
  const motion::GraphNode& node = graph.node(number);
  const motion::Take& take = graph.take(node.take).take;
  return {{"file", take.source}, {"frame", take.first_frame + node.frame}};
}

Json edge_json(const motion::MotionGraph& graph, const motion::GraphEdge& edge) {
  Json json = {{"from", place_json(graph, edge.from)},
               {"to", place_json(graph, edge.to)},
               {"frames", edge.frames},
               {"transition", edge.transition >= 0}};
  if (edge.transition < 0) return json;
  const auto& transition = graph.transition(edge.transition);
  json["rms_m"] = transition.rms_m;
  json["slide_m"] = transition.quality.slide_m;
  return json;
}

int transitions_of(const motion::MotionGraph& graph, const motion::GraphWalk& walk) {
  int count = 0;
  for (const int e : walk.edges) {
    if (graph.edge(e).transition >= 0) ++count;
  }
  return count;
}

}  // namespace

void write_walk(const WrittenWalk& written, const std::string& out, const std::string& picture) {
  const motion::Take take = motion::walk_take(written.graph, written.walk);
  const std::string svg =
      picture.empty() ? std::string()
                      : analysis::way_picture(
                            {written.title, written.note, written.wanted, motion::pelvis_way(take),
                             motion::labelled_parts(written.graph, written.walk.edges)},
                            written.graph);
  write_file(out, motion::bvh_text(motion::take_clip(take)));
  if (!picture.empty()) write_file(picture, svg);
}

Json walk_json(const motion::MotionGraph& graph, const motion::GraphWalk& walk) {
  const int frames = motion::walk_frames(graph, walk.edges);
  Json parts = Json::array(), edges = Json::array();
  for (const motion::LabelledPart& part : motion::labelled_parts(graph, walk.edges)) {
    parts.push_back({{"label", part.label}, {"from", part.from}, {"to", part.to}});
  }
  for (const int e : walk.edges) {
    edges.push_back(edge_json(graph, graph.edge(e)));
  }
  return {{"graph", graph.name},
          {"frames", frames},
          {"frame_time", graph.frame_time},
          {"seconds", (frames - 1) * graph.frame_time},
          {"transitions", transitions_of(graph, walk)},
          {"parts", parts},
          {"edges", edges}};
}

std::string walk_text(const motion::MotionGraph& graph, const motion::GraphWalk& walk,
                      const std::string& out) {
  const int frames = motion::walk_frames(graph, walk.edges);
  std::string text =
      fmt::format("{}: {:.2f} s, {} frames, {} transitions\n", out, (frames - 1) * graph.frame_time,
                  frames, transitions_of(graph, walk));
  for (const motion::LabelledPart& part : motion::labelled_parts(graph, walk.edges)) {
    text += fmt::format("  {:7.2f} s  {}\n", part.from * graph.frame_time, part.label);
  }
  return text;
}

}  // namespace promenade::app
