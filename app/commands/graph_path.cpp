// `promenade graph path`: a walk along a motion graph that follows a path over the ground.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/commands/graph_parts.h"
#include "app/path_window.h"
#include "motion/did_you_mean.h"
#include "motion/files.h"
#include "motion/graph/graph_labels.h"
#include "motion/graph/path_walk.h"
#include "study/path_csv.h"

namespace promenade::app {
namespace {

struct Arguments {
  std::string graph, path, out, picture;
  motion::PathWalkOptions options;
  bool smooth = false, json = false, window = false;
};

std::string note_of(const motion::PathWalk& found, const motion::GroundPath& path) {
  return fmt::format(
      "{:.1f} m wanted, {:.1f} m walked; {:.2f} m from it on the average (RMS), {:.2f} m at most",
      path.length(), found.walked_m, found.rms_m, found.farthest_m);
}

Json path_json(const motion::MotionGraph& graph, const motion::PathWalk& found,
               const motion::GroundPath& path) {
  Json json = walk_json(graph, found.walk);
  json["path_m"] = path.length();
  json["walked_m"] = found.walked_m;
  json["frames_on_path"] = found.frames;
  json["cost_m2"] = found.cost_m2;
  json["rms_m"] = found.rms_m;
  json["farthest_m"] = found.farthest_m;
  json["frames_of_other_labels"] = found.other_label;
  json["complete"] = found.complete;
  json["stopped"] = found.stopped;
  json["edges_visited"] = found.visited;
  return json;
}

void check_start(const Arguments& given, const motion::MotionGraph& graph) {
  if (given.options.start_label.empty()) return;
  check_labels("--start", {given.options.start_label}, motion::edge_labels(graph));
}

// All labels that are not those of the graph, at their places.
void check_path_labels(const study::PathTable& table, const std::string& file,
                       const motion::MotionGraph& graph) {
  const std::vector<std::string> known = motion::edge_labels(graph);
  std::vector<Problem> problems;
  for (std::size_t p = 0; p < table.labels.size(); ++p) {
    const std::string& label = table.labels[p];
    if (label.empty() || std::find(known.begin(), known.end(), label) != known.end()) continue;
    problems.push_back({file, table.places[p].line, table.places[p].column,
                        "the graph has no label \"" + label + "\"" + did_you_mean(label, known) +
                            "; it has " + quoted_list(known),
                        Severity::error});
  }
  if (!problems.empty()) throw InputError(problems);
}

study::PathTable read_path(const Arguments& given, const motion::MotionGraph& graph) {
  study::PathTable table = study::parse_path(read_file(given.path), given.path);
  if (const auto trouble = motion::trouble_with_path(table.points)) {
    throw InputError(given.path, *trouble);
  }
  check_path_labels(table, given.path, graph);
  return table;
}

WantedPath wanted_path(const Arguments& given, const study::PathTable& table) {
  const PathDrawing drawing(table);
  if (drawing.corners().size() < 2) {
    throw InputError(given.path, "all points of the path lie in one place");
  }
  return path_through(drawing.corners(), given.smooth ? WayThrough::smooth : WayThrough::straight);
}

void follow(const Arguments& given) {
  check_outputs({given.out, given.picture}, {given.graph, given.path});
  const motion::MotionGraph graph = load_graph(given.graph);
  const WantedPath wanted = wanted_path(given, read_path(given, graph));
  check_start(given, graph);
  motion::PathWalkOptions options = given.options;
  options.parts = wanted.parts;
  const motion::GroundPath path(wanted.points, given.path);
  const motion::PathWalk found =
      motion::walk_along(graph, path, options, [](const motion::GraphWalk&, double share) {
        show_progress("walking along the path, %", static_cast<int>(100 * share), 100);
        return !interrupted();
      });
  if (found.walk.edges.empty()) {
    throw OutsideError("stopped before any of the path was walked; nothing is written");
  }
  const std::string note = note_of(found, path);
  write_walk({graph, found.walk, "A walk along a path, out of " + graph.name, note, path.corners()},
             given.out, given.picture);
  if (found.stopped) print_note("stopped; the walk so far is written");
  if (given.json) return print_json(path_json(graph, found, path));
  print_text(walk_text(graph, found.walk, given.out) + note + "\n" +
             (found.complete
                  ? "nothing better within any horizon\n"
                  : "the best of many walks; that there is no better one is not proved\n"));
}

// Everything that is wrong is said before the window opens.
void draw(const Arguments& given) {
  PathWindowSetting setting;
  setting.graph = std::make_shared<const motion::MotionGraph>(load_graph(given.graph));
  setting.options = given.options;
  setting.out = given.out;
  check_start(given, *setting.graph);
  if (!given.path.empty()) setting.drawing = PathDrawing(read_path(given, *setting.graph));
  draw_path_in_window(setting);
}

void run(const Arguments& given) {
  if (given.window) return draw(given);
  if (given.path.empty()) throw InputError("--path", "is needed; or draw a path with --window");
  if (given.out.empty()) throw InputError("--out", "is needed: the capture to write (.bvh)");
  follow(given);
}

}  // namespace

void add_graph_path(Command graph_command) {
  Command command = graph_command.add_subcommand(
      "path", "A walk along a motion graph that follows a path over the ground");
  const auto given = std::make_shared<Arguments>();
  motion::PathWalkOptions& options = given->options;
  command.add_option("graph", given->graph, "A file that `graph build` wrote").required();
  command.add_option("--path", given->path,
                     "Its points: a table (.csv) with columns x and z in metres, and label where a "
                     "style is wanted from there on");
  command.add_option("--out", given->out, "The capture to write (.bvh)");
  command.add_flag("--smooth", given->smooth, "Walk a smooth curve through the points");
  command.add_option("--start", options.start_label, "The label to begin with");
  command.add_option("--horizon", options.horizon_s, "How far the search looks ahead, seconds")
      .range(0.2, 60.0)
      .capture_default_str();
  command.add_option("--keep", options.kept_s, "How much of it is kept, seconds")
      .range(0.1, 60.0)
      .capture_default_str();
  command
      .add_option("--most-edges", options.most_edges,
                  "Edges to look at within a horizon before the best so far is taken")
      .range(std::int64_t{1}, std::int64_t{10'000'000'000})
      .capture_default_str();
  command.add_option("--picture", given->picture,
                     "A picture (.svg) of the path and of the way that is walked");
  command.add_flag("--json", given->json, "One JSON document on stdout");
  command
      .add_flag("--window", given->window,
                "A window to draw a path with the mouse, and to save the walk to --out")
      .excludes("--json")
      .excludes("--smooth")
      .excludes("--picture");
  command.callback([given] { run(*given); });
}

}  // namespace promenade::app
