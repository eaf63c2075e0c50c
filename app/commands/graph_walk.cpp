// `promenade graph walk`: a walk along a motion graph as a capture.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/commands/graph_parts.h"
#include "app/print.h"
#include "motion/decimal.h"
#include "motion/graph/graph_labels.h"
#include "motion/graph/label_walk.h"

namespace promenade::app {
namespace {

struct Arguments {
  std::string graph, out, picture;
  double seconds = 10;
  std::vector<std::string> show;    // "happy=4"
  std::vector<std::string> labels;  // that walks may show
  std::uint64_t seed = 1;
  bool json = false;
};

motion::WantedLabel wanted_label(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals != std::string::npos && equals > 0) {
    const motion::ScannedNumber seconds =
        motion::to_number(std::string_view(text).substr(equals + 1));
    if (!seconds.trouble && seconds.value >= 0.1 && seconds.value <= most_walk_seconds) {
      return {text.substr(0, equals), seconds.value};
    }
  }
  throw InputError("--show", "'" + text +
                                 "' does not say a label and its seconds; they are wanted as in "
                                 "happy=4,sad=4, at least 0.1");
}

motion::MotionGraph graph_with(const Arguments& given) {
  motion::MotionGraph graph = load_graph(given.graph);
  check_labels("--labels", given.labels, motion::edge_labels(graph));
  if (given.labels.empty()) return graph;
  graph = motion::part_with_labels(graph, given.labels);
  if (graph.nodes.empty()) {
    throw InputError(given.graph, "has no walk that shows nothing but these labels");
  }
  return graph;
}

void walk(const Arguments& given) {
  check_outputs({given.out, given.picture}, {given.graph});
  const motion::MotionGraph graph = graph_with(given);
  motion::LabelWalk found;
  if (given.show.empty()) {
    const int frames = static_cast<int>(std::ceil(given.seconds / graph.frame_time)) + 1;
    found.edges = motion::random_walk(graph, given.seed, frames);
  } else {
    std::vector<motion::WantedLabel> wanted;
    std::vector<std::string> labels;
    for (const std::string& text : given.show) {
      wanted.push_back(wanted_label(text));
      labels.push_back(wanted.back().label);
    }
    check_labels("--show", labels, motion::edge_labels(graph));
    found = motion::walk_through_labels(graph, wanted, given.seed);
  }
  const motion::GraphWalk walk{found.edges, motion::start_at_origin(graph, found.edges)};
  const WrittenWalk written{graph, walk, "A walk along " + graph.name, {}};
  write_walk(written, given.out, given.picture);
  Json document = walk_json(graph, walk);
  if (!given.show.empty()) document["frames_of_other_labels"] = found.other_label;
  if (given.json) return print_json(document);
  print_text(walk_text(graph, walk, given.out));
}

}  // namespace

void add_graph_walk(Command graph_command) {
  Command command =
      graph_command.add_subcommand("walk", "A walk along a motion graph, as a capture (.bvh)");
  const auto given = std::make_shared<Arguments>();
  command.add_option("graph", given->graph, "A file that `graph build` wrote").required();
  command.add_option("--out", given->out, "The capture to write (.bvh)").required();
  Option seconds = command.add_option("--seconds", given->seconds, "How long it is, at least");
  seconds.range(0.1, most_walk_seconds).capture_default_str();
  command
      .add_option("--show", given->show,
                  "Labels one after the other, each with its seconds: happy=4,sad=4")
      .delimiter(',')
      .excludes(seconds);
  command.add_option("--labels", given->labels, "Labels that it may show; else all").delimiter(',');
  command.add_option("--seed", given->seed, "Which of the possible walks").capture_default_str();
  command.add_option("--picture", given->picture, "A picture (.svg) of its way over the ground");
  command.add_flag("--json", given->json, "One JSON document on stdout");
  command.callback([given] { walk(*given); });
}

}  // namespace promenade::app
