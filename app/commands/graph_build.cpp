// `promenade graph build`: from captures to a motion graph.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "analysis/format.h"
#include "analysis/pictures/distance_picture.h"
#include "analysis/pictures/graph_picture.h"
#include "app/commands/graph_parts.h"
#include "app/commands/graph_sources.h"
#include "app/commands/graph_table.h"
#include "app/print.h"
#include "motion/decimal.h"
#include "motion/did_you_mean.h"
#include "motion/files.h"
#include "motion/graph/graph_file.h"

namespace promenade::app {
namespace {

struct Arguments {
  GraphSources sources;
  motion::MatchOptions match;
  std::vector<std::string> between;  // "sad,happy=0.04"
  std::vector<std::string> labels;
  std::string out, pictures, table;
  bool json = false;
};

motion::LabelThreshold threshold_between(const std::string& text) {
  const std::size_t comma = text.find(','), equals = text.rfind('=');
  if (comma != std::string::npos && equals != std::string::npos && comma < equals) {
    const motion::ScannedNumber number =
        motion::to_number(std::string_view(text).substr(equals + 1));
    if (!number.trouble && number.value > 0) {
      return {text.substr(0, comma), text.substr(comma + 1, equals - comma - 1), number.value};
    }
  }
  throw InputError("--between", "'" + text +
                                    "' is no threshold between two labels; it is wanted as in "
                                    "sad,happy=0.04 (metres)");
}

motion::BuiltGraph built_graph(NamedGraphTakes named, const Arguments& given) {
  motion::MatchOptions options = given.match;
  std::vector<std::string> mentioned;
  for (const std::string& text : given.between) {
    options.labels.push_back(threshold_between(text));
    mentioned.insert(mentioned.end(), {options.labels.back().from, options.labels.back().to});
  }
  const std::vector<std::string> known = motion::labels_of(named.takes);
  check_labels("--between", mentioned, known);
  check_labels("--labels", given.labels, known);
  if (!given.labels.empty()) {
    std::erase_if(named.takes, [&](const motion::GraphTake& one) {
      return std::find(given.labels.begin(), given.labels.end(), one.label) == given.labels.end();
    });
  }
  motion::BuiltGraph built = motion::build_graph(
      std::move(named.takes), options, [](const std::string& what, double share) {
        show_progress(what + ", %", static_cast<int>(100 * share), 100);
        return !interrupted();
      });
  built.graph.name = named.name;
  return built;
}

double largest(const motion::MotionGraph& graph, double motion::TransitionQuality::*value) {
  double most = 0;
  for (const auto& transition : graph.transitions) most = std::max(most, transition.quality.*value);
  return most;
}

Json takes_json(const motion::MotionGraph& graph) {
  Json takes = Json::array();
  for (const motion::GraphTake& one : graph.takes) {
    takes.push_back({{"file", one.take.source},
                     {"label", one.label},
                     {"frames", one.take.frames()},
                     {"first_frame", one.take.first_frame},
                     {"sha256", one.sha256.empty() ? Json() : Json(one.sha256)}});
  }
  return takes;
}

Json refusals_json(const motion::BuiltGraph& built) {
  Json list = Json::array();
  const auto source = [&](int take) { return built.graph.take(take).take.source; };
  for (const motion::RefusedTransition& one : built.refusals) {
    list.push_back({{"from", source(one.from_take)},
                    {"frame", one.frames.i},
                    {"to", source(one.to_take)},
                    {"to_frame", one.frames.j},
                    {"rms_m", one.rms_m},
                    {"reason", one.reason}});
  }
  return list;
}

Json graph_json(const motion::BuiltGraph& built) {
  const motion::MotionGraph& graph = built.graph;
  const motion::GraphStatistics& s = built.statistics;
  using Quality = motion::TransitionQuality;
  return {{"name", graph.name},
          {"frame_time", graph.frame_time},
          {"window", graph.window},
          {"threshold_m", graph.threshold_m},
          {"takes", takes_json(graph)},
          {"frames", s.frames},
          {"minima", s.minima},
          {"matches", s.matches},
          {"refused", s.refused},
          {"nodes_before_pruning", s.nodes_cut},
          {"edges_before_pruning", s.edges_cut},
          {"nodes", s.nodes},
          {"edges", s.edges},
          {"transitions", s.transitions},
          {"seconds", s.frames * graph.frame_time},
          {"seconds_kept", s.seconds_kept},
          {"labels_lost", s.lost},
          {"largest",
           {{"slide_m", largest(graph, &Quality::slide_m)},
            {"slide_before_cleaning_m", largest(graph, &Quality::slide_raw_m)},
            {"gap_m", largest(graph, &Quality::gap_m)},
            {"knee_gap", largest(graph, &Quality::knee_gap)},
            {"moved_m", largest(graph, &Quality::moved_m)}}},
          {"refusals", refusals_json(built)}};
}

std::string graph_text(const motion::BuiltGraph& built, const std::string& out) {
  const motion::MotionGraph& graph = built.graph;
  const motion::GraphStatistics& s = built.statistics;
  std::string text = fmt::format(
      "{}: {} takes, {:.1f} s\n"
      "{} places where frames are alike (RMS below {:.4f} m, windows of {} frames)\n"
      "{} transitions of {} can be used, {} are left after pruning\n"
      "{} nodes, {} edges; walks can show {:.1f} s of it\n",
      out, graph.takes.size(), s.frames * graph.frame_time, s.matches, graph.threshold_m,
      graph.window, 2 * s.matches - s.refused, 2 * s.matches, s.transitions, s.nodes, s.edges,
      s.seconds_kept);
  if (!s.lost.empty()) {
    text += "no walk comes by: " + analysis::listed(s.lost) +
            " (a higher threshold would let them in)\n";
  }
  return text;
}

void build(const Arguments& given) {
  check_outputs({given.out, given.table}, given.sources.names);
  NamedGraphTakes named = load_graph_sources(given.sources);
  print_problems(named.warnings);
  const motion::BuiltGraph built = built_graph(std::move(named), given);
  if (!built.trouble.empty()) throw InputError(given.sources.names.front(), built.trouble);
  std::vector<NamedBytes> pictures;
  if (!given.pictures.empty()) {
    pictures = {
        {"distances.svg", analysis::distance_picture(built, analysis::distances_of(built.graph))},
        {"graph.svg", analysis::graph_picture(built)}};
  }
  write_file(given.out, motion::to_bytes(built.graph));
  if (!given.pictures.empty()) write_files(given.pictures, pictures);
  if (!given.table.empty()) write_file(given.table, transitions_csv(built));
  if (given.json) return print_json(graph_json(built));
  print_text(graph_text(built, given.out));
}

}  // namespace

void add_graph_build(Command graph_command) {
  Command command = graph_command.add_subcommand(
      "build", "Find where captures are alike and join them there by transitions");
  const auto given = std::make_shared<Arguments>();
  motion::MatchOptions& match = given->match;
  command
      .add_option("files", given->sources.names,
                  "Captures (.bvh, .amc), also as LABEL=FILE; or one recipe (.toml); or one "
                  "motion set (a file, builtin:A, B or N)")
      .required();
  command.add_option("--out", given->out, "The graph to write").required();
  command.add_option("--folder", given->sources.folder,
                     "Where a recipe's captures lie, if not where it says");
  command.add_option("--rate", given->sources.rate, "Frames a second; else that of the captures")
      .range(5.0, 1000.0);
  Option threshold = command.add_option("--threshold", match.threshold_m,
                                        "How far apart windows may be, metres (RMS over joints)");
  threshold.positive().capture_default_str();
  command
      .add_option("--best", match.quantile,
                  "Instead of a threshold: the best share of all places, 0 to 1")
      .range(0.0, 1.0)
      .excludes(threshold);
  command
      .add_option("--between", given->between,
                  "A threshold between two labels, A,B=METRES; can be given again")
      .one_at_a_time();
  command.add_option("--labels", given->labels, "Use takes of these labels only").delimiter(',');
  command.add_option("--window", match.window_s, "Length of windows and transitions, seconds")
      .range(0.05, 5.0)
      .capture_default_str();
  command.add_flag("--tapered", match.tapered, "Frames in the middle of a window count more");
  command.add_option("--pictures", given->pictures, "A folder for pictures (SVG) of the graph");
  command.add_option(
      "--table", given->table,
      "A table (.csv) of every transition: how alike, how its feet slide, how smooth");
  command.add_flag("--json", given->json, "One JSON document on stdout");
  command.callback([given] { build(*given); });
}

}  // namespace promenade::app
