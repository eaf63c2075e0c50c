// `promenade model map`: where cycles lie on the minimap, what a point of it is, pictures.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "analysis/pictures/map_picture.h"
#include "app/commands/model_parts.h"
#include "app/commands/numbers.h"
#include "app/print.h"
#include "motion/distance.h"
#include "motion/models/ward.h"
#include "study/rng.h"
#include "study/study.h"

namespace promenade::app {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

struct Arguments {
  std::string set, at, picture, heuristics;
  bool json = false, csv = false, mahalanobis = false;
  int clusters = 0, components = 0, nearest = 0;  // 0: the usual
  double confidence = 0.95;
  std::uint64_t seed = 1;
};

// The set, its map and its clusters.
struct Mapped {
  motion::MotionSpace space;
  motion::Pca pca;
  motion::Minimap map;
  std::vector<int> clusters;
};

constexpr int usual_clusters = 3, usual_nearest = 5;

// What the set cannot have is not quietly made less.
void refuse_too_many(const Arguments& given, int cycles, int components) {
  std::vector<Problem> problems;
  const auto check = [&](const char* option, int asked, int most, const char* of) {
    if (asked <= most) return;
    problems.push_back({option, 0, 0,
                        fmt::format("is {}, but {} has only {} {}", asked, given.set, most, of),
                        Severity::error});
  };
  check("--components", given.components, components, "components");
  check("--clusters", given.clusters, cycles, "cycles");
  check("--nearest", given.nearest, cycles, "cycles");
  if (!problems.empty()) throw InputError(problems);
}

Mapped make_map(const Arguments& given) {
  Mapped mapped;
  mapped.space = motion::make_motion_space(study::load_motion_set(given.set, ""));
  mapped.pca = motion::principal_components(mapped.space);
  if (mapped.pca.components() == 0)
    throw InputError(given.set, "all its cycles are alike; a map needs two that differ");
  const int cycles = mapped.space.set.size();
  refuse_too_many(given, cycles, mapped.pca.components());
  motion::MapOptions options;
  options.components = given.components;
  options.nearest = given.nearest > 0 ? given.nearest : usual_nearest;
  options.confidence = given.confidence;
  if (given.mahalanobis) options.metric = motion::MapMetric::mahalanobis;
  mapped.map = motion::make_minimap(mapped.pca, options);
  const int clusters = given.clusters > 0 ? given.clusters : std::min(usual_clusters, cycles);
  mapped.clusters = motion::cut(motion::ward(mapped.map.examples), clusters);
  return mapped;
}

struct MapPoint {
  std::string heuristic;
  Vector2d point;  // where the cursor was pulled back to
  VectorXd weights;
  double nearest_m = 0;  // D to the nearest example
  int nearest = 0;       // which one
};

MapPoint point_of(const Mapped& mapped, const std::string& name, motion::MapHeuristic heuristic,
                  const Vector2d& at, std::uint64_t seed) {
  motion::MapOptions options = mapped.map.options;
  options.heuristic = heuristic;
  options.glide_s = 0;  // long after the move
  const motion::Minimap map = motion::make_minimap(mapped.pca, options);
  study::Rng rng(seed, 0, "map");
  const motion::MapState state =
      motion::move(map, motion::start_map(map), {at, true, 0}, [&rng] { return rng.normal(); });
  MapPoint point{name, state.point, {}, INFINITY, 0};
  motion::weights_at(map, state, 0, point.weights);
  const motion::MotionSet& set = mapped.space.set;
  const motion::DistancePoints shown =
      motion::distance_points(set, motion::blend(mapped.space, point.weights));
  for (int i = 0; i < set.size(); ++i) {
    const motion::Cycle& example = set.cycles[static_cast<std::size_t>(i)];
    const double d = motion::distance(shown, motion::distance_points(set, example)).mean_m;
    if (d >= point.nearest_m) continue;
    point.nearest_m = d;
    point.nearest = i;
  }
  return point;
}

// One map point under each heuristic; the random one from the seed.
std::vector<MapPoint> points_of(const Mapped& mapped, const Arguments& given) {
  const VectorXd at = parse_numbers("--at", given.at);
  if (at.size() != 2) throw InputError("--at", "a map point has two numbers, x,y");
  std::vector<MapPoint> points;
  const std::pair<const char*, motion::MapHeuristic> heuristics[] = {
      {"zero", motion::MapHeuristic::zero},
      {"closest", motion::MapHeuristic::closest},
      {"weights", motion::MapHeuristic::weights},
      {"random", motion::MapHeuristic::random}};
  for (const auto& [name, heuristic] : heuristics) {
    points.push_back(point_of(mapped, name, heuristic, at, given.seed));
  }
  return points;
}

const std::string& name_of(const Mapped& mapped, int cycle) {
  return mapped.space.set.cycles[static_cast<std::size_t>(cycle)].name;
}

analysis::MapPicture picture_of(const Mapped& mapped) {
  analysis::MapPicture picture;
  for (const motion::Cycle& cycle : mapped.space.set.cycles) picture.names.push_back(cycle.name);
  picture.title =
      fmt::format("Motion set {}: {} walks on the map of their first two principal components",
                  mapped.space.set.name, mapped.space.set.size());
  picture.clusters = mapped.clusters;
  picture.map = mapped.map;
  return picture;
}

void draw_strips(const Mapped& mapped, const std::vector<MapPoint>& points,
                 const Arguments& given) {
  analysis::MapPicture picture = picture_of(mapped);
  picture.title =
      fmt::format("Motion set {}: the red point under each heuristic", mapped.space.set.name);
  std::vector<analysis::HeuristicStrip> strips;
  for (const MapPoint& point : points) {
    const std::vector<std::string> notes = {
        fmt::format("D = {:.1f} cm from", 100 * point.nearest_m), "the nearest walk,",
        name_of(mapped, point.nearest)};
    strips.push_back({point.heuristic, notes, point.weights});
  }
  const VectorXd at = parse_numbers("--at", given.at);
  analysis::draw_heuristics(picture, mapped.space, at, strips, given.heuristics);
}

Json points_json(const Mapped& mapped, const std::vector<MapPoint>& points,
                 const Arguments& given) {
  Json json = {{"at", to_list(parse_numbers("--at", given.at))}, {"seed", given.seed}};
  for (const MapPoint& point : points) {
    json[point.heuristic] = {{"point", {point.point.x(), point.point.y()}},
                             {"weights", to_list(point.weights)},
                             {"nearest_example", name_of(mapped, point.nearest)},
                             {"d_nearest_example", point.nearest_m}};
  }
  return json;
}

Json examples_json(const Mapped& mapped) {
  Json examples = Json::array();
  for (int i = 0; i < mapped.space.set.size(); ++i) {
    const motion::Cycle& cycle = mapped.space.set.cycles[static_cast<std::size_t>(i)];
    examples.push_back({{"name", cycle.name},
                        {"style", cycle.style},
                        {"x", mapped.map.examples(0, i)},
                        {"y", mapped.map.examples(1, i)},
                        {"cluster", mapped.clusters[static_cast<std::size_t>(i)]},
                        {"coordinates", to_list(mapped.pca.coordinates.col(i))}});
  }
  return examples;
}

std::string map_csv(const Mapped& mapped) {
  std::string text = "name,x,y,cluster\n";
  for (int i = 0; i < mapped.space.set.size(); ++i) {
    text += fmt::format("{},{},{},{}\n", csv_cell(name_of(mapped, i)), mapped.map.examples(0, i),
                        mapped.map.examples(1, i), mapped.clusters[static_cast<std::size_t>(i)]);
  }
  return text;
}

Json map_json(const Mapped& mapped) {
  const bool mahalanobis = mapped.map.options.metric == motion::MapMetric::mahalanobis;
  return {{"set", mapped.space.set.name},
          {"metric", mahalanobis ? "mahalanobis" : "euclidean"},
          {"components", mapped.map.components()},
          {"variances", to_list(mapped.pca.variances)},
          {"explained", to_list(mapped.pca.variances / mapped.pca.total_variance)},
          {"point_limit", mapped.map.point_limit},
          {"rest_limit", mapped.map.rest_limit},
          {"examples", examples_json(mapped)}};
}

void show(const Arguments& given) {
  if (!given.heuristics.empty() && given.at.empty())
    throw InputError("--heuristics", "needs the point that it shows: --at x,y");
  const Mapped mapped = make_map(given);
  std::vector<MapPoint> points;
  if (!given.at.empty()) points = points_of(mapped, given);
  if (!given.picture.empty()) analysis::draw_map(picture_of(mapped), given.picture);
  if (!given.heuristics.empty()) draw_strips(mapped, points, given);
  const bool drawn = !given.picture.empty() || !given.heuristics.empty();
  if (drawn && !given.json && !given.csv) return;
  if (given.csv) return print_text(map_csv(mapped));
  Json document = map_json(mapped);
  if (!points.empty()) document["point"] = points_json(mapped, points, given);
  print_json(document);
}

}  // namespace

void add_model_map(Command model) {
  Command command =
      model.add_subcommand("map", "Where the cycles lie on the minimap, and pictures");
  const auto given = std::make_shared<Arguments>();
  command.add_option("set", given->set, "A file, or builtin:A, B or N").required();
  command.add_option("--at", given->at, "x,y: this point under each heuristic");
  command.add_option("--picture", given->picture, "FILE.svg, .pdf or .png: the map");
  command.add_option("--heuristics", given->heuristics,
                     "FILE.svg, .pdf or .png: the point of --at under each heuristic");
  command.add_option("--clusters", given->clusters, "Clusters of the dots (Ward); 3 if not given")
      .range(1, 1000);
  command.add_option("--components", given->components, "K; 0: ceil(0.7 (N - 1))").range(0, 10000);
  command
      .add_option("--nearest", given->nearest, "k of the heuristic weights, 5 if not given; N: all")
      .range(1, 10000);
  command.add_option("--confidence", given->confidence, "Of the bounds of validity, 0 to 1")
      .range(0.01, 0.9999);
  command.add_option("--seed", given->seed, "Of the heuristic random");
  command.add_flag("--mahalanobis", given->mahalanobis, "Axes in standard deviations");
  command.add_flag("--csv", given->csv, "Rows of name, x, y, cluster");
  command.add_flag("--json", given->json, "One JSON document (as without it)").excludes("--csv");
  command.callback([given] { show(*given); });
}

}  // namespace promenade::app
