#include "app/commands/graph_table.h"

#include "study/csv.h"

namespace promenade::app {
namespace {

using motion::BuiltGraph;
using motion::GraphTake;

struct Row {
  int from_take = 0, to_take = 0;
  motion::TransitionFrames frames;
  double rms_m = 0;
  const motion::TransitionQuality& quality;
  std::string refused;
};

std::string line_of(const BuiltGraph& built, const Row& row) {
  const GraphTake& from = built.graph.take(row.from_take);
  const GraphTake& to = built.graph.take(row.to_take);
  std::vector<std::string> cells = {
      from.take.source, from.label, std::to_string(from.take.first_frame + row.frames.i),
      to.take.source,   to.label,   std::to_string(to.take.first_frame + row.frames.j)};
  const motion::TransitionQuality& q = row.quality;
  for (const double value : {row.rms_m, q.slide_m, q.slide_raw_m, q.gap_m, q.inside_gap_m,
                             q.knee_gap, q.inside_knee_gap, q.moved_m}) {
    cells.push_back(study::csv_number(value));
  }
  cells.push_back(row.refused);
  return study::csv_line(cells);
}

}  // namespace

std::string transitions_csv(const BuiltGraph& built) {
  const motion::MotionGraph& graph = built.graph;
  std::string text =
      study::csv_line({"from_file", "from_label", "from_frame", "to_file", "to_label", "to_frame",
                       "rms_m", "slide_m", "slide_before_cleaning_m", "gap_m", "inside_gap_m",
                       "knee_gap_rad", "inside_knee_gap_rad", "moved_m", "refused"});
  const auto take = [&](int node) { return graph.node(node).take; };
  for (const motion::GraphEdge& edge : graph.edges) {
    if (edge.transition < 0) continue;
    const auto& one = graph.transition(edge.transition);
    text +=
        line_of(built, {take(edge.from), take(edge.to), one.frames, one.rms_m, one.quality, ""});
  }
  for (const motion::RefusedTransition& one : built.refusals) {
    text += line_of(built,
                    {one.from_take, one.to_take, one.frames, one.rms_m, one.quality, one.reason});
  }
  return text;
}

}  // namespace promenade::app
